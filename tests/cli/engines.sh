# Sourced by the tests of share/slurm and share/parallel: a sweep of 200 cases, its whole run, and what is asked of the merged one.
source "$(dirname "$0")/lib.sh"
share=$(realpath "$(dirname "$0")/../../share")
cd "$folder"
cat >sweep.yaml <<'YAML'
name: sweep
scenes: [{name: corner, views: [front, far]}]
resolutions: [96x54]
backends: [vulkan]
measure: {time: false}
reference: {spp: 4}
target: {radius: 1}
techniques:
  - {name: none}
  - {name: gtao, sweep: [{param: slices, values: [1, 2, 3, 4]}, {param: radius, values: [0.25, 0.5, 0.75, 1, 1.5, 2]}, {param: steps, values: [2, 4, 6]}]}
  - {name: hbao, sweep: [{param: directions, values: [4, 6, 8]}, {param: radius, values: [0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4, 5]}]}
YAML
export AOBUDGET_CACHE=$folder/cache AOBUDGET=$program PARTS=4 OUT=$folder/merged

sizes=() # cases of each part
measure_whole() {
  for part in 1 2 3 4; do
    sizes[part]=$("$program" plan sweep.yaml --shard $part/4 --json - | jq '.cases | length')
  done
  "$program" run sweep.yaml --out whole --quiet
  check "the whole has 200 cases" test "$(wc -l <whole/journal.jsonl)" -eq 200
}

# kill_part: waits until a part has some cases and lacks some, kills its program, and prints the part's number.
kill_part() {
  local process lines part
  for _ in $(seq 1200); do
    for part in 1 2 3 4; do
      lines=$(cat "$OUT-$part-of-4/journal.jsonl" 2>/dev/null | wc -l)
      process=$(pgrep -of "^$program run sweep.yaml --shard $part/4 --out $OUT-$part-of-4 ") || continue
      if [ "$lines" -ge 3 ] && [ "$lines" -lt $((sizes[part] / 2)) ] && kill -9 "$process"; then
        echo "$part"
        return
      fi
    done
    sleep 0.05
  done
}

# Of a record all but times, of which this sweep has none.
check_merged() {
  check "the merged journal is that of the whole run" cmp whole/journal.jsonl "$OUT/journal.jsonl"
  check "with all images and truths" diff <(cd whole && sha256sum images/* truths/* graphs/*) <(cd "$OUT" && sha256sum images/* truths/* graphs/*)
  check "a report of it is complete" "$program" report "$OUT" --quiet
}
