#!/usr/bin/env bash
# A sweep in parts: `run --shard` and `plan --shard`. Together the parts hold what the whole run holds.
source "$(dirname "$0")/lib.sh"
cd "$folder"
cat >sweep.yaml <<'YAML'
name: sweep
scenes: [{name: corner, views: [front, far]}, {name: plane, view: front}]
resolutions: [64x36]
backends: [vulkan, "null"]
measure: {time: false, images: false}
reference: {spp: 2}
techniques:
  - {name: none}
  - {name: gtao, sweep: [{param: slices, values: [1, 2, 3]}, {param: radius, values: [0.5, 1]}]}
YAML

check "the whole" "$program" run sweep.yaml --out whole --quiet
for i in 1 2 3; do check "shard $i" "$program" run sweep.yaml --shard $i/3 --quiet; done

# The journal, in an order of its own.
records() { cat "${@/%//journal.jsonl}" | jq -cS . | sort; }
check "three shards are the whole run" diff <(records whole) <(records results/sweep-?-of-3)
check "it has 42 cases, each once" test "$(records results/sweep-?-of-3 | jq -r .key | sort -u | wc -l) $(records results/sweep-?-of-3 | wc -l)" = "42 42"
check "no shard has all" test "$(wc -l <results/sweep-1-of-3/journal.jsonl)" -lt 42 -a "$(wc -l <results/sweep-2-of-3/journal.jsonl)" -lt 42
for i in 1 2 3; do
  check "plan says what shard $i has" diff <("$program" plan sweep.yaml --shard $i/3 --json - | jq -r '.cases[].key' | sort) \
    <(jq -r .key results/sweep-$i-of-3/journal.jsonl | sort)
  check "run.json of shard $i asks for these, and knows the whole" jq -e --slurpfile journal results/sweep-$i-of-3/journal.jsonl \
    '.cases == 42 and (.keys | length) == 42 and (.asked | sort) == ([$journal[].key] | sort)' results/sweep-$i-of-3/run.json
done

# A shard goes on as a run does, and a filter leaves a part of it.
head -2 results/sweep-2-of-3/journal.jsonl >kept
cp kept results/sweep-2-of-3/journal.jsonl
check "a shard goes on" "$program" run sweep.yaml --shard 2/3 --quiet
check "and what it had stays" diff kept <(head -2 results/sweep-2-of-3/journal.jsonl)
check "it is whole again" diff <(records whole) <(records results/sweep-?-of-3)
check "a filter" "$program" run sweep.yaml --shard 2/3 --filter slices=2 --out some --quiet
check "leaves some" test -s some/journal.jsonl
check "namely a part of the shard" diff <(jq -r 'select(.params.slices == 2) | .key' results/sweep-2-of-3/journal.jsonl | sort) <(jq -r .key some/journal.jsonl | sort)

# More shards than blocks: some have no case, which is no error.
"$program" run sweep.yaml --shard 1/1 --filter none --out one --quiet
check "one of one is the whole" test "$(wc -l <one/journal.jsonl)" -eq 6
empty=
for i in $(seq 40); do
  [ -n "$empty" ] || "$program" plan sweep.yaml --shard $i/40 | grep -q '^0 cases' && empty=${empty:-$i}
done
check "no case is no error" "$program" run sweep.yaml --shard "$empty/40" --out empty --json empty.json --quiet
check "and is told" jq -e '.folder == "empty" and .cases == 0 and .status.ok == 0' empty.json
check "the folder is there, of this config" jq -e '.cases == 42 and .asked == []' empty/run.json
check "report takes it along" test "$("$program" report empty results/sweep-?-of-3 --out page --json - 2>/dev/null | jq -c '[.planned, .cases, .ok]')" = "[42,42,42]"
sed 's/spp: 2/spp: 4/' sweep.yaml >other.yaml
cp -r results/sweep-1-of-3 old
for i in $(seq 40); do "$program" plan other.yaml --shard $i/40 | grep -q '^0 cases' && break; done
expect 2 "old holds a run of another config" "$program" run other.yaml --shard $i/40 --out old --quiet
check "what it held is there" cmp old/journal.jsonl results/sweep-1-of-3/journal.jsonl
check "unless it is discarded" "$program" run other.yaml --shard $i/40 --out old --fresh --quiet
check "which it is" test ! -s old/journal.jsonl

# A part is no whole, and no run that was stopped; all parts together are a whole.
for i in 1 2 3; do cp -r results/sweep-$i-of-3 good-$i; done
check "the page says what part" grep -q "<strong>A part: $(wc -l <good-1/journal.jsonl) of 42 cases</strong> of sweep. The run was asked for no more" good-1/report/index.html
check "and nothing of a stop" test "$(grep -c Incomplete good-1/report/index.html)" -eq 0
"$program" report good-1 good-2 --out page --quiet
check "two of three parts are not all" test $? -eq 3
cp -r good-2 good-2x
"$program" report good-1 good-2 good-2x --out page --quiet
check "nor if one is there twice" test $? -eq 3
check "all are enough, one of them twice" "$program" report good-1 good-2 good-2x good-3 --out page --quiet --json page.json
check "which counts once" jq -e '.planned == 42 and .ok == 42 and .cases == 42' page.json
check "a part beside the whole adds nothing" "$program" report whole good-1 --out page --quiet --json page.json
check "to what is planned" jq -e '.planned == 42 and .ok == 42' page.json
sed '1s/"status": *"ok"/"status":"failed"/' good-2x/journal.jsonl >bad && cp bad good-2x/journal.jsonl
"$program" report good-1 good-2 good-2x good-3 --out page --quiet
check "what is bad in one of them is not good" test $? -eq 3
check "all of them are" "$program" report good-1 good-2 good-3 --out page --quiet --json page.json
check "each case counts once" jq -e '.planned == 42 and .ok == 42 and .cases == 42' page.json
sed 's/time: false/seconds: 0.05/' sweep.yaml >timed.yaml
"$program" run timed.yaml --shard 1/1 --filter "plane/front gtao radius=0.5 slices=1" --out timed --quiet
"$program" budget timed --ms 1000 >told
check "budget says that it judges a part" grep -q "^a part of the run is judged: $(wc -l <timed/journal.jsonl) of 42 cases were asked for$" told
check "of some cases" test -s timed/journal.jsonl

head -1 good-1/journal.jsonl >cut
cp cut good-1/journal.jsonl
"$program" report good-1 --quiet
check "a part that was stopped is incomplete" grep -q "<strong>Incomplete: 1 of $(jq '.asked | length' good-1/run.json) cases</strong> of sweep" good-1/report/index.html

# The tasks of an array know which they are.
export SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_MAX=2
check "a task of an array" env SLURM_ARRAY_TASK_ID=1 "$program" run sweep.yaml --shard env --out task --quiet
check "is its shard" diff <(records results/sweep-2-of-3) <(records task)
expect 2 "--shard: Slurm says that its tasks are 1 from 1 to 1" env SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_COUNT=1 SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_MAX=1 \
  "$program" run sweep.yaml --shard env
check "without the flag the whole is planned" test "$(SLURM_ARRAY_TASK_ID=1 "$program" plan sweep.yaml --json - | jq '.cases | length')" -eq 42

expect 2 "--shard: '4/3' is no shard: give 2/4 for the second of four" "$program" run sweep.yaml --shard 4/3
expect 2 "--shard: 'x' is no shard" "$program" plan sweep.yaml --shard x
expect 2 "no case of sweep.yaml matches 'nix'" "$program" run sweep.yaml --shard 1/3 --filter nix --out nix
sed 's/^reference.*/effects: auto/; /sweep:/d; /name: none/a \  - {name: gtao}' sweep.yaml >auto.yaml
expect 2 "auto.yaml: effects: auto chooses its cases by what it measures" "$program" run auto.yaml --shard 1/3
finish
