#!/usr/bin/env bash
# kill -9 in the middle of a run, again and again: no finished case is measured again, none is lost.
source "$(dirname "$0")/lib.sh"
cd "$folder"
cat >config.yaml <<EOF
name: resume
scenes: [{name: corner}, {name: spheres}, {name: cornell}]
resolutions: [48x27]
backends: [null]
techniques:
  - {name: gtao, sweep: [{param: slices, values: [1, 2, 3, 4]}, {param: steps, values: [2, 4]}]}
  - name: none
measure: {seconds: 0.1, images: false}
reference: {spp: 2}
EOF
keys() { sed -n 's/^{"key":"\([0-9a-f]*\)".*}$/\1/p' out/journal.jsonl 2>/dev/null | sort; }

kills=0
for wait in 0.3 0.5 0.8 1.2 1.6; do
  setsid "$program" run config.yaml --out out --quiet >/dev/null 2>&1 &
  pid=$!
  sleep "$wait"
  kill -9 "-$pid" 2>/dev/null && kills=$((kills + 1))
  wait "$pid" 2>/dev/null
  keys >"keys-$wait"
  check "no case twice" test -z "$(uniq -d "keys-$wait")"
  check "nothing lost" test "$(comm -23 "${last:-/dev/null}" "keys-$wait" | wc -l)" -eq 0
  last=keys-$wait
done
cp out/journal.jsonl before.jsonl 2>/dev/null || touch before.jsonl
# What a kill within a write leaves behind.
printf '{"key":"0123' >>out/journal.jsonl
check "the run is finished" "$program" run config.yaml --out out --quiet
check "27 cases" test "$(keys | uniq | wc -l)" -eq 27
check "no case twice at the end" test -z "$(keys | uniq -d)"
check "finished lines stand as they were" test "$(head -c "$(wc -c <before.jsonl)" out/journal.jsonl | cmp - before.jsonl && echo same)" = same
cp out/journal.jsonl whole.jsonl
check "a finished run measures nothing" "$program" run config.yaml --out out --quiet
check "the journal did not grow" cmp out/journal.jsonl whole.jsonl

# An invalid case has no cache figures, and lacks none.
cat >invalid.yaml <<EOF
name: invalid
scenes: [{name: corner}]
resolutions: [48x27]
backends: [null]
techniques: [{name: crytek_ssao, params: {samples: [8, 12]}}]
measure: {time: false, error: false, images: false, cache: generic}
EOF
"$program" run invalid.yaml --out invalid --quiet 2>/dev/null
check "an invalid case" test "$(jq -c 'select(.status == "invalid") | .cache' invalid/journal.jsonl)" = null
cp invalid/journal.jsonl invalid.jsonl
"$program" run invalid.yaml --out invalid --quiet 2>/dev/null
check "which is finished" cmp invalid/journal.jsonl invalid.jsonl

# A run's folder belongs to the device that it was measured on.
check "the device stands in run.json" test "$(jq -r '.devices.null.class' out/run.json)" = cpu
cp out/run.json good.json
jq '.devices.null.device = "another card"' good.json >out/run.json
expect 2 "out holds a run on another device (null: another card, none, cpu, " \
  "$program" run config.yaml --out out --quiet
jq '.devices.null.cores += 1' good.json >out/run.json
expect 2 "out holds a run on another device (null: none, none, cpu, " "$program" run config.yaml --out out --quiet
check "nothing was touched" cmp out/journal.jsonl whole.jsonl
jq '.devices.null = null' good.json >out/run.json
check "a backend that could not be opened then has measured nothing" "$program" run config.yaml --out out --quiet
jq 'del(.devices)' good.json >out/run.json
check "a folder without devices is one of this build" "$program" run config.yaml --out out --quiet

# A wish changes neither key nor series; what is asked and what it is asked of do.
identity() { jq -c "[.technique, .params, .scene, .$1]" "$2/journal.jsonl" | sort; }
sed 's/seconds: 0.1, images: false/seconds: 0.2, images: true/' config.yaml >wish.yaml
check "another wish" "$program" run wish.yaml --out wish --quiet --filter slices=1
for what in key series; do
  check "a wish is in no $what" test "$(identity $what out | comm -12 - <(identity $what wish) | wc -l)" -eq 6
done
sed 's/spp: 2/spp: 4/' config.yaml >question.yaml
check "another question" "$program" run question.yaml --out question --quiet --filter slices=1
check "is another key" test "$(identity key out | comm -12 - <(identity key question) | wc -l)" -eq 0
check "and the same series" test "$(identity series out | comm -12 - <(identity series question) | wc -l)" -eq 6

# What is wanted and lost is measured again; a page that stands is not drawn again, one that is older than the journal is.
check "with images" "$program" run wish.yaml --out kept --quiet --filter slices=1
stamp() { stat -c %Y.%y "kept/report/index.html"; }
before=$(stamp)
sleep 1.1
check "again" "$program" run wish.yaml --out kept --quiet --filter slices=1
check "nothing is drawn again" test "$(stamp)" = "$before"
touch -d '1 hour ago' kept/report/index.html
check "a page before the journal's end" "$program" run wish.yaml --out kept --quiet --filter slices=1
check "is drawn anew" test "$(stat -c %Y kept/report/index.html)" -gt "$(date -d '10 minutes ago' +%s)"
lines=$(wc -l <kept/journal.jsonl)
rm "kept/$(jq -rs '.[0].image' kept/journal.jsonl)" "kept/$(jq -rs '.[5].error.truth' kept/journal.jsonl)"
check "with an image and a truth lost" "$program" run wish.yaml --out kept --quiet --filter slices=1
check "their cases are measured again" test "$(wc -l <kept/journal.jsonl)" -gt "$lines"
good=$(jq -rs '.[1].image' kept/journal.jsonl)
lines=$(wc -l <kept/journal.jsonl)
printf '\377' | dd of="kept/$good" bs=1 seek=400 conv=notrunc status=none
check "with an image damaged" "$program" run wish.yaml --out kept --quiet --filter slices=1
check "its case is measured again" test "$(tail -n +$((lines + 1)) kept/journal.jsonl | jq -r .image)" = "$good"
truth=$(jq -rs '.[5].error.truth' kept/journal.jsonl)
cp "kept/$truth" truth.exr
truncate -s 300 "kept/$truth"
check "with a truth damaged" "$program" run wish.yaml --out kept --quiet --filter slices=1
check "it is whole again" cmp "kept/$truth" truth.exr
lines=$(wc -l <kept/journal.jsonl)
touch kept/images/.aobudget-0123456789abcdef.part
check "once more" "$program" run wish.yaml --out kept --quiet --filter slices=1
check "nothing is measured" test "$(wc -l <kept/journal.jsonl)" -eq "$lines"
check "what a killed run left half-written is gone" test -z "$(find kept -name '*.part')"
check "and all is there" test -z "$(jq -rs '.[] | .image, .errors[].truth' kept/journal.jsonl | sort -u | while read -r f; do [ -f "kept/$f" ] || echo "$f"; done)"

# A run that goes on is timed by the clock that its folder has, and says why; a fresh one chooses anew.
cat >clock.yaml <<EOF
name: clock
scenes: [{name: corner}]
resolutions: [48x27]
backends: [vulkan]
techniques: [{name: none}, {name: alchemy}]
measure: {error: false, images: false, seconds: 0.05}
EOF
check "half of a run" "$program" run clock.yaml --out clock --quiet --filter none
sed -i 's/"clock":"cpu","clock_reason":""/"clock":"wall","clock_reason":"planted"/' clock/journal.jsonl
check "the plant" grep -q planted clock/journal.jsonl
"$program" run clock.yaml --out clock --quiet 2>said
check "the other half has its clock" test "$(jq -rs 'map(.time.clock + .time.clock_reason) | unique | join(" ")' clock/journal.jsonl)" = wallplanted
check "one warning says why" test "$(grep -c 'vulkan: costs are wall time.*: planted' said)" -eq 1
check "afresh" "$program" run clock.yaml --out clock --quiet --fresh
check "it is the processor's" test "$(jq -rs 'map(.time.clock) | unique | join(" ")' clock/journal.jsonl)" = cpu
echo "$kills kills"
check "at least one kill hit a run" test "$kills" -ge 1
finish
