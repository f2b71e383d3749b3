#!/usr/bin/env bash
# budget: the case to take for some milliseconds, from a journal that is written here, so that each figure is known.
source "$(dirname "$0")/lib.sh"
cd "$folder"
mkdir run
# line KEY VIEW TECHNIQUE N MS ERROR_NEAR ERROR_FAR MODEL_MS: 10 % about the measured time, a third about the modelled
line() {
  awk -v key="$1" -v view="$2" -v technique="$3" -v n="$4" -v ms="$5" -v near="$6" -v far="$7" -v model="$8" 'BEGIN {
    printf "{\"key\":\"%s\",\"scene\":\"corner\",\"view\":\"%s\",\"technique\":\"%s\",\"params\":{\"samples\":%d},\"options\":{\"guard_band\":0},", key, view, technique, n
    printf "\"backend\":\"null\",\"width\":64,\"height\":36,\"status\":\"ok\","
    printf "\"errors\":[{\"target\":{\"radius\":0.5,\"weighting\":\"cosine\"},\"rmse\":0.001,\"band_rmse\":%g},{\"target\":{\"radius\":2,\"weighting\":\"cosine\"},\"rmse\":0.001,\"band_rmse\":%g}],", near, far
    printf "\"time\":{\"clock\":\"cpu\",\"cpu_ms\":%g,\"wall_ms\":77,\"ratio_to_ref\":%g,\"ci_low\":%g,\"ci_high\":%g,\"passes\":[{\"name\":\"ao\",\"cpu_ms\":%g},{\"name\":\"blur\",\"cpu_ms\":%g}]},", ms, ms, ms * 0.9, ms * 1.1, ms * 0.75, ms * 0.25
    printf "\"cache\":{\"ps4\":{\"status\":\"ok\",\"modelled\":{\"frame\":{\"ms\":%g,\"low_ms\":%g,\"high_ms\":%g,\"limit\":\"texture\"},\"passes\":[{\"name\":\"ao\",\"ms\":%g,\"limit\":\"alu\"},{\"name\":\"blur\",\"ms\":%g,\"limit\":\"texture\"}]}}}}\n", model, model * 2 / 3, model * 4 / 3, model * 0.25, model * 0.75
  }'
}
{
  line n1 front none 0 0.5 0.5 0.6 0.03
  line a1 front gtao 4 1 0.2 0.09 0.3
  line b1 front gtao 8 2 0.1 0.2 0.6
  line c1 front gtao 16 4 0.05 0.3 1.2
  line n2 far none 0 0.5 0.5 0.6 0.03
  line a2 far gtao 4 1.5 0.3 0.08 0.3
  line b2 far gtao 8 3 0.2 0.25 0.9
  line c2 far gtao 16 4 0.1 0.4 1.5
} >run/journal.jsonl
echo '{"name":"made","cases":8}' >run/run.json

check "what fits 2.2 ms" "$program" budget run --ms 2.2 --target 0.5 --json made.json
cp .stdout table
check "the head counts what fits" grep -qx 'corner/front null 64x36 against the truth within 0.5 scene units: 2 of 3 cases fit 2.2 ms of processor time, measured here' table
check "a row: mark, error, both costs, bar, case" grep -qxF '  * 0.1000  2 (1.8 .. 2.2)  4 (3.47 .. 4.61)   ##################--|            gtao samples=8' table
check "the bar goes over" grep -qxF '    0.0500  4 (3.6 .. 4.4)  8 (6.94 .. 9.22)   ####################|#########>  gtao samples=16' table
check "the sentence" grep -qxF '  The most accurate case that fits is gtao samples=8: error 0.1000, 2 (1.8 .. 2.2) ms, 0.2 ms to spare (0 .. 0.4).' table
check "over all views the worst one decides" grep -qxF '  The most accurate setting whose worst view fits is gtao samples=4: error 0.3000, 1.5 (1.35 .. 1.65) ms, 0.7 ms to spare (0.55 .. 0.85).' table
check "two views of one target" jq -e '(.questions | length) == 2 and all(.questions[]; .target.radius == 0.5 and .cases == 3) and .fits' made.json
check "the choice of each view" jq -e '[.questions[].accurate.key] == ["b1", "a2"] and .settings[0].accurate.params.samples == 4 and .settings[0].accurate.error == 0.3' made.json
check "the Pareto set, by cost" jq -e '[.questions[0].front[].key] == ["a1", "b1", "c1"]' made.json
check "frames of none" jq -e '.questions[0].accurate.to_none | .at == 4 and (.low - 3.4702 | fabs) < 1e-3' made.json

"$program" budget run --ms 2.2 --json - >both.json
check "two radii are two questions" jq -e '(.questions | length) == 4 and [.questions[] | select(.target.radius == 2) | .accurate.key] == ["a1", "a2"]' both.json
check "a front is of one target" jq -e '[.questions[] | select(.target.radius == 2) | .front | length] == [1, 1]' both.json

check "modelled" "$program" budget run --ms 0.8 --profile ps4 --target 0.5 --json modelled.json
cp .stdout modelled
check "is judged by the model's upper end" grep -qx '.*front.*2 of 3 cases fit 0.8 ms, modelled on ps4' modelled
check "beside the measured time" jq -e '.profile == "ps4" and (.questions[0].accurate | .key == "b1" and .judged_ms.at == 0.6 and .measured_ms.at == 2 and .modelled_ms.high == 0.8)' modelled.json

got=0
"$program" budget run --ms 0.2 --profile ps4 --target 0.5 --json - >none.json || got=$?
check "nothing fits: 1" test $got -eq 1
check "by how much, and where it lies" jq -e '.fits == false and (.questions[0] | .accurate == null and (.least | .key == "a1" and .fit == "over" and (.room_ms.at + 0.1 | fabs) < 1e-9 and .dearest_pass.name == "blur" and .dearest_pass.limit == "texture"))' none.json
got=0
"$program" budget run --ms 2.1 --target 0.5 --json - >point.json || got=$?
check "a point that fits with an end that does not is named as such" jq -e '.questions[0] | .accurate.key == "a1" and .hopeful.key == "b1" and .hopeful.fit == "point"' point.json
check "the cheapest of an error" test "$("$program" budget run --ms 5 --target 0.5 --error 0.25 --json - | jq -r '[.questions[].cheap.key] | join(" ")')" = "a1 b2"

cat >frame.yaml <<END
title: a frame
source: made up
frame: 10
rest: 7.5
ao: 2.2
resolution: 64x36
END
check "a budget's slice" test "$("$program" budget run --budget ./frame.yaml --target 0.5 --json - | jq '.questions[0].ms')" = 2.2
sed -i 's/rest: 7.5/rest: 8/; /^ao/d' frame.yaml
check "or what the rest leaves" test "$("$program" budget run --budget ./frame.yaml --target 0.5 --json - | jq '.questions[0].ms')" = 2
check "--ms stands in its place" test "$("$program" budget run --budget ./frame.yaml --ms 9 --target 0.5 --json - | jq '.questions[0].ms')" = 9
printf 'title: a frame\nsource: made up\nframe: 10\nrest: 9.999\n' >late.yaml
sed 's/"cpu_ms":0.6/"cpu_ms":0.0705/' run/journal.jsonl | jq -c 'if .key == "a1" then .technique = "deferred" else . end' >late.jsonl
mkdir late && cp run/run.json late && mv late.jsonl late/journal.jsonl
got=0
"$program" budget late --budget ./late.yaml --target 0.5 --json late.json >late.txt || got=$?
check "nothing is left: 1" test $got -eq 1
check "in one sentence" grep -qxF 'The frame has 10 ms: the rest takes 9.999 ms, G-buffer and composite take 1 (0.9 .. 1.1) ms, and nothing is left for ambient occlusion: the frame is 1.1 ms over.' late.txt
check "with bars that go over" grep -qE '^    0.1000  2 \(1.8 .. 2.2\)  4 \([0-9.]+ .. [0-9.]+\)   ####################\|#########>  gtao samples=8$' late.txt
check "the overrun is as large as it is" jq -e '.questions[0].least.room_ms.at + 3.099 | fabs < 1e-9' late.json
sed 's/"cpu_ms":2,/"cpu_ms":0.0705,/; s/"ratio_to_ref":2,"ci_low":1.8,"ci_high":2.2/"ratio_to_ref":1,"ci_low":1,"ci_high":1.9716/' run/journal.jsonl >late/journal.jsonl
"$program" budget late --ms 2 --target 0.5 >wide.txt
check "columns are as wide as what they hold" grep -qE '^  \* 0.1000  0.0705 \(0.0705 .. 0.139\)  [^ ]+ \([^ ]+ .. [^ ]+\) +#' wide.txt
check "and their heads too" grep -qE '^    error   measured, ms {14}in frames of none +0 ' wide.txt

# What is not there is said, and a scene of which all cases failed is none that fits.
mkdir lost
jq -c '., (.scene = "spheres" | .key += "s" | .status = "failed" | del(.errors, .time))' run/journal.jsonl >lost/journal.jsonl
echo '{"name":"made","cases":17}' >lost/run.json
got=0
"$program" budget lost --ms 9 --target 0.5 --json lost.json >lost.txt || got=$?
check "a scene whose cases failed: 3" test $got -eq 3
check "it is named" grep -qx 'spheres/front null 64x36: none of its 4 cases is good: 4 failed' lost.txt
check "all that is not there in one line" grep -qx '9 of 17 cases are not there: 8 failed, 1 missing' lost.txt
check "the setting is not of all" grep -q '^2 of 4 scenes and views, null 64x36 .*: 3 settings are in all of them$' lost.txt
check "the document counts them" jq -e '.fits == false and .status.failed == 8 and .status.missing == 1 and [.unanswered[] | "\(.scene)/\(.view) \(.status.failed)"] == ["spheres/front 4", "spheres/far 4"] and (.settings[0] | .views == 2 and .places == 4)' lost.json
jq -c 'if .scene == "spheres" and .technique == "none" then .status = "ok" | .errors = [{"target": {"radius": 0.5, "weighting": "cosine"}, "band_rmse": 0.5}] else . end' lost/journal.jsonl >lost.jsonl
jq -c 'if .key == "b2" then .status = "unsupported" else . end' lost.jsonl >lost/journal.jsonl
echo '{"name":"made","cases":16}' >lost/run.json
"$program" budget lost --ms 9 --target 0.5 >lost.txt || true
check "nor of one view" grep -qx 'corner/far null 64x36 .*: 2 of 2 cases fit 9 ms of processor time, measured here; not there: 1 unsupported' lost.txt
# A scene of which only none is good has nothing to be chosen either.
got=0
"$program" budget lost --ms 9 --target 0.5 --json lost.json >lost.txt || got=$?
check "a scene of which only none is good: 3" test $got -eq 3
check "it asks nothing" grep -qx 'spheres/front null 64x36: no case that may be chosen is good; not there: 3 failed' lost.txt
check "nor has a table" bash -c "! grep -q '^spheres.* cases fit ' lost.txt"
check "the setting is of the others" jq -e '.fits == false and ([.questions[].scene] | unique) == ["corner"] and [.unanswered[] | "\(.scene)/\(.view) \(.status.ok) \(.status.failed)"] == ["spheres/front 1 3", "spheres/far 1 3"] and (.settings | length) == 1 and (.settings[0] | .views == 2 and .places == 4 and .settings == 2)' lost.json
expect 2 "lost: no case of these that may be chosen is good; the good ones are of none: the journal has the reasons" "$program" budget lost --ms 9 --scene spheres
budgeted='{"name":"made","cases":16,"budget":{"name":"frame","title":"a frame","source":"made up","frame_ms":10,"rest_ms":0,"ao_ms":9,"error":"inf","width":0,"height":0,"device":null}}'
echo "$budgeted" >lost/run.json
"$program" report lost --quiet
check "the page names it" grep -qx '<p class=soft>spheres/far null 64x36: no case that may be chosen is good; not there: 3 failed.</p>' lost/report/index.html
check "and has the setting of the others" grep -q 'Over 2 of 4 scenes and views, null 64x36 against the truth within 0.5 scene units: 2 settings are in all of them' lost/report/index.html
mkdir only
jq -c 'select(.scene == "corner" or .technique == "none")' lost/journal.jsonl >only/journal.jsonl
echo '{"name":"made","cases":10}' >only/run.json
got=0
jq -c 'if .key == "b2" then .status = "ok" else . end' only/journal.jsonl >only.jsonl && mv only.jsonl only/journal.jsonl
"$program" budget only --ms 9 --target 0.5 >only.txt || got=$?
check "a scene that has only none is not known to fit: 3" test $got -eq 3
check "nor is anything else said to be lost" grep -qx 'spheres/front null 64x36: no case that may be chosen is good' only.txt
# A case without the cost asks all the same, and the page says so.
mkdir untimed
jq -c 'if .view == "far" then del(.time) else . end' run/journal.jsonl >untimed/journal.jsonl
echo "$budgeted" >untimed/run.json
got=0
"$program" budget untimed --target 0.5 --json untimed.json >untimed.txt || got=$?
check "nothing fits a view without times: 1" test $got -eq 1
check "it counts among all" jq -e '.questions[1] | .view == "far" and .cases == 0 and .unknown == 3' untimed.json
check "and spoils the setting" jq -e '.settings[0] | .views == 2 and .settings == 0' untimed.json
"$program" report untimed --quiet
check "the page names its view" grep -qx '<p class=soft>corner/far null 64x36 against the truth within 0.5 scene units: of 3 cases the cost that is judged is not known.</p>' untimed/report/index.html
got=0
"$program" budget lost --ms 9 --target 0.5 --scene corner --quiet || got=$?
check "a scene that is asked for is judged by its own cases" test $got -eq 3
jq -c 'if .key == "b2" then .status = "ok" else . end' lost/journal.jsonl >lost.jsonl && mv lost.jsonl lost/journal.jsonl
check "and not by those of others" "$program" budget lost --ms 9 --target 0.5 --scene corner --quiet
jq -c 'if .scene == "spheres" then .status = "ok" | .errors = [{"target": {"radius": 139, "weighting": "cosine"}, "band_rmse": 0.5}] else . end' lost/journal.jsonl >lost.jsonl && mv lost.jsonl lost/journal.jsonl
"$program" budget lost --ms 9 >lost.txt || true
jq -c 'if .key == "a2s" then .status = "failed" else . end' lost/journal.jsonl >own.jsonl && mkdir own && mv own.jsonl own/journal.jsonl && cp run/run.json own
"$program" budget own --ms 9 --target 0.5 >own.txt || true
check "nor is it asked against another, and its failure is told" grep -qx 'spheres/far null 64x36: no good case that may be chosen has an error against a target that is asked for; not there: 1 failed' own.txt
check "a scene with a target of its own is not among all" grep -q '^2 of 4 scenes and views, null 64x36 against the truth within 0.5 scene units' lost.txt

check "every budget that comes with the program can be read" "$program" list budgets
expect 2 "choose one of alchemy-gtx580" "$program" budget run --budget nosuch
expect 2 "no good case of 1920x1080, the budget's resolution; there are 64x36" "$program" budget run --budget gtao-ps4
sed 's/64x36/9x9/' frame.yaml >size.yaml
expect 2 "no good case of 9x9" "$program" budget run --budget ./size.yaml
sed 's/rest: 8/rest: 10/' frame.yaml >rest.yaml
expect 2 "rest.yaml:4:7: the rest takes 10 ms, which is the whole frame of 10 ms" "$program" budget run --budget ./rest.yaml
sed '/source/d' frame.yaml >source.yaml
expect 2 "'source' is missing" "$program" budget run --budget ./source.yaml
expect 2 "say how much time there is" "$program" budget run
expect 2 "--ms: '0' is not a number from" "$program" budget run --ms 0
expect 2 "no case has a time modelled on 'ps5': put measure: {cache: [ps5]} into its config" "$program" budget run --ms 1 --profile ps5
expect 2 "no good case of the scene plane" "$program" budget run --ms 1 --scene plane
expect 2 "no case of these has an error against the target 1; the radii are 0.5, 2" "$program" budget run --ms 1 --target 1
# One reason, of all that is asked together.
mkdir odd
jq -c 'if .view == "far" then .scene = "plane" | .width = 128 else . end' run/journal.jsonl >odd/journal.jsonl
expect 2 "odd: no good case of plane of 64x36, the budget's resolution; there are 128x36" "$program" budget odd --budget ./frame.yaml --scene plane
expect 2 "no case has a time modelled on 'nosuch', and no profile has that name; it has ps4" "$program" budget run --ms 1 --profile nosuch
check "a profile's path stands for its name" "$program" budget run --ms 2 --profile ./prof/ps4.yaml --target 0.5
expect 2 "--scene: is empty" "$program" budget run --ms 1 --scene ''
expect 2 "--profile: is empty" "$program" budget run --ms 1 --profile ''
mkdir empty && touch empty/journal.jsonl
expect 2 "empty: its journal holds no case" "$program" budget empty --ms 1
expect 2 "is not the folder of a run" "$program" budget . --ms 1

# The config's budget, as run.json has it, is the default, and the page has a section of it.
echo '{"name":"made","cases":8,"budget":{"name":"frame","title":"a frame","source":"made up","frame_ms":10,"rest_ms":0,"ao_ms":2.2,"error":"inf","width":0,"height":0,"device":null}}' >run/run.json
check "the run's own budget" test "$("$program" budget run --target 0.5 --json - | jq -r '"\(.questions[0].ms) \(.budget.name)"')" = "2.2 frame"
"$program" report run --quiet
page=run/report/index.html
check "a row of the page" grep -q '<td>corner</td><td>front</td><td>64×36 null</td><td class=strong>gtao</td>.*<td class=n data-v="0.1">0.1000</td><td class=budget><span class=bar><i style="width:66.7%"></i><b style="width:60.6%"></b></span><span class="chip ok">fits</span> 0.2 ms to spare (0 .. 0.4)</td><td class=n data-v="2">2 (1.8 .. 2.2)</td><td class=n data-v="4">4 (3.47 .. 4.61)</td></tr>' $page
check "with a head for each of its cells" grep -q '<th>error</th><th>of the budget</th><th>measured <small>(ms)</small></th><th>in frames of none</th></tr>' $page
check "the setting of all views" grep -q 'Over all 2 scenes and views, null 64x36 against the truth within 0.5 scene units: 3 settings are in all of them. The most accurate setting whose worst view fits is gtao samples=4: error 0.3000' $page
check "a part for each target" test "$(sed -n '/<section id=budget/,/<\/section>/p' $page | grep -c '<div data-target=')" -eq 2
check "a way to it" grep -qF '<a href="#budget">budget</a>' $page
sed -i 's/"device":null/"device":"ps4"/; s/"ao_ms":2.2/"ao_ms":0.2/' run/run.json
"$program" report run --quiet
check "modelled" grep -q '<th>in frames of none</th><th>modelled <small>(ms)</small></th></tr>' $page
check "in its own column, the last" grep -q '<td class=n data-v="0.3">0.3 (0.2 .. 0.4)</td></tr>' $page
check "and over" grep -q '<td class=budget><span class=bar><i style="width:100.0%"></i><b style="width:100.0%"></b></span><span class="chip failed">over</span> 0.1 ms over (0 .. 0.2)</td>' $page
sed -i 's/"ao_ms":0.2/"ao_ms":0.35/' run/run.json
"$program" report run --quiet
check "or its point only" grep -q '<span class="chip invalid">its point only</span> 0.05 ms to spare, but perhaps 0.05 ms over</td>' $page
echo '{"name":"made","cases":9}' >run/run.json
"$program" report run --quiet
check "no section without a budget" bash -c "! grep -q 'id=budget' $page"
got=0
"$program" budget run --ms 9 --quiet || got=$?
check "of a run that lacks a case: 3" test $got -eq 3
finish
