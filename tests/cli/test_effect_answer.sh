#!/usr/bin/env bash
# effects: what a plan gives: its config, budgets and devices, its page, and what cannot be answered. The plans themselves are
# test_effect_plan.sh's.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache

# The config draws what was chosen, and scores it the same.
check "a config" "$program" effects window_room --size 64x36 --backend gl-egl --radius 0.4 -p slices=4 --out taken.yaml --json taken.json
check "it runs" "$program" run taken.yaml --out taken --quiet
same=$(jq -n --slurpfile plan taken.json --slurpfile run taken/journal.jsonl '$plan[0].chosen.effects as $e | $run[0] |
  (.params.radius == 0.4 and .params.slices == 4 and .options.lit == "on" and (.reference_radius - 0.4 | fabs) < 1e-6
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
check "the tolerance that counts is told: a tie of a budget, else the default" test "$(jq .tolerance fits.json) $(jq .tolerance ps4.json)" = "0.001 0.02"
check "the errors are those of here" jq -e --slurpfile own fits.json \
  '(.sets | length > 1) and all(.sets[]; . as $set | any($own[0].sets[]; .effects == $set.effects and .rmse == $set.rmse))' ps4.json

# The page: a picture of what is taken and of each set that an effect makes of it, a row an effect and a set, the chart.
check "a page" "$program" effects window_room --size 64x36 --backend gl-egl --page page --json page.json
pictures=$(jq '1 + ([.effects[].otherwise | select(. != null)] | length)' page.json)
check "its pictures" test "$(ls page/figures/*.png | wc -l)" = "$pictures"
check "none is missing" test "$(grep -c 'class="missing"' page/index.html)" = 0
check "each stands in it" test "$(grep -o 'src="figures/[a-z_]*.png"' page/index.html | sort -u | wc -l)" = "$pictures"
check "a chart of the sets" grep -q '</svg>' page/figures/sets.svg
check "a row an effect and a set" test "$(grep -c '^<tr><td>' page/index.html)" = "$((7 + $(jq '.sets | length' page.json)))"
check "the picture of nothing is what no occlusion shows" test "$(jq -r '.effects[] | select(.name == "visibility") | .otherwise.image' page.json)" = images/set-0.exr
check "nothing from elsewhere" test "$(grep -c '://' page/index.html)" = 0
expect 2 "page.json" "$program" effects corner --size 64x36 --backend gl-egl --page page.json

expect 2 "unknown scene 'nowhere'; there are plane" "$program" effects nowhere --size 64x36
expect 2 "scene 'corner' has no view 'nix'; it has front, far" "$program" effects corner --view nix
expect 2 "there is no profile 'nix'" "${small[@]}" --profile nix
expect 2 "--tolerance: '2' is not a number within 0 .. 1" "${small[@]}" --tolerance 2
expect 2 "--budget-ms: 'x' is not a number" "${small[@]}" --budget-ms x
expect 2 "--reference-spp: 3 is not an even whole number" "${small[@]}" --reference-spp 3
expect 2 "a plan of effects chooses 'lit' itself: leave it out" "${small[@]}" -p lit=on
expect 2 "a plan of effects chooses 'divisor' itself: leave it out" "${small[@]}" -p divisor=2
expect 2 "a plan of effects is of geometric normals: leave normals=shading out" "${small[@]}" -p normals=shading
expect 2 "the backend null draws nothing" "$program" effects corner --backend null
expect 2 "no/such.yaml" "${small[@]}" --out no/such.yaml
finish
