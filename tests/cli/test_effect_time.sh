#!/usr/bin/env bash
# effects over time: the mean over frames of a still view, whose noise decides, and of a sequence, whose flicker counts too.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
# plan NAME FLAGS...: its document is NAME.json
plan() {
  local name=$1
  shift
  check "a plan of $name" "$program" effects "$@" --size 64x36 --backend gl-egl --json "$name.json"
}
row() { jq -c ".effects[] | select(.name == \"temporal\") | $2" "$1.json"; }

# Nothing moves.
plan many corner -p slices=16 -p steps=12
check "a still camera with enough samples never pays for a mean" test "$(row many '[.called, .by]')" = '[false,"rule"]'
check "the sentence has its number" test "$(row many '.sentence | test("brings the image nearer by [0-9.e-]+ % at most, of a tolerance of 2 %")')" = true
plan few window_room -p slices=1 -p steps=2 -p blur=0 --out few.yaml
check "with few it is looked at, and called for" test "$(row few '[.called, .by]')" = '[true,"measured"]'
check "by the mean that brings one set the nearest" jq -e '(.effects[] | select(.name == "temporal").most) as $most | .sets as $all
  | [$all[] | select(.effects | index("temporal")) | . as $mean | $all[] | select(.effects == $mean.effects - ["temporal"]) | .rmse - $mean.rmse]
  | length == 24 and (max - $most | fabs) < 1e-6' few.json
check "its config says how long the view stands still" grep -q 'scenes: \[{name: "window_room", motion: {frames: 16}}\]' few.yaml
check "and the mean" grep -q 'params: {history: 16, divisor: ' few.yaml
check "it runs" "$program" run few.yaml --out few --quiet
check "with the error that was planned" test "$(jq -n --slurpfile plan few.json --slurpfile run few/journal.jsonl \
  '($run[0].error | .lit_rmse * .lit_rmse - .lit_se * .lit_se | sqrt) - $plan[0].chosen.rmse | fabs < 0.002')" = true
check "and the time, which is one of a history" jq -e '.time.passes | map(.name) | index("temporal") != null' few/journal.jsonl

# A sequence that stands still is judged as a picture is: the mean's first frames flicker, and nobody sees them.
plan still corner --frames 10
check "a still sequence with enough samples does not pay either" test "$(row still '[.called, .by]')" = '[false,"rule"]'
check "nothing moves, so there is no flicker" jq -e '.frames == 0 and all(.sets[]; .flicker == null)' still.json
# Noise that comes again in the next frame is noise all the same.
plan again cornell -p slices=8 -p steps=1 -p blur=0 -p noise_index=2 --tolerance 0.0087 --reference-spp 64
check "two frames would not tell it" test "$(row again .by)" = '"measured"'
check "and the set is near the least" jq -e '.chosen.rmse <= .least.rmse + 0.0087' again.json
# One picture of a scene that moves, and a G-buffer that the device draws, have no frames before.
plan picture passing_box --tolerance 0.002 --reference-spp 64
check "one picture of what moves" test "$(row picture .by)" = '"no data"'
cat >picture.yaml <<YAML
name: picture
scenes: [{name: passing_box, view: front}]
resolutions: [64x36]
backends: [gl-egl]
options: {lit: on}
techniques: [{name: gtao, sweep: [{param: divisor, values: [1, 2]}]}]
measure: {time: false, images: false}
target: {radius: 0.5}
reference: {spp: 64}
YAML
check "a run of it" "$program" run picture.yaml --out picture --quiet
check "the errors are the picture's" jq -e --slurpfile run <(jq -s '[.[] | .error | .lit_rmse * .lit_rmse - .lit_se * .lit_se | sqrt]' picture/journal.jsonl) \
  '[.sets[] | select(.effects - ["half_size"] == ["visibility"]) | .rmse] | length == 2 and (.[0] - $run[0][0] | fabs) < 3e-4 and (.[1] - $run[0][1] | fabs) < 3e-4' picture.json
plan drawn corner -p gbuffer=raster
check "a drawn G-buffer" test "$(row drawn .by)" = '"no data"'

# A sequence: errors and flicker are those of a run of it.
moves=(passing_box --view front --frames 6 --last-eye 0.2,2,6 --last-target 0,0.6,0)
plan moving "${moves[@]}" --reference-spp 32 -p slices=1 -p blur=0 --tolerance 0.004 --out moving.yaml
cat >all.yaml <<YAML
name: all
scenes: [{name: passing_box, view: front, motion: {frames: 6, eye: [0.2, 2, 6], target: [0, 0.6, 0]}}]
resolutions: [64x36]
backends: [gl-egl]
options: {lit: on}
techniques:
  - {name: gtao, params: {slices: 1, blur: 0}, sweep: [{param: divisor, values: [1, 2]}, {param: history, values: [0, 16]}]}
  - {name: none}
measure: {time: false, images: false}
target: {radius: 0.5}
reference: {spp: 32}
YAML
check "a run of its sets" "$program" run all.yaml --out all --quiet
jq -s '[.[] | {key: ((if .technique == "none" then [] else ["visibility"] end) + (if .params.history == 16 then ["temporal"] else [] end)
    + (if .params.divisor == 2 then ["half_size"] else [] end) | join("+")),
  value: [.sequence.flicker, (.error | [.lit_rmse * .lit_rmse - .lit_se * .lit_se, 0] | max | sqrt)]}] | from_entries' all/journal.jsonl >all.json
check "six frames" test "$(jq .frames moving.json)" = 6
check "the mean is looked at" test "$(row moving .by)" = '"measured"'
check "the flicker of five sets is the run's" jq -e --slurpfile run all.json \
  '[.sets[] | select($run[0][.effects | join("+")]) | (.flicker - $run[0][.effects | join("+")][0] | fabs)] | length == 5 and max < 1e-6' moving.json
check "and so are their errors" jq -e --slurpfile run all.json \
  '[.sets[] | select($run[0][.effects | join("+")]) | (.rmse - $run[0][.effects | join("+")][1] | fabs)] | length == 5 and max <= 3e-4' moving.json
check "sets of one size flicker alike" jq -e '[.sets[] | select(.effects | length > 0) | {k: [(.effects | index("temporal") != null), (.effects | index("half_size") != null)], f: .flicker}]
  | group_by(.k) | length == 4 and all(map(.f) | unique | length == 1)' moving.json
check "the set taken is near in both" jq -e '([.sets[].rmse] | min) as $e | ([.sets[].flicker] | min) as $f | .chosen | .rmse <= $e + 0.004 and .flicker <= $f + 0.004' moving.json
check "its config has the motion" grep -q 'motion: {frames: 6, eye: \[0.2,2,6\], target: \[0,0.6,0\]}' moving.yaml
check "and it runs" "$program" run moving.yaml --out moving --quiet
check "with the flicker that was planned" test "$(jq -n --slurpfile plan moving.json --slurpfile run moving/journal.jsonl \
  '$run[0].sequence.flicker - $plan[0].chosen.flicker | fabs < 0.01')" = true
check "a page" "$program" effects "${moves[@]}" --size 64x36 --backend gl-egl --page page --json page.json
check "with flicker in its tables" grep -q '<th>flicker, %</th>' page/index.html
check "and how many frames" grep -q '6 frames' page/index.html

# `effects: auto` thinks of earlier frames where the config has them.
cat >auto.yaml <<YAML
name: auto
scenes: [{name: window_room, motion: {frames: 8}}, {name: window_room}]
resolutions: [64x36]
backends: [gl-egl]
effects: auto
techniques: [{name: gtao, params: {slices: 1, steps: 2, blur: 0}}, {name: broken, params: {history: 8}}]
measure: {time: false}
reference: {spp: 32}
YAML
check "a run" "$program" run auto.yaml --out auto --quiet --module "$AOBUDGET_BUILD/tests/broken/sound.so"
check "the sequence has a mean, the picture none" test "$(jq -s -c 'map(select(.technique == "gtao") | [.view, .params.history])' auto/journal.jsonl)" = '[["room-8-frames",16],["room",0]]'
check "another technique keeps its own" test "$(jq -s -c 'map(select(.technique == "broken") | [.view, .params.history]) | sort' auto/journal.jsonl)" = '[["room",8],["room-8-frames",8]]'

expect 2 "a plan of effects chooses 'history' itself: leave it out" "$program" effects corner --size 64x36 --backend gl-egl -p history=8
expect 2 "--last-eye and --last-target go together" "$program" effects corner --frames 4 --last-eye 1,2,3
expect 2 "--last-eye is where a sequence ends: give --frames, how many there are" "$program" effects corner --last-eye 1,2,3 --last-target 0,0,0
expect 2 "--frames: '1' is not a number within 2 .. 128" "$program" effects corner --frames 1
expect 2 "--frames: 2.5 is not a whole number" "$program" effects corner --frames 2.5
expect 2 "--last-target: 'x' is not x,y,z" "$program" effects corner --frames 4 --last-eye 1,2,3 --last-target x
expect 2 "a capture is one frame: leave --frames out" "$program" effects capture:frame.exr --frames 4
expect 2 "the sequence of a mesh file needs its camera: give --eye and --target" "$program" effects ./mesh.obj --frames 4
finish
