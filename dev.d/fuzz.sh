#!/usr/bin/env bash
# fuzz.sh BUILD [TARGET...] [SECONDS]: runs fuzz targets of tests/fuzz/ that BUILD holds, one after the other: all of them,
# or the named ones, each for SECONDS (60). Each begins with its corpus, and with what earlier calls found worth keeping in
# BUILD/corpus/. One line a target; behind a finding where its input lies and how it is shown again. Exit code: 0 no
# finding, 1 a finding, 2 they cannot be run.
set -uo pipefail
cd "$(dirname "$0")/.."
build=$1
shift
seconds=60 names=()
give_up() { echo "fuzz: $1" >&2; exit 2; }

known=$(ls tests/fuzz/corpus | paste -sd' ')
for word in "$@"; do
  if [[ $word =~ ^[1-9][0-9]*$ ]]; then
    seconds=$word
  elif [[ " $known " == *" $word "* ]]; then
    names+=("$word")
  else
    give_up "there is no target '$word': choose of $known, or none for all; a whole number is the seconds of each"
  fi
done
[ ${#names[@]} -gt 0 ] || read -ra names <<<"$known"

# What the targets write is written in memory, and is gone when they crash.
TMPDIR=$(mktemp -d -p "$([ -w /dev/shm ] && echo /dev/shm || echo /tmp)") || give_up "there is no folder for files"
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT

last() { sed -nE "s/$1/\\1/p" "$2" | tail -n 1; } # EXPRESSION LOG

run() { # NAME: false if there was a finding
  local name=$1 log=build/log/fuzz-$1.log code=0 start=$SECONDS found
  mkdir -p build/log "$build/corpus/$name" "$build/findings"
  touch "$TMPDIR/start"
  "$build/$name" -max_total_time="$seconds" -timeout=25 -rss_limit_mb=4096 -print_final_stats=1 \
    -dict="tests/fuzz/dictionaries/$name.dict" -artifact_prefix="$build/findings/$name-" \
    "$build/corpus/$name" "tests/fuzz/corpus/$name" >"$log" 2>&1 </dev/null || code=$?
  found=$(find "$build/findings" -name "$name-*" ! -name "$name-slow-unit-*" -newer "$TMPDIR/start")
  printf '%-8s %9s executions in %s s, %s edges: %s\n' "$name" "$(last 'stat::number_of_executed_units: *([0-9]+)' "$log")" \
    $((SECONDS - start)) "$(last '.* cov: ([0-9]+) .*' "$log")" "$([ $code -eq 0 ] && echo no finding || echo A FINDING)"
  [ $code -eq 0 ] && return
  grep -hE '^(FAILED: |the line is |SUMMARY: |==[0-9]+==ERROR: |aobudget: error: )|: runtime error: ' "$log" | sed 's/^/  /' | awk '!seen[$0]++'
  if [ -n "$found" ]; then
    while IFS= read -r file; do echo "  shown again by: $build/$name $file"; done <<<"$found"
  else
    echo "  exit code $code without an input that does it: see $log"
  fi
  return 1
}

code=0
for name in "${names[@]}"; do
  run "$name" || code=1
done
exit $code
