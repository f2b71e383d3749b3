#!/usr/bin/env bash
# A sweep in parts: `run --shard` and `plan --shard`. Together the parts hold what the whole run holds, in every field but times.
source "$(dirname "$0")/lib.sh"
cd "$folder"
cat >sweep.yaml <<'YAML'
name: sweep
scenes: [{name: corner, views: [front, far]}, {name: plane, view: front}]
resolutions: [64x36]
backends: [vulkan, "null"]
measure: {seconds: 0.05, images: false}
reference: {spp: 2}
techniques:
  - {name: none}
  - {name: gtao, sweep: [{param: slices, values: [1, 2, 3]}, {param: radius, values: [0.5, 1]}]}
YAML

check "the whole" "$program" run sweep.yaml --out whole --quiet
for i in 1 2 3; do check "shard $i" "$program" run sweep.yaml --shard $i/3 --quiet; done

# The journal without what is a time, or whose time it is.
untimed() { cat "${@/%//journal.jsonl}" | jq -cS 'del(.time)' | sort; }
check "three shards are the whole run" diff <(untimed whole) <(untimed results/sweep-?-of-3)
check "it has 42 cases, each once" test "$(untimed results/sweep-?-of-3 | jq -r .key | sort -u | wc -l) $(untimed results/sweep-?-of-3 | wc -l)" = "42 42"
check "every case was timed" jq -es 'all(.[] | select(.status == "ok"); .time.ratio_to_ref > 0)' results/sweep-?-of-3/journal.jsonl
check "no shard has all, none is empty" test "$(cat results/sweep-?-of-3/journal.jsonl | wc -l)" -eq 42 -a "$(find results -name journal.jsonl -size +0 | wc -l)" -eq 3
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
check "it is whole again" diff <(untimed whole) <(untimed results/sweep-?-of-3)
check "a filter" "$program" run sweep.yaml --shard 2/3 --filter slices=2 --out some --quiet
check "leaves a part of the shard" diff <(jq -r 'select(.params.slices == 2) | .key' results/sweep-2-of-3/journal.jsonl | sort) <(jq -r .key some/journal.jsonl | sort)

# More shards than blocks: what is left for some of them is nothing, which is no error.
"$program" run sweep.yaml --shard 1/1 --filter none --out one --quiet
check "one of one is the whole" test "$(wc -l <one/journal.jsonl)" -eq 6
empty=
for i in $(seq 40); do
  [ -n "$empty" ] || "$program" plan sweep.yaml --shard $i/40 | grep -q '^0 cases' && empty=${empty:-$i}
done
expect 0 "shard $empty/40 of sweep has no case to measure: nothing was written" "$program" run sweep.yaml --shard "$empty/40" --json empty.json
check "it has no folder" test ! -e "results/sweep-$empty-of-40"
check "and says so" jq -e '.folder == null and .cases == 0 and .status.ok == 0' empty.json

# The tasks of an array know which they are.
export SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_MAX=2
check "a task of an array" env SLURM_ARRAY_TASK_ID=1 "$program" run sweep.yaml --shard env --out task --quiet
check "is its shard" diff <(untimed results/sweep-2-of-3) <(untimed task)
expect 2 "--shard: the array of Slurm has 1 tasks from 1 to 1" env SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_COUNT=1 SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_MAX=1 \
  "$program" run sweep.yaml --shard env
check "without the flag the whole is planned" test "$(SLURM_ARRAY_TASK_ID=1 "$program" plan sweep.yaml --json - | jq '.cases | length')" -eq 42

expect 2 "--shard: '4/3' is no shard: give 2/4 for the second of four" "$program" run sweep.yaml --shard 4/3
expect 2 "--shard: 'x' is no shard" "$program" plan sweep.yaml --shard x
expect 2 "no case of sweep.yaml matches 'nix'" "$program" run sweep.yaml --shard 1/3 --filter nix --out nix
sed 's/^reference.*/effects: auto/; /sweep:/d; /name: none/a \  - {name: gtao}' sweep.yaml >auto.yaml
expect 2 "auto.yaml: effects: auto chooses its cases by what it measures" "$program" run auto.yaml --shard 1/3
finish
