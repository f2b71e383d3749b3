#!/usr/bin/env bash
# Materials of a capture: a scene's frame, read as one, is drawn as the scene is; without materials it is refused what needs them.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
shot=("$program" shot --technique gtao --backend gl-egl -p radius=0.5)
all=(-p lit=on -p visibility_rgb=on -p specular=on -p irradiance=on)
drawn=(technique.AO technique.visibility_rgb.{R,G,B} technique.specular technique.irradiance.{R,G,B} technique.lit.{R,G,B})
same() { "$AOBUDGET_BUILD/compare_images" "$@"; }
# Three views between them have coloured walls, polish and metal, and an orthographic camera.
round_trip() { # NAME FLAGS...
  local name=$1
  shift
  check "$name" "${shot[@]}" "$@" --size 64x36 --reference-spp 2 "${all[@]}" --light sky --out scene.exr
  check "$name as a capture" "${shot[@]}" --scene capture:scene.exr "${all[@]}" --light sky --out frame.exr --json frame.json
  check "its materials are the scene's" same scene.exr frame.exr albedo.{R,G,B} roughness metalness
  check "so is all that is drawn" same scene.exr frame.exr "${drawn[@]}"
  check "none of it has a truth" jq -e '.error.reference == "screen" and .error.lit_rmse == null and .error.visibility_rgb_rmse == null' frame.json
}
round_trip gallery --scene gallery --view ball
round_trip walls --scene coloured_walls
round_trip flat --scene gallery --eye 1,2,6 --target 0,1,0 --ortho 5
mean() { "$AOBUDGET_BUILD/image_moments" "$1" "$2" | cut -d' ' -f1; }
check "there is metal in it, and polish" awk "BEGIN { exit !($(mean frame.exr metalness) > 0.001 && $(mean frame.exr roughness) < 0.9) }"

# What the file lacks is named, with the option that needs it.
check "a scene without materials" "${shot[@]}" --scene corner --size 64x36 --reference-spp 0 --out plain.exr
on() { "${shot[@]}" --scene "capture:$1" -p "$2=on" "${@:3}"; }
expect 2 "plain.exr: visibility_rgb needs the base colour of the surfaces, and the file has no channels albedo.R .G .B: write them, name them by albedo_channel, or leave visibility_rgb off" on plain.exr visibility_rgb
expect 2 "plain.exr: specular needs the roughness of the surfaces, and the file has no channel roughness: write it, name it by roughness_channel, or leave specular off" on plain.exr specular
expect 2 "plain.exr: lit needs the base colour" on plain.exr lit
expect 2 "scene.exr: lit needs the base colour" on scene.exr lit --materials none
check "light needs no material" on plain.exr irradiance
expect 2 "scene.exr: albedo_channel: it has no channels 'paint' with .R .G .B" on scene.exr lit --albedo-channel paint
expect 2 "scene.exr: roughness_channel: it has no channel 'gloss'" on scene.exr lit --roughness-channel gloss
expect 2 "give metalness_channel or materials none, not both" on scene.exr lit --metalness-channel metalness --materials none
expect 2 "materials: 'some' is not one of file, none" on scene.exr lit --materials some
expect 2 "materials is stated of a capture" "${shot[@]}" --scene corner --materials none

# A channel may be named: here roughness stands for the metal too, and only what reads that changes.
check "named channels" on scene.exr lit --metalness-channel roughness --light sky --out named.exr
check "are read" same named.exr scene.exr roughness albedo.R
check "in place of those of the name" bash -c '! "$@"' - same named.exr scene.exr metalness
cat >config.yaml <<END
name: capture
scenes:
  - {capture: scene.exr, light: sky}
  - {capture: scene.exr, light: sky, metalness_channel: roughness}
  - {capture: scene.exr, light: sky, albedo_channel: albedo, roughness_channel: roughness, metalness_channel: metalness}
backends: [gl-egl]
options: {lit: on, visibility_rgb: on, specular: on, irradiance: on}
techniques: [{name: gtao, params: {radius: 0.5}}]
measure: {time: false}
END
check "a run" "$program" run config.yaml --out run --quiet
check "the materials count" test "$(jq -s 'map(.status)' -c run/journal.jsonl) $(jq -s 'map(.image_digest) | unique | length' run/journal.jsonl)" = '["ok","ok","ok"] 2'
sed -i 's/metalness_channel: roughness/materials: none/' config.yaml
expect 2 "config.yaml:7:16: capture:scene.exr: visibility_rgb needs the base colour" "$program" run config.yaml --out none --quiet
finish
