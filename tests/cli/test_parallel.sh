#!/usr/bin/env bash
# share/parallel: a sweep in four parts, one of which is killed, gives the journal of the whole run.
command -v parallel >/dev/null || { echo "skipped: GNU parallel is not installed"; exit 0; }
source "$(dirname "$0")/engines.sh"
export PARALLEL_HOME=$folder/parallel
mkdir "$PARALLEL_HOME" && touch "$PARALLEL_HOME/will-cite"
measure_whole
bash "$share/parallel/aobudget-sweep.sh" sweep.yaml >first.log 2>&1 &
killed=$(kill_part)
wait $!
check "a part was killed" test -n "$killed"
check "that one failed, and no other" test "$(awk -F'\t' 'NR > 1 && ($7 || $8) { print $1 }' "$OUT"-of-4-*.joblog)" = "$killed"
check "which is said" grep -q "1 parts failed: call it again" first.log
check "and how much is missing" grep -qE "[0-9]+ of 200 cases of the plan are in none of the folders" first.log
cp "$OUT-$killed-of-4/journal.jsonl" kept
check "it has some cases" test -s kept
bash "$share/parallel/aobudget-sweep.sh" sweep.yaml >second.log 2>&1
check "the next call is done" test $? -eq 0
check "the killed part went on" cmp kept <(head -c "$(wc -c <kept)" "$OUT-$killed-of-4/journal.jsonl")
check "only that one was started again" test "$(awk 'NR > 1' "$OUT"-of-4-*.joblog | wc -l)" -eq 5
check_merged
finish
