#!/usr/bin/env bash
# Times over processes, from the flag to the record: raw rounds that give the journal's figures again, the precision that
# was wanted and reached, processes that die, and one measuring process at a time.
source "$(dirname "$0")/lib.sh"
cd "$folder"
modules=$AOBUDGET_BUILD/tests/modules
cat >config.yaml <<EOF
name: timing
scenes: [{name: corner}]
resolutions: [48x27]
backends: [gl-osmesa]
techniques: [{name: none}, {name: gtao}, {name: alchemy}]
measure: {seconds: 0.1, error: false, images: false}
EOF
check "a run" "$program" run config.yaml --out out --json summary.json --precision 0.2%
check "three cases" test "$(jq -r .status out/journal.jsonl | grep -c ok)" -eq 3
each() { check "$1" test "$(jq -s "map(.time) | all($2)" out/journal.jsonl)" = true; }
each "three processes or more" '.processes >= 3 and .rounds >= 2 * .processes'
each "what was wanted" '.precision_wanted == 0.002'
each "what was reached" '(.precision == null) or
  ((.precision - ([.ci_high / .ratio_to_ref, .ratio_to_ref / .ci_low] | max - 1) | fabs) < 1e-6)'
each "what it would take" '(.precision != null and .precision > 0.002) == (.seconds_needed != null) and
  (.seconds_needed == null or .seconds_needed == "inf" or .seconds_needed > 0)'
each "one block" '.slots[0:2] == ["fixed", "control"] and (.slots | length) == 5'
each "by processor time" '.clock == "cpu" and .device_ms == null and .ref_ms > 0 and .cpu_ms > 0'
check "a cheap case has more frames" test "$(jq -s 'map({(.technique): .time.frames}) | add | .none > .gtao' out/journal.jsonl)" = true
check "the summary counts them" test "$(jq '.imprecise.cases' summary.json)" = \
  "$(jq -s 'map(select(.time.seconds_needed != null or .time.precision == null)) | length' out/journal.jsonl)"
check "and what the worst of them would take" test "$(jq '.imprecise.seconds_needed' summary.json)" = "$(jq -s \
  'map(.time | select(.precision > 0.002).seconds_needed) | if length > 0 and all(type == "number") then max else null end' out/journal.jsonl)"

# The raw rounds: read by other programs, and by this one to the last digit of the journal.
file=out/$(jq -r .time.rounds_file out/journal.jsonl | sort -u)
check "one file" test -f "$file"
check "the figures of three records again" test "$("$AOBUDGET_BUILD/check_rounds" out)" = "3 records, 0 differences"
zstdcat "$file" >rounds.jsonl
check "a line a round" test "$(wc -l <rounds.jsonl)" -eq "$(head -1 out/journal.jsonl | jq .time.rounds)"
check "each slot has its place" test "$(jq -s 'all([.slots[].place] | sort == [0, 1, 2, 3, 4])' rounds.jsonl)" = true
check "each process has its seed" test "$(jq -s 'map([.process, .seed]) | unique
  | (map(.[0]) | unique | length) == length and (map(.[1]) | unique | length) == length' rounds.jsonl)" = true
for technique in none gtao alchemy; do # an independent median
  read -r slot ms < <(jq -r "select(.technique == \"$technique\") | .key as \$key | [(.time.slots | index(\$key)), .time.cpu_ms] | @tsv" out/journal.jsonl)
  again=$(jq -s "map(.slots[$slot] | .cpu_ns / .frames / 1e6) | sort | (.[(length - 1) / 2 | floor] + .[length / 2 | floor]) / 2" rounds.jsonl)
  check "the median of $technique" test "$(jq -n "($ms / $again - 1 | fabs) < 1e-6")" = true
done
printf 'x' | dd of="$file" bs=1 seek=40 conv=notrunc 2>/dev/null
check "damage is told" grep -q "$file: it is damaged" <("$AOBUDGET_BUILD/check_rounds" out 2>&1)
check "--fresh discards them" "$program" run config.yaml --out out --fresh --quiet
check "and keeps the new ones" test "$(ls out/rounds)" = "$(basename "$(jq -r .time.rounds_file out/journal.jsonl | sort -u)")"

# What Mesa compiles is shared by the processes of one run, and by nobody else.
mkdir home
(
  unset MESA_SHADER_CACHE_DISABLE XDG_CACHE_HOME
  export HOME=$folder/home
  "$program" run config.yaml --out shared --quiet &
  for _ in $(seq 600); do [ -n "$(find shared/shaders -type f 2>/dev/null)" ] && touch was_there && break; sleep 0.05; done
  wait
)
check "Mesa keeps them in the run's folder" test -e was_there
check "which are gone with the run" test ! -e shared/shaders
check "and nowhere else" test -z "$(find home -name '*mesa*')"
mkdir -p shared/shaders/ab && echo stale >shared/shaders/ab/stale
check "what a killed run left" "$program" run config.yaml --out shared --quiet
check "is removed" test ! -e shared/shaders

# The summary says in its one line what is less precise, and what would do: of figures that are planted in the journal.
sed 's/seconds: 0.1/seconds: 0.01, precision: 0.1%/' config.yaml >coarse.yaml
check "a coarse run" "$program" run coarse.yaml --out coarse --quiet
plant() { # NEEDED-BY-NONE WANTED: what none would need, and what all were asked for
  jq -c ".time += {precision: 0.04, precision_wanted: $2, seconds_needed: ({none: $1, gtao: 12.34, alchemy: 7}[.technique])}" \
    coarse/journal.jsonl >planted && cp planted coarse/journal.jsonl
}
plant 3 0.001
expect 0 "; 3 less precise than 0.1 %, for which seconds: 13 would do; page" "$program" run coarse.yaml --out coarse
plant '"inf"' 0.001
expect 0 "; 3 less precise than 0.1 %, for which seconds: 13 would do in 2 of them; page" "$program" run coarse.yaml --out coarse --json coarse.json
check "the longest of all is not known" jq -e '.imprecise == {cases: 3, seconds_needed: null}' coarse.json
plant 3 0.0005 # of which nothing is foretold for .1 %
expect 0 "; 3 less precise than 0.1 %; page" "$program" run coarse.yaml --out coarse
sed 's/gl-osmesa/"null"/; s/seconds: 0.1/seconds: 1/' config.yaml >exact.yaml
check "where nothing scatters" "$program" run exact.yaml --out exact --json exact.json
check "nothing is told" test "$(grep -c precise .stdout)" -eq 0
check "three processes, twenty rounds each" test \
  "$(jq -c '.time | [.processes, .rounds, .seconds_needed, .precision < 1e-9]' exact/journal.jsonl | sort -u)" = '[3,60,null,true]'

# Who asks for more precision than an earlier call did has the cases timed again, once: what runs out of its seconds would
# do so again.
"$program" run config.yaml --out finer --quiet --precision 50%
check "coarse, and three" test "$(wc -l <finer/journal.jsonl)" -eq 3
for lines in 6 6; do
  "$program" run config.yaml --out finer --quiet --precision 0.1% --json finer.json
  check "the finer wish is measured, once" test "$(wc -l <finer/journal.jsonl)" -eq "$lines"
  check "and what it did not reach is told" test "$(jq .imprecise.cases finer.json)" -eq 3
done
"$program" run config.yaml --out finer --quiet --precision 50%
check "a coarser wish is content" test "$(wc -l <finer/journal.jsonl)" -eq 6

# What a precision is.
for bad in 3 '3 %' 0.05% 60% -3% nan% % three%; do
  sed "s/seconds: 0.1/precision: \"$bad\"/" config.yaml >bad.yaml
  expect 2 "bad.yaml:6:22: '$bad' is no precision: write a percentage, such as 3%, within 0.1% .. 50%" "$program" run bad.yaml --out bad
  expect 2 "--precision: '$bad' is no precision" "$program" run config.yaml --out bad "--precision=$bad"
  expect 2 "--precision: '$bad' is no precision" "$program" shot --technique none --scene corner "--precision=$bad"
done
check "nothing was begun" test ! -e bad
check "shot" "$program" shot --technique none --scene corner --backend null --size 16x9 --reference-spp 0 --precision 7% --json shot.json
check "its wish" test "$(jq '.time.precision_wanted == 0.07 and (.time | has("rounds_file") | not)' shot.json)" = true

# A process that dies while it only times costs its rounds: it is told, and another takes its place. The first letter is
# the layout's, the second that of the process that scores.
cat >mortal.yaml <<EOF
name: mortal
scenes: [{name: corner}]
resolutions: [16x9]
backends: ["null"]
techniques: [{name: mortal}, {name: none}]
measure: {seconds: 0.05, error: false, images: false}
EOF
export MORTAL=$folder/fates
run_mortal() { # FATES
  printf %s "$1" >"$MORTAL"
  "$program" run mortal.yaml --out mortal --fresh --quiet --module "$modules/mortal.so"
}
times() { jq -c '[.technique, .status, .time.processes, (.time.slots | length)]' mortal/journal.jsonl | sort | paste -sd' '; }
expect 0 " and its block: process 1 is lost: crashed (signal 6" run_mortal '..x'
check "both are there" test "$(times)" = '["mortal","ok",3,4] ["none","ok",3,4]'
check "of the good ones" test "$(zstdcat mortal/rounds/* | jq -sc 'map(.process) | unique')" = '[0,2,3]'
run_mortal '..xx' 2>told
check "two are lost, and each is told" test "$(grep -c 'is lost: crashed' told)" -eq 2
check "each is tried alone" test "$(times)" = '["mortal","ok",3,3] ["none","ok",3,3]'
run_mortal '..xx.xx' 2>told
check "what dies alone as well has failed" test "$(times)" = '["mortal","failed",null,0] ["none","ok",3,3]'
check "with its reason" test "$(jq -r 'select(.status == "failed").reason' mortal/journal.jsonl | grep -c '^crashed (signal 6')" -eq 1
run_mortal '.x' 2>told
check "who dies before he has scored is tried alone as ever" test "$(times)" = '["mortal","ok",3,3] ["none","ok",3,3]'
sed -i 's/seconds: 0.05/time: false/' mortal.yaml
check "without times there is one process" run_mortal '..x'
check "and no rounds" test -z "$(ls mortal/rounds)"

# One measuring process a machine: another one waits while this one has the lock.
export AOBUDGET_LOCK=$folder/one
exec 9>one
flock 9
echo 4711 >&9
"$program" run exact.yaml --out waiting --quiet 2>waited 9>&- &
pid=$!
for _ in $(seq 600); do [ -s waited ] && break; sleep 0.1; done
sleep 0.3
check "it waits" kill -0 "$pid"
check "and measures nothing" test ! -s waiting/journal.jsonl
exec 9>&-
check "it measures when it may" wait "$pid"
check "all of it" test "$(wc -l <waiting/journal.jsonl)" -eq 3
check "it said for whom" grep -qE '^aobudget: waiting for process 4711, which has measured since [0-9:]{8}: one at a time on a machine \(.*/one\)$' waited
check "once" test "$(wc -l <waited)" -eq 1
AOBUDGET_LOCK=$folder expect 2 "cannot be used as the lock of measuring" "$program" run exact.yaml --out locked --quiet
sed 's/seconds: 1/time: false/' exact.yaml >untimed.yaml
AOBUDGET_LOCK=$folder check "what is not timed needs no lock" "$program" run untimed.yaml --out untimed --quiet
finish
