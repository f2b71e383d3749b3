#!/usr/bin/env bash
# effects: the rules on scenes that show them, and the plan beside an exhaustive run of the same view.
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
check "gtao's own makes the image worse there, so it is not called for" test \
  "$(row gallery specular '[.called, .by] == [false, "measured"]') $(jq '.chosen.rmse as $own | .effects[] | select(.name == "specular") | .otherwise.rmse > $own' gallery.json)" = "true true"
check "so is what a sky lights" measured gallery directional
check "a smaller tolerance leaves more to measure" "$program" effects matte_white_room --size 64x36 --backend gl-egl --tolerance 0.0001 --json fine.json
check "specular among it" measured fine specular

# Every set as a run measures it: the composite on the device, another truth of other rays, the harness's scores. Before a still camera the
# mean over time is that of sixteen frames.
sets() { # OPTIONS TECHNIQUES
  cat <<YAML
name: sets
scenes: [{name: window_room, motion: {frames: 16}}]
resolutions: [64x36]
backends: [gl-egl]
options: {lit: [on], visibility_rgb: [off, on], specular: [off, on], $1}
techniques:
  - {name: gtao, sweep: [{param: divisor, values: [1, 2]}, {param: history, values: [0, 16]}]}
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
plan window window_room --tolerance 0.0003 --reference-spp 256 # the truth of the run
cat bends/journal.jsonl lights/journal.jsonl | jq -s '[.[] | select(.status == "ok") | .options as $o | {
  key: ((if .technique == "none" then [] else ["visibility"] end)
    + (if $o.visibility_rgb == "on" then ["multi_bounce"] else [] end) + (if $o.bent_normal == "on" then ["bent_normal"] else [] end)
    + (if $o.irradiance == "on" then ["directional"] else [] end) + (if $o.specular == "on" then ["specular"] else [] end)
    + (if .params.history == 16 then ["temporal"] else [] end) + (if .params.divisor == 2 then ["half_size"] else [] end) | join("+")),
  value: (.error | .lit_rmse * .lit_rmse - .lit_se * .lit_se | sqrt)}] | from_entries' >exhaustive.json
check "49 sets either way" test "$(jq length exhaustive.json) $(jq '.sets | length' window.json)" = "49 49"
check "each error is the run's, but for what halves round" jq -e --slurpfile run exhaustive.json \
  'all(.sets[]; (.rmse - $run[0][.effects | join("+")] | fabs) <= 3e-4)' window.json
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
finish
