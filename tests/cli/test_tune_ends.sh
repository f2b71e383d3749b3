#!/usr/bin/env bash
# tune: what is wrong is one line before anything is traced, and no end leaves a config that is not whole.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
module=$AOBUDGET_BUILD/tests/modules/tuned.so
tune=("$program" tune tuned --module "$module" --quiet --config c.yaml)
config() { # FILE SCENES TARGET [LINES]
  cat >"$1" <<YAML
name: c
scenes: [$2]
resolutions: [64x36]
backends: [vulkan]
techniques:
  - name: tuned
$3
measure: {time: false}
reference: {spp: 16}
${4:-}
YAML
}
corner='{name: corner, eye: [0, 2, 4], target: [0, 0.8, 0], fov_deg: 60}'
config c.yaml "$corner, {name: spheres}" 'target: {radius: 1.5}'

expect 2 "tune: --config C.yaml is missing" "$program" tune tuned
expect 2 "cannot" "$program" tune tuned --config nowhere.yaml
expect 2 "'alchemie'" "$program" tune alchemie --config c.yaml
expect 2 "has no parameter 'strenght'; what can be fitted of it: radius, strength, lift, idle, seed, host" "${tune[@]}" --params strenght
expect 2 "'rough' of tuned is a whole number" "${tune[@]}" --params radius,rough
expect 2 "'mode' of tuned is a choice" "${tune[@]}" --params mode
expect 2 "'radius' stands there twice" "${tune[@]}" --params radius,radius
expect 2 "'idle'" "${tune[@]}" --held-out idle
expect 2 "scene 'spheres' has no view 'below'" "${tune[@]}" --held-out spheres/below
expect 2 "leaves no view of c.yaml to fit" "${tune[@]}" --held-out corner,spheres
expect 2 "has an empty name" "${tune[@]}" --held-out corner,
expect 2 "--target: 'far' is not a radius" "${tune[@]}" --target far
expect 2 "--target: a fit is to one radius" "${tune[@]}" --target 1,2
expect 2 "--budget-ms: '0' is not a number" "${tune[@]}" --budget-ms 0
expect 2 "none of the parameters changes an image here" "${tune[@]}" --params idle,seed --out idle.yaml
check "and nothing was written" test ! -e idle.yaml

config no_target.yaml "$corner" ''
expect 2 'no_target.yaml: it has no target: write `target: {radius: R}` into it, or give --target R' "$program" tune tuned --module "$module" --config no_target.yaml
config two.yaml "$corner" 'target: [{radius: 1}, {radius: 2}]'
expect 2 "it has 2 targets, and a fit is to one" "$program" tune tuned --module "$module" --config two.yaml
config moves.yaml '{name: passing_box, motion: {frames: 4}}' 'target: {radius: 1}'
expect 2 "moves.yaml:2:" "$program" tune gtao --config moves.yaml
config open.yaml '{name: plane}' 'target: {radius: 1}'
expect 2 "no view that is fitted has occlusion within the target's radius" "$program" tune tuned --module "$module" --config open.yaml
sed 's/\[vulkan\]/[null]/' c.yaml >null.yaml
expect 2 "the backend null draws nothing" "$program" tune tuned --module "$module" --config null.yaml
sed 's/time: false/error: false/' c.yaml >no_error.yaml
expect 2 "measure says error: false" "$program" tune tuned --module "$module" --config no_error.yaml
sed 's/- name: tuned/- {name: tuned, params: {mode: black}}/' c.yaml >black.yaml
expect 2 "which is no visibility" "$program" tune tuned --module "$module" --config black.yaml

# Where it is to write.
echo '{name: c, scenes: [{name: spheres}], resolutions: [64x36], backends: [vulkan], techniques: [{name: gtao}], target: {radius: 1}}' >braces.yaml
expect 2 "braces.yaml: it is written in braces" "$program" tune gtao --config braces.yaml
echo mine >there.yaml
expect 2 "there.yaml: it exists, and a fit replaces no config" "${tune[@]}" --out there.yaml
check "it stays" test "$(cat there.yaml)" = mine
expect 2 "nowhere/x.yaml" "${tune[@]}" --out nowhere/x.yaml
mkdir -p sub
printf 'o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >m.obj
config mesh.yaml '{file: m.obj}' 'target: {radius: 1}'
expect 2 "names 'm.obj', which is seen from its own folder" "$program" tune tuned --module "$module" --config mesh.yaml --out sub/x.yaml
expect 2 "nowhere/x.json" "${tune[@]}" --json nowhere/x.json
check "none of these wrote a config" test -z "$(find . -name '*-tuned.yaml' -o -path './sub/*')"

# A budget that nothing fits.
config dear.yaml "$corner" 'target: {radius: 1.5}'
expect 1 "--budget-ms: nothing of tuned fits 1e-06 ms: the cheapest of its settings takes up to" "$program" tune tuned --module "$module" --quiet --config dear.yaml --budget-ms 1e-6 --json dear.json
check "it is said" jq -e '.chosen == null and .out == null and .settings[0].too_dear and .budget_ms == 1e-6' dear.json
check "and no config" test ! -e dear-tuned.yaml
check "a budget that it fits" "$program" tune tuned --module "$module" --quiet --config dear.yaml --budget-ms 1e6 --json fits.json
check "its cost is known, if only for that" jq -e '.settings[0].views[0] | .fitted.ratio_to_ref > 0 and .fitted.ms > 0 and .default.high >= .default.ms' fits.json

# An end from outside: nothing half-written, and no folder of its frames.
mkdir own
set -m # else a shell's background program ignores INT
TMPDIR=$folder/own "${tune[@]}" --out ended.yaml >ended 2>&1 &
pid=$!
set +m
for ((turn = 0; turn < 400; turn++)); do
  pgrep -P "$pid" -f worker >/dev/null && [ -n "$(ls own)" ] && break
  sleep 0.05
done
code=0
kill -INT "$pid"
wait "$pid" || code=$?
check "INT ends it as such" test "$code" = 130
for ((turn = 0; turn < 400; turn++)); do
  [ -z "$(ls own)" ] && break
  sleep 0.05
done
check "its folder goes" test -z "$(ls own)"
check "no config" test -z "$(ls ended.yaml* 2>/dev/null)"
check "and it can be asked again" "${tune[@]}" --out ended.yaml --params strength
finish
