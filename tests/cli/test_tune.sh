#!/usr/bin/env bash
# tune: a planted optimum is found, what is held out is not fitted, and what is written runs and gives the figures that were said.
# modules/tuned.c is the truth of the scene corner at radius 1.5 (the target's), strength 2.5 and lift 0.4.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
module=$AOBUDGET_BUILD/tests/modules/tuned.so
tune=("$program" tune tuned --module "$module" --quiet)
view() { echo "{name: corner, eye: [$1, 2, 4], target: [$1, 0.8, 0], fov_deg: $2}"; }
config() { # NAME SCENES TECHNIQUES [LINES]; $rays a pixel
  cat >"$1.yaml" <<YAML
name: $1
scenes: [$2]
# the size of a stamp
resolutions: [96x54, 64x36]
backends: [vulkan]
techniques: # what is measured
  - name: none
$3
${4:-target: {radius: 1.5\}}
measure: {time: false}
reference: {spp: ${rays:-256}}
YAML
}
says() { jq -e "$@" >/dev/null; }

# Two views are fitted, one is held out, and one of a scene that the config has not.
rays=1024 config plant "$(view 0 60), $(view 1 50), $(view -1 55)" "  - name: tuned"
check "a fit" "${tune[@]}" --config plant.yaml --held-out corner/camera-3,spheres/close --json plant.json --out out.yaml
fitted() { jq "[.settings[0].parameters[] | select(.name == \"$1\")][0].fitted" "$2"; }
within() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a > b * .95 && a < b * 1.05) }'; }
check "the planted radius" within "$(fitted radius plant.json)" 1.5
check "the planted strength" within "$(fitted strength plant.json)" 2.5
check "the planted lift, out of a table" within "$(fitted lift plant.json)" 0.4
check "what changes nothing stays" says '.settings[0].parameters[] | select(.name == "idle") | .idle and .fitted == 0.25' plant.json
check "no seed, no whole number, nothing of the host" says '[.settings[0].parameters[].name] == ["radius", "strength", "lift", "idle"]' plant.json
check "the default has the target's radius" says '.settings[0].parameters[0].default == 1.5' plant.json
check "which views are held out" says '[.settings[0].views[] | "\(.name) \(.held_out)"] == ["corner/camera false", "corner/camera-2 false", "corner/camera-3 true", "spheres/close true"]' plant.json
check "what the fit leaves" says '.settings[0] | .training.share < 0.1 and .views[2].fitted.band_rmse < 0.1 * .views[2].default.band_rmse' plant.json
check "means are arithmetic" says '.settings[0] | .views as $v | [.training.default - ($v[0].default.band_rmse + $v[1].default.band_rmse) / 2, .held_out.fitted - ($v[2].fitted.band_rmse + $v[3].fitted.band_rmse) / 2] | map(fabs < 1e-9) | all' plant.json
check "the first size, and the config's rays" says '.width == 96 and .height == 54 and .spp == 1024 and .target.radius == 1.5' plant.json
check "no cost where time is not measured" says '.settings[0].views[0].fitted.ratio_to_ref == null' plant.json

# What is written: the config as it was but for name, techniques and target, and it runs to the figures that were said.
check "its name" grep -qx 'name: plant-tuned' out.yaml
check "comments elsewhere stay" grep -qx '# the size of a stamp' out.yaml
check "other techniques stay" grep -q 'name: none' out.yaml
check "it runs" "$program" run out.yaml --module "$module" --out run --quiet
run_error() { jq -s "[.[] | select(.technique == \"tuned\" and .view == \"camera\" and .width == 96 and (.params.strength == 1) == $1)][0].errors[0].band_rmse" run/journal.jsonl; }
check "without a fit" test "$(run_error true)" = "$(jq '.settings[0].views[0].default.band_rmse' plant.json)"
check "with it" test "$(run_error false)" = "$(jq '.settings[0].views[0].fitted.band_rmse' plant.json)"
check "as much again" test "$(grep -c '"technique": *"tuned"' run/journal.jsonl)" = 12

# A view that is held out has no part in the fit; it would have, since the module is wrong there.
fit_of() { jq -c '[.settings[0].parameters[].fitted]' "$1"; }
config alone "$(view 0 60)" "  - name: tuned"
config beside "$(view 0 60), {name: spheres, view: close}" "  - name: tuned"
check "one view" "${tune[@]}" --config alone.yaml --json alone.json
check "with one held out" "${tune[@]}" --config beside.yaml --json beside.json --held-out spheres
check "is the same fit" test "$(fit_of alone.json)" = "$(fit_of beside.json)"
check "without one, nothing is known of others" says '.settings[0].held_out.default == null' alone.json
check "beside the config" test -s alone-tuned.yaml

# Settings: what the config sweeps and no fit moves. A sweep over what is fitted is none; what it states stays.
config swept "$(view 0 60)" "  - {name: tuned, params: {lift: 0.4}, sweep: [{param: rough, values: [3, 1]}, {param: strength, values: [5, 1]}]}"
check "two settings" "${tune[@]}" --config swept.yaml --json swept.json
check "each of them" says '[.settings[].values.rough] == ["3", "1"]' swept.json
check "the better one" says '.chosen == 1 and .settings[1].training.fitted < .settings[0].training.fitted' swept.json
check "what is stated is not fitted" says '[.settings[1].parameters[].name] == ["radius", "strength", "idle"]' swept.json
check "and is written" grep -q 'lift: "0.4", rough: "1"' swept-tuned.yaml
check "unless it is named" "${tune[@]}" --config swept.yaml --json named.json --params lift,host,radius --out named.yaml
check "it starts there" says '.settings[0].parameters | .[0].name == "lift" and (.[0].default - 0.4 | fabs < 1e-6) and .[1].name == "host"' named.json
check "what is of the host moves too" within "$(jq '[.settings[] | select(.values | .rough == "1" and .strength == "5")][0].parameters[1].fitted' named.json)" 0.5

# A module from another folder, and a target from the command line.
config bare "$(view 0 60)" "" "# no target here"
check "without an entry of its own" "${tune[@]}" --config bare.yaml --target 0.75 --json bare.json --params radius,strength,lift
check "the other radius" within "$(fitted radius bare.json)" 0.75
check "it is in what is written" grep -qx 'target: {radius: 0.75, weighting: cosine}' bare-tuned.yaml

# Lists of keys in other forms; what cannot be patched is said, after the fit.
block() { printf 'name: "%s"\nscenes:\n- %s\nresolutions: 64x36\nbackends:\n- vulkan\n%s\nmeasure: {time: false}\nreference: {spp: 16}\n%s' "$1" "$(view 0 60)" "$2" "$3" >"$1.yaml"; }
block lists $'techniques:\n- name: none\n- name: tuned\n  module: '"$module"$'\n  sweep:\n  - param: rough\n    values: [1]\n# behind them' 'target:
  radius: 1.5'
check "lists of lines" "$program" tune tuned --quiet --config lists.yaml --params strength
check "a comment behind them" grep -qx '# behind them' lists-tuned.yaml
check "the module is written" test "$(grep -c "module: \"$module\"" lists-tuned.yaml)" = 2
check "they run" "$program" run lists-tuned.yaml --out lists --quiet
block alias $'options: {guard_band: &n 8}\ntechniques: [{name: tuned, params: {strength: *n}}]' 'target: {radius: 1.5}'
check "an alias is a value" "${tune[@]}" --config alias.yaml --params strength
check "which the fit has" test "$(grep -c 'strength: "8"' alias-tuned.yaml)" = 1
block anchor $'techniques: &t\n- &u {name: tuned}\n- *u' 'target: {radius: 1.5}'
expect 2 "anchor.yaml: a fit cannot be written into it" "${tune[@]}" --config anchor.yaml --params strength
check "so it is not" test ! -e anchor-tuned.yaml
finish
