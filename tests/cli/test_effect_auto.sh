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
expect 2 "a plan of effects chooses 'lit' itself: leave it out" "$program" run lit.yaml --quiet
sed 's/effects: auto/effects: all/' two.yaml >all.yaml
expect 2 "all.yaml:5:10: 'all' is not auto" "$program" run all.yaml --quiet
# The radius that the config asks for is the target's, of the truth that the effects are judged by.
for radius in 0.1 0.6; do
  config '{name: matte_white_room}' '{name: gtao, params: {radius: 0.6}}' "target: {radius: $radius, weighting: uniform}" >radius.yaml
  check "a target of $radius" "$program" run radius.yaml --out "radius-$radius" --quiet
  sed -i '/^effects/d; s/{name: gtao, params: {radius: 0.6}}/{name: gtao, params: {radius: 0.6, divisor: [1, 2]}}, {name: none}/' radius.yaml
  cat radius.yaml <(echo 'options: {lit: [on], visibility_rgb: [off, on]}') >all.yaml
  "$program" run all.yaml --out "all-$radius" --quiet >/dev/null 2>&1 # `none` gives no bounces: 3
  least=$(jq -s '[.[] | select(.status == "ok") | .error.lit_rmse] | min' "all-$radius/journal.jsonl")
  none=$(jq -s '[.[] | select(.technique == "none" and .status == "ok") | .error.lit_rmse] | min' "all-$radius/journal.jsonl")
  taken=$(jq -r .technique "radius-$radius/journal.jsonl")
  wanted=$(awk "BEGIN { print $none <= $least + 0.02 ? \"none\" : \"gtao\" }")
  check "at $radius nothing is off by $none, the best by $least: $wanted is taken" test "$taken" = "$wanted"
  check "and compared at $radius" jq -e ".reference_radius - $radius | fabs < 1e-6" "radius-$radius/journal.jsonl"
done
check "the two radii call for other sets" test "$(jq -r .technique radius-0.1/journal.jsonl)$(jq -r .technique radius-0.6/journal.jsonl)" = nonegtao

# What is wrong with a call is said before anything is planned, and what the filter leaves out is not planned.
mkdir tmp
export TMPDIR=$folder/tmp
touch -d '2001-01-01' tmp
untouched() { test "$(stat -c %Y tmp)" = "$(date -d 2001-01-01 +%s)"; }
expect 2 "no case of two.yaml matches 'nix', whichever effects are chosen: give --filter a part of the name of a scene" "$program" run two.yaml --out nix --filter nix
expect 2 "two.yaml: it is not a folder" "$program" run two.yaml --out two.yaml --fresh
expect 2 "auto.json: " "$program" run two.yaml --out new --json nowhere/auto.json
expect 2 "radius-0.1 holds a run of another config" "$program" run two.yaml --out radius-0.1
check "nothing was planned for these" untouched
check "what was there stays" test "$(wc -l <radius-0.1/journal.jsonl)" = 1
"$program" run two.yaml --out one --filter open_sky >told 2>&1
check "of the views that it leaves one is planned" test "$(grep -c 'calls for' told) $(grep -c 'open_sky/up 64x36 gl-egl calls for nothing' told)" = "1 1"
check "and measured" test "$(jq -c '[.scene, .technique]' one/journal.jsonl)" = '["open_sky","none"]'
"$program" run two.yaml --out one >told 2>&1
check "without it the other one comes" test "$(jq -s -c 'map(.scene)' one/journal.jsonl)" = '["open_sky","matte_white_room"]'
check "as in a run of both" test "$(jq -s -c 'map(.key) | sort' one/journal.jsonl)" = "$(jq -s -c 'map(.key) | sort' two/journal.jsonl)"
"$program" run two.yaml --out one --filter open_sky --quiet
check "with it again both are still planned" test "$(jq -c '[.cases, (.keys | length)]' one/run.json)" = '[2,2]'
check "and on the page" test "$("$program" report one --json - --quiet | jq '.runs[0].planned // .planned')" = 2
touch -d '2001-01-01' tmp
check "nobody asks about gtao" "$program" run others.yaml --out hbao --filter hbao --quiet
check "so nothing is planned" untouched
check "hbao is there" test "$(jq -r .technique hbao/journal.jsonl)" = hbao
expect 2 "no case of others.yaml matches 'divisor=2', with the effects that are chosen" "$program" run others.yaml --out none --filter divisor=2 --quiet

# A capture with materials is planned as `effects` plans it (under even light, where no two sets are as dear and as good); one without them
# has no lit image.
"$program" shot --technique none --scene gallery --view ball --size 64x36 --backend gl-egl --reference-spp 0 --out frame.exr >/dev/null
config '{capture: frame.exr, light: uniform}' '{name: gtao, params: {radius: 0.5}}' | sed '/^resolutions/d' >capture.yaml
check "a capture" "$program" run capture.yaml --out capture --quiet
check "its plan" "$program" effects capture:frame.exr --light uniform --backend gl-egl --radius 0.5 --json plan.json
check "is drawn" test "$(jq -c "$effects" capture/journal.jsonl)" = "$(jq -c .chosen.effects plan.json)"
sed -i 's/light: uniform/light: uniform, materials: none/' capture.yaml
expect 2 "capture:frame.exr: lit needs the base colour of the surfaces" "$program" run capture.yaml --out bare --quiet

# Two builds are compared by the config of a view's set, which `effects` writes.
cp "$AOBUDGET_BUILD/modules/gtao.so" a.so
cat a.so <(echo) >b.so
expect 2 "two.yaml:5:10: effects: auto is for \`aobudget run\` alone, which plans each view first: write a view's config with \`aobudget effects SCENE --out FILE.yaml\`, and give that" \
  "$program" compare a.so b.so --config two.yaml --quiet
finish
