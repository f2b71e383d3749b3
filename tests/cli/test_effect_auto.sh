#!/usr/bin/env bash
# `effects: auto`: each view of a run is drawn with the set that `effects` plans for it; and configs that leave it no choice are refused.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
config() { # SCENES TECHNIQUES [LINE]
  cat <<YAML
name: auto
scenes: [$1]
resolutions: [64x36]
backends: [gl-egl]
effects: auto
techniques: [$2]
measure: {seconds: 0.02}
reference: {spp: 32}
${3:-}
YAML
}
config '{name: matte_white_room}, {name: open_sky}' '{name: gtao, params: {radius: 0.6}}' >two.yaml
check "a run" "$program" run two.yaml --out two --quiet
check "a case a view" test "$(wc -l <two/journal.jsonl)" = 2
effects='def has($o): .options[$o] == "on"; (if .technique == "none" then [] else ["visibility"] end)
  + (if has("visibility_rgb") then ["multi_bounce"] else [] end) + (if has("bent_normal") then ["bent_normal"] else [] end)
  + (if has("irradiance") then ["directional"] else [] end) + (if has("specular") then ["specular"] else [] end)
  + (if .params.divisor == 2 then ["half_size"] else [] end)'
of() { jq -s -c "map(select(.scene == \"$1\"))[0] | $2" two/journal.jsonl; }
for scene in matte_white_room open_sky; do
  check "a plan of $scene" "$program" effects $scene --size 64x36 --backend gl-egl --radius 0.6 --json plan.json
  check "the run draws what is planned for $scene" test "$(of $scene "$effects")" = "$(jq -c .chosen.effects plan.json)"
  check "the lit image of $scene" test "$(of $scene '.options.lit')" = '"on"'
done
check "the views differ" test "$(of matte_white_room "$effects")" != "$(of open_sky "$effects")"
check "what is fixed stays" test "$(of matte_white_room .params.radius) $(of matte_white_room .reference_radius)" = "0.6 0.600000024"
"$program" run two.yaml --out two >told 2>&1
check "it goes on where it stopped" test "$(wc -l <two/journal.jsonl)" = 2
check "what a view calls for is told" grep -q 'open_sky/up 64x36 gl-egl calls for nothing' told
config '{name: open_sky}' '{name: gtao}, {name: hbao}, {name: none}' >others.yaml
check "beside others" "$program" run others.yaml --out others --quiet
check "these are drawn as they stand" test "$(jq -s -c '[.[] | .technique] | sort' others/journal.jsonl)" = '["hbao","none"]'
# The entry of gtao alone says where it is: `none` is drawn there too, where the config names it elsewhere as well.
config '{name: open_sky}' '{name: gtao, backends: [gl-egl]}' >own.yaml
sed -i '/^backends/d' own.yaml
check "gtao's own backends" "$program" run own.yaml --out own --quiet
check "nothing is called for, and drawn there" test "$(jq -c '[.technique, .backend]' own/journal.jsonl)" = '["none","gl-egl"]'
config '{name: open_sky}' '{name: gtao, backends: [gl-egl]}, {name: none, backends: [gl-osmesa]}' >apart.yaml
check "none has other backends" "$program" run apart.yaml --out apart --quiet
check "it is drawn on both" test "$(jq -s -c '[.[] | [.technique, .backend]] | sort' apart/journal.jsonl)" = '[["none","gl-egl"],["none","gl-osmesa"]]'
# What draws nothing is no view of gtao, so nothing is planned there.
config '{name: open_sky}' '{name: gtao}, {name: hbao, backends: ["null"]}' >null.yaml
check "hbao on a backend that draws nothing" "$program" run null.yaml --out null --quiet
check "both are there" test "$(jq -s -c '[.[] | [.technique, .backend]] | sort' null/journal.jsonl)" = '[["hbao","null"],["none","gl-egl"]]'
# A device that is missing leaves its views to the run.
config '{name: open_sky}' '{name: gtao, backends: [gl-egl, vulkan]}' >missing.yaml
code=0
VK_ICD_FILENAMES=/nowhere.json VK_DRIVER_FILES=/nowhere.json "$program" run missing.yaml --out missing >told 2>&1 || code=$?
check "a device is missing: code 3" test $code = 3
check "the other views are planned" test "$(jq -s -c '[.[] | [.technique, .backend, .status]] | sort' missing/journal.jsonl)" = '[["gtao","vulkan","unsupported"],["none","gl-egl","ok"]]'
check "it is told" grep -q 'open_sky/up on vulkan is not planned: ' told

expect 2 "two.yaml:5:10: effects: auto is for \`aobudget run\` alone" "$program" plan two.yaml
config '{name: corner}' '{name: hbao}' >none.yaml
expect 2 "none.yaml:5:10: effects: auto needs one entry of gtao, and there are 0" "$program" run none.yaml --quiet
config '{name: corner}' '{name: gtao, params: {radius: [0.5, 1]}}' >sweep.yaml
expect 2 "effects: auto takes one value of 'radius'" "$program" run sweep.yaml --quiet
config '{name: corner}' '{name: gtao}' 'options: {lit: off}' >lit.yaml
expect 2 "'lit' is given twice" "$program" run lit.yaml --quiet
sed 's/effects: auto/effects: all/' two.yaml >all.yaml
expect 2 "all.yaml:5:10: 'all' is not auto" "$program" run all.yaml --quiet
config '{capture: frame.exr, fov_deg: 50}' '{name: gtao}' >capture.yaml
expect 2 "effects: auto is for scenes: a capture has no lit image" "$program" run capture.yaml --quiet
finish
