#!/usr/bin/env bash
# Sequences: frames drawn in order, each against the truth of its time, and flicker; what is shared in the cache, and what is refused.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
modules=$AOBUDGET_BUILD/tests/modules
config() { # NAME SCENES TECHNIQUES [MEASURE]
  cat >"$1.yaml" <<YAML
name: $1
scenes: [$2]
resolutions: [96x54]
backends: [gl-egl]
techniques: [$3]
measure: {${4:-time: false}}
target: [{radius: 0.5}, {radius: 1}]
reference: {spp: 16}
YAML
}
run() { "$program" run "$1.yaml" --out "$1" --quiet "${@:2}"; }
# of RUN VIEW FILTER: of the journal's lines of that view, as an array
of() { jq -sc --arg view "$2" "map(select(.view == \$view)) | $3" "$1/journal.jsonl"; }

# Nothing moves: all frames are the picture's files, and nothing flickers.
config picture '{name: corner, view: front}' '{name: gtao}, {name: hbao}'
check "a picture" run picture
before=$(find cache -type f | sort)
config still '{name: corner, motion: {frames: 5}}' '{name: gtao}, {name: hbao}'
check "a still sequence" run still
check "has five errors, which are equal, and the last is the case's" test "$(of still front-5-frames \
  'map((.sequence.error | length == 5 and (unique | length) == 1) and .sequence.error[4] == .error.rmse and .sequence.error_mean - .error.rmse < 1e-9) | all')" = true
check "does not flicker, and is compared everywhere" test "$(of still front-5-frames \
  'map([.sequence.frames, .sequence.flicker, .sequence.truth_change, .sequence.compared, .error.flicker, .errors[1].flicker])')" = '[[5,0,0,1,0,0],[5,0,0,1,0,0]]'
check "is cast and traced with the picture" test "$before" = "$(find cache -type f | sort)"

# A technique that blinks by a known amount before a still scene.
config blink '{name: corner, motion: {frames: 4}}, {name: corner, view: front}' '{name: blink, params: {amplitude: [0.125, 0.0625]}}'
check "a blinking technique" run blink --module "$modules/blink.so"
check "flickers by what it blinks" test "$(of blink front-4-frames 'map(.sequence.flicker)')" = '[0.25,0.125]'
check "has the frames' numbers: even ones are the single picture" test "$(of blink front-4-frames \
  'map(.sequence.error | .[0] == .[2] and .[1] == .[3] and .[0] != .[1])')" = '[true,true]'
check "and its errors" test "$(of blink front-4-frames 'map(.sequence.error[0])')" = "$(of blink front 'map(.error.rmse)')"
check "no sequence in the record of a picture" test "$(of blink front 'map(has("sequence") or has("motion") or (.error | has("flicker"))) | any')" = false
config bad '{name: corner, motion: {frames: 4}}' '{name: blink, params: {bad: [1, 3, 7]}}'
run bad --module "$modules/blink.so" >/dev/null
check "an image that is none makes its case invalid" test $? -eq 3
check "whichever frame it is of" test "$(of bad front-4-frames 'map([.status, (.reason | startswith("frame 1: ")), has("sequence")])')" = \
  '[["invalid",true,false],["invalid",false,false],["ok",false,true]]'

# The camera moves: the last frame is what a picture from there is, with the same truth.
config moving '{name: corner, view: far, motion: {frames: 3, eye: [2.75, 4, 8], target: [0.25, 1, 0]}}, {name: corner, eye: [2.75, 4, 8], target: [0.25, 1, 0], fov_deg: 45}' '{name: gtao}'
check "a moving camera" run moving
check "has three errors, the last is that of the picture" test "$(of moving far-3-frames '.[0].sequence.error | [length, .[2]]')" = \
  "[3,$(of moving camera '.[0].error.rmse')]"
check "with the same truths" test "$(of moving far-3-frames '.[0].errors | map(.truth)')" = "$(of moving camera '.[0].errors | map(.truth)')"
check "and image" test "$(of moving far-3-frames '.[0].image_digest')" = "$(of moving camera '.[0].image_digest')"
check "is another case" test "$(of moving far-3-frames '.[0] | [.key, .series]')" != "$(of moving camera '.[0] | [.key, .series]')"
check "compares most points, whose truth hardly changes" jq -e '.sequence.compared > 0.9 and .sequence.compared < 1 and .sequence.truth_change < 0.01 and .sequence.flicker > 0' \
  <(of moving far-3-frames '.[0]')
check "a shot of the same sequence" "$program" shot --technique gtao --scene corner --view far --frames 3 --last-eye 2.75,4,8 \
  --last-target 0.25,1,0 --size 96x54 --backend gl-egl --target-radius 0.5,1 --reference-spp 16 --json shot.json
check "is the run's case" test "$(jq -c '[.key, .error.rmse, .sequence.flicker, .image_digest]' shot.json)" = \
  "$(of moving far-3-frames '.[0] | [.key, .error.rmse, .sequence.flicker, .image_digest]')"
check "says where it came from" test "$(of moving far-3-frames '.[0] | [.motion.frames, .motion.eye[1], .camera.eye[1], .camera.previous.eye[1]]')" = '[3,4,4,4]'

# A box moves: frames are shared with pictures, and velocities are in the image.
config box '{name: passing_box, motion: {frames: 3}}' '{name: gtao}'
check "a moving object" run box
check "its image has velocities" grep -qa 'V\.Z' "box/$(jq -r .image box/journal.jsonl)"
check "its truth changes, and the most of it is compared" jq -e '.sequence.truth_change > 0.001 and .sequence.compared > 0.9 and .sequence.compared < 1 and
  (.sequence.error | length == 3 and (unique | length) == 3)' box/journal.jsonl
sed 's/spp: 16/spp: 1024/' box.yaml >fine.yaml
check "the same with 64 times the rays" run fine
check "its truth changes by as much: the noise of few rays is taken out" jq -se '(.[0].sequence.truth_change / .[1].sequence.truth_change - 1 | fabs) < 0.15 and
  .[0].error.reference_se > 4 * .[1].error.reference_se and .[0].error.reference_se > 0.7 * .[1].sequence.truth_change' box/journal.jsonl fine/journal.jsonl
before=$(find cache -name 'gbuffer-*' | sort)
config shared '{name: passing_box, view: front}' '{name: blink}'
check "a picture of frame 0" run shared --module "$modules/blink.so"
check "is cast with the sequence" test "$before" = "$(find cache -name 'gbuffer-*' | sort)"

# Resume: nothing is measured again; a line that is lost comes back as it was.
cp box/journal.jsonl old.jsonl
check "a run that is started again" run box
check "measures nothing" cmp box/journal.jsonl old.jsonl
: >box/journal.jsonl
check "one whose journal is empty" run box
check "measures the same" test "$(jq -c '[.key, .series, .sequence, .error]' box/journal.jsonl)" = "$(jq -c '[.key, .series, .sequence, .error]' old.jsonl)"

# Times are of the last frame, in several processes.
config timed '{name: passing_box, motion: {frames: 3}}' '{name: none}, {name: gtao}' 'seconds: 0.02'
check "a timed sequence" run timed
check "has times" jq -se 'length == 2 and all(.time.rounds > 0 and .sequence.frames == 3)' timed/journal.jsonl
check "the CSV has the flicker" awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "flicker") at = i } NR > 1 && $at != "" { n++ } END { exit !(at && n) }' timed/report/cases.csv
check "and so has the page, over time" grep -q 'Over time' timed/report/index.html
check "with a chart of them" test "$(find timed/report/figures -name '*over-time.svg' | wc -l)$(grep -c 'not drawn' timed/report/index.html)" = 10
check "a page of pictures has no such part" test "$(grep -c 'Over time' shared/report/index.html)" -eq 0

# Fetches and operations are of a frame that has others before it: of a picture the one after it, of a sequence the last. The mean over
# time reads ten texels before a still camera, and forty before one that moves: two textures at 4 x 4 pixels in place of one.
config cached '{name: corner, view: far}, {name: corner, view: far, motion: {frames: 2}}, {name: corner, view: far, motion: {frames: 3, eye: [2.75, 4, 8], target: [0.25, 1, 0]}}' \
  '{name: gtao, params: {blur: 0, history: 8}}, {name: gtao, params: {blur: 0}}' 'time: false, error: false, images: false, cache: ps5'
check "a sequence in a cache" run cached
passes() { of cached "$1" "map(select(.params.history == 8) | .cache.ps5 | [.passes[] | select(.name == \"temporal\") | $2]) | .[0][0]"; }
check "a still camera reads the pixel of before" test "$(passes far '.fetches / .invocations')" = 10
check "and so does a still sequence" test "$(passes far-2-frames .)" = "$(passes far .)"
check "one that moves reads sixteen" test "$(passes far-3-frames '.fetches / .invocations')" = 40
check "and what is traced is what is drawn" test "$(jq -sc 'map(.cache.ps5.texels_differ) | unique' cached/journal.jsonl)" = '[0]'
without() { of cached "$1" 'map(select(.params.history == 0) | .cache.ps5.passes)'; }
check "without a history nothing depends on what was before" test "$(without far-2-frames)" = "$(without far)"

# What cannot follow says so.
config drawn '{name: passing_box, motion: {frames: 3}}, {name: passing_box}' '{name: ao_volumes}'
run drawn >/dev/null
check "one that draws triangles is unsupported in a sequence alone" test "$(jq -sc 'map([.view, .status]) | sort' drawn/journal.jsonl)" = '[["front","ok"],["front-3-frames","unsupported"]]'
check "and why" grep -q "it draws the scene's triangles, which a sequence does not bring along: leave motion out" drawn/journal.jsonl
config raster '{name: passing_box, motion: {frames: 3}}' '{name: none}'
echo 'options: {gbuffer: [canonical, raster]}' >>raster.yaml
run raster >/dev/null
check "so is a drawn G-buffer" test "$(jq -sc 'map([.options.gbuffer, .status, .reason]) | sort' raster/journal.jsonl)" = \
  '[["canonical","ok",""],["raster","unsupported","a sequence is of ray-cast G-buffers: gbuffer must be canonical"]]'
config wall '{name: corner, eye: [0, 2, 4], target: [0, 9, 9], motion: {frames: 3, eye: [0, 2, 4], target: [0, 0.75, 0]}}' '{name: none}'
expect 2 "nothing could run" run wall
check "a frame that shows nothing is named" grep -q '"frame 0 of 3: .*no pixel of the view shows a surface' wall/journal.jsonl

# Plans name them.
config plan '{name: passing_box, views: [front, far], motion: {frames: 3}}, {name: passing_box, motion: {frames: 4}}' '{name: none}'
check "a plan has their lines" test "$("$program" plan plan.yaml | grep -c '^passing_box/\(front-3\|far-3\|front-4\)-frames none$')" -eq 3
check "scenes say whether they move" test "$("$program" list scenes --json - | jq -c '[.scenes[] | select(.moves) | .name]')" = '["passing_box"]'
finish
