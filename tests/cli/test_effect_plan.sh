#!/usr/bin/env bash
# effects: the rules on scenes that show them, the plan beside an exhaustive run of the same view, the config that it writes, a capture,
# and what cannot be answered.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
# plan NAME FLAGS...: its document is NAME.json
plan() {
  local name=$1
  shift
  check "a plan of $name" "$program" effects "$@" --size 64x36 --backend gl-egl --json "$name.json"
}
# row NAME EFFECT FILTER
row() { jq ".effects[] | select(.name == \"$2\") | $3" "$1.json"; }
rule() { test "$(row "$1" "$2" '[.called, .by] == [false, "rule"]')" = true; }
measured() { test "$(row "$1" "$2" .by)" = '"measured"'; }

plan white matte_white_room --out white.yaml
check "a matte scene never pays for specular" rule white specular
check "nor even light for directions" rule white directional
check "nor for bent normals" rule white bent_normal
check "even light has no direction at all" test "$(row white directional '.most < 1e-6')" = true
check "bounces are called for between white walls" test "$(row white multi_bounce '[.called, .by]' | jq -c .)" = '[true,"measured"]'
check "the sentence has its number" test "$(row white specular '.sentence | test("changes the image by [0-9.e-]+ % at most, of a tolerance of 2 %")')" = true
check "half size is a divisor" test "$(jq '.chosen.effects | index("half_size") != null' white.json)" = "$(grep -q 'divisor: 2' white.yaml && echo true)"
plan dark matte_dark_room
check "a dark scene never pays for bounces" rule dark multi_bounce
check "nor for directions" rule dark directional
plan sky open_sky
check "nothing within the radius: no visibility" rule sky visibility
check "nothing is taken" test "$(jq -c .chosen.effects sky.json)" = '[]'
check "and no other set was looked at" test "$(jq '.sets | length' sky.json)" = 1
plan level rocks --light uniform
check "a uniform sky never pays for directions" rule level directional
plan gallery gallery --view ball
check "polish is looked at" measured gallery specular
check "so is what a sky lights" measured gallery directional
check "a smaller tolerance leaves more to measure" "$program" effects matte_white_room --size 64x36 --backend gl-egl --tolerance 0.0001 --json fine.json
check "specular among it" measured fine specular

# Every set as a run measures it: the composite on the device, another truth of other rays, the harness's scores.
sets() { # OPTIONS TECHNIQUES
  cat <<YAML
name: sets
scenes: [{name: window_room}]
resolutions: [64x36]
backends: [gl-egl]
options: {lit: [on], visibility_rgb: [off, on], specular: [off, on], $1}
techniques:
  - {name: gtao, sweep: [{param: divisor, values: [1, 2]}]}
$2
measure: {time: false, images: false}
target: {radius: 0.5}
reference: {spp: 256}
YAML
}
sets 'bent_normal: [off, on]' '  - {name: none}' >bends.yaml
sets 'irradiance: [on]' '' >lights.yaml
"$program" run bends.yaml --out bends --quiet >/dev/null 2>&1 # `none` gives no effects: 3
check "a run of the other sets" "$program" run lights.yaml --out lights --quiet
plan window window_room --tolerance 0.0003
cat bends/journal.jsonl lights/journal.jsonl | jq -s '[.[] | select(.status == "ok") | .options as $o | {
  key: ((if .technique == "none" then [] else ["visibility"] end)
    + (if $o.visibility_rgb == "on" then ["multi_bounce"] else [] end) + (if $o.bent_normal == "on" then ["bent_normal"] else [] end)
    + (if $o.irradiance == "on" then ["directional"] else [] end) + (if $o.specular == "on" then ["specular"] else [] end)
    + (if .params.divisor == 2 then ["half_size"] else [] end) | join("+")),
  value: (.error | .lit_rmse * .lit_rmse - .lit_se * .lit_se | sqrt)}] | from_entries' >exhaustive.json
check "25 sets either way" test "$(jq length exhaustive.json) $(jq '.sets | length' window.json)" = "25 25"
check "each error is the run's, within both noises" jq -e --slurpfile run exhaustive.json \
  'all(.sets[]; (.rmse - $run[0][.effects | join("+")] | fabs) <= 3 * .rmse_se + 0.004)' window.json
# At the default tolerance the plan is one that the run has within it, and taking anything out of it, or half its size, is not.
plan window window_room
taken=$(jq -r '.chosen.effects | join("+")' window.json)
within() { jq -e --arg set "$1" '. as $all | [.[]] | min as $least | $all[$set] <= $least + 0.02' exhaustive.json; }
check "the run has the set within the tolerance" within "$taken"
without() { jq -r --arg out "$1" '.chosen.effects - [$out] | join("+")' window.json; }
for effect in $(jq -r '.chosen.effects[] | select(. != "visibility" and . != "half_size")' window.json); do
  check "not without $effect" test "$(jq --arg set "$(without "$effect")" '. as $all | [.[]] | min as $least | $all[$set] > $least + 0.02' exhaustive.json)" = true
done
check "half size is taken where the run has it within" test "$(jq '.chosen.effects | index("half_size") != null' window.json)" = \
  "$(jq --arg set "${taken%+half_size}+half_size" '. as $all | [.[]] | min as $least | $all[$set] <= $least + 0.02' exhaustive.json)"
check "the least error of all is one of the sets" jq -e '.least.rmse as $l | all(.sets[]; .rmse >= $l)' window.json
check "nothing within the tolerance is cheaper by more than a tie" jq -e '.chosen.ms as $ms | all(.sets[]; (.within | not) or 1.021 * .ms >= $ms)' window.json

# The config draws what was chosen, and scores it the same.
check "a config" "$program" effects window_room --size 64x36 --backend gl-egl --radius 0.4 -p slices=4 --out taken.yaml --json taken.json
check "it runs" "$program" run taken.yaml --out taken --quiet
same=$(jq -n --slurpfile plan taken.json --slurpfile run taken/journal.jsonl '$plan[0].chosen.effects as $e | $run[0] |
  (.params.radius == 0.4 and .params.slices == 4 and .options.lit == "on" and .reference_radius - 0.4 < 1e-6
    and (.options.visibility_rgb == "on") == ($e | index("multi_bounce") != null)
    and (.options.bent_normal == "on") == ($e | index("bent_normal") != null)
    and (.options.irradiance == "on") == ($e | index("directional") != null)
    and (.options.specular == "on") == ($e | index("specular") != null)
    and (.params.divisor == 2) == ($e | index("half_size") != null)
    and (.error.lit_rmse - $plan[0].chosen.rmse | fabs) < 0.01)')
check "the same settings, and the same error" test "$same" = true

# Budgets, and a device's modelled times.
expect_code() { # CODE WHAT COMMAND...
  local code=$1 what=$2 got=0
  shift 2
  "$@" >out 2>err </dev/null || got=$?
  check "$what: code $code" test "$got" = "$code"
}
small=("$program" effects corner --size 64x36 --backend gl-egl)
expect_code 1 "nothing fits" "${small[@]}" --budget-ms 0.00001
check "what it would take is told" grep -q '^nothing fits 1e-05 ms: the lit image without any occlusion takes ' out
expect_code 0 "all fits" "${small[@]}" --budget-ms 100000 --json fits.json
check "then the least error is taken, but for a tie" jq -e '.chosen.rmse <= .least.rmse + 0.001 and all(.sets[]; .fits)' fits.json
expect_code 0 "a device" "${small[@]}" --profile ps4 --json ps4.json
check "its milliseconds are modelled" jq -e '.profile == "ps4" and all(.sets[]; .ms > 0 and .ms < 1)' ps4.json
check "the errors are those of here" jq -e --slurpfile own fits.json '[.sets[].rmse] == [$own[0].sets[].rmse]' ps4.json

# The page: a picture of what is taken and of each set that an effect makes of it, a row an effect and a set, the chart.
check "a page" "$program" effects window_room --size 64x36 --backend gl-egl --page page --json page.json
pictures=$(jq '1 + ([.effects[].otherwise | select(. != null)] | length)' page.json)
check "its pictures" test "$(ls page/figures/*.png | wc -l)" = "$pictures"
check "none is missing" test "$(grep -c 'class="missing"' page/index.html)" = 0
check "each stands in it" test "$(grep -o 'src="figures/[a-z_]*.png"' page/index.html | sort -u | wc -l)" = "$pictures"
check "a chart of the sets" grep -q '</svg>' page/figures/sets.svg
check "a row an effect and a set" test "$(grep -c '^<tr><td>' page/index.html)" = "$((6 + $(jq '.sets | length' page.json)))"
check "the picture of nothing is what no occlusion shows" test "$(jq -r '.effects[] | select(.name == "visibility") | .otherwise.image' page.json)" = images/set-0.exr
check "nothing from elsewhere" test "$(grep -c '://' page/index.html)" = 0
expect 2 "page.json" "$program" effects corner --size 64x36 --backend gl-egl --page page.json

# A capture: what its depth and the light tell.
"$program" shot --technique none --scene gallery --view ball --size 64x36 --backend gl-egl --reference-spp 0 --out frame.exr >/dev/null
expect_code 3 "a capture" "$program" effects capture:frame.exr --fov 50 --backend gl-egl --json capture.json --out capture.yaml
check "visibility is measured" measured capture visibility
check "even light rules directions out" rule capture directional
check "materials are missing" test "$(row capture multi_bounce .by) $(row capture specular .by)" = '"no data" "no data"'
check "its config runs" "$program" run capture.yaml --out capture --quiet
check "without a lit image" jq -e '.options.lit == "off" and .technique == "gtao"' capture/journal.jsonl
expect_code 3 "under a window" "$program" effects capture:frame.exr --fov 50 --backend gl-egl --light window --json capture.json
check "directions could matter, and nothing tells" test "$(row capture directional '[.by, .most > 0.02]' | jq -c .)" = '["no data",true]'

expect 2 "unknown scene 'nowhere'; there are plane" "$program" effects nowhere --size 64x36
expect 2 "scene 'corner' has no view 'nix'; it has front, far" "$program" effects corner --view nix
expect 2 "there is no profile 'nix'" "${small[@]}" --profile nix
expect 2 "--tolerance: '2' is not a number within 0 .. 1" "${small[@]}" --tolerance 2
expect 2 "--budget-ms: 'x' is not a number" "${small[@]}" --budget-ms x
expect 2 "--reference-spp: 3 is not an even whole number" "${small[@]}" --reference-spp 3
expect 2 "'lit' is given twice" "${small[@]}" -p lit=on
expect 2 "'divisor' is given twice" "${small[@]}" -p divisor=2
expect 2 "a plan of effects is of geometric normals: leave normals=shading out" "${small[@]}" -p normals=shading
expect 2 "the backend null draws nothing" "$program" effects corner --backend null
expect 2 "no/such.yaml" "${small[@]}" --out no/such.yaml
finish
