#!/usr/bin/env bash
# What the program is started with: closed descriptors and limits of the user's own.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
shot=("$program" shot --technique none --scene corner --backend null --size 32x18 --reference-spp 0)

# Without standard input: as with an empty one. (`expect` closes nothing, so the descriptor is closed within.)
closed() { # REDIRECTION... COMMAND: with these descriptors closed
  local how=$1
  shift
  bash -c "exec \"\$@\" $how" _ "$@"
}
for how in '<&-' '>&-' '2>&-' '<&- 2>&-' '<&- >&- 2>&-'; do
  rm -f record.json
  check "a shot with $how" closed "$how" "${shot[@]}" --quiet --json record.json
  check "is a whole one" test "$(jq -r .status record.json)" = ok
done
check "nothing is said on a closed standard output" bash -c "! '$program' --version >&- 2>said"
check "but it is told" grep -q 'standard output: cannot write' said

# A message for a closed descriptor must not land in the file that took its number. A mesh far from its origin gives a
# warning, and the run a summary.
awk 'BEGIN { for (i = 0; i < 3; i++) printf "v %.1f %d %d\n", 100000 + (i == 1), 0, i == 2; print "f 1 3 2" }' >far.obj
cat >config.yaml <<EOF
name: closed
scenes: [{file: far.obj}]
resolutions: [32x18]
backends: ["null"]
techniques: [{name: gtao, params: {slices: [1, 2]}}]
measure: {time: false}
reference: {spp: 2}
EOF
check "the mesh gives a warning" bash -c "'$program' run config.yaml --out warned 2>&1 | grep -q 'warning: .*far.obj'"
for how in '2>&-' '<&- >&- 2>&-'; do
  check "a run with $how" closed "$how" "$program" run config.yaml --out out --fresh
  check "its journal has nothing but records" test "$(jq -r .status out/journal.jsonl | tr '\n' ' ')" = "ok ok "
  check "byte for byte" test "$(grep -c '^{.*}$' out/journal.jsonl)" -eq "$(wc -l <out/journal.jsonl)"
done

# The user's limits are kept where they are narrower, and stop nobody: hard ones cannot be raised. AddressSanitizer cannot run
# under a limit of memory; there base/limits does the same for a child alone.
check "with a limit of core files" bash -c 'ulimit -c 0 && exec "$@"' _ "${shot[@]}"
if [ -z "${AOBUDGET_SANITIZED:-}" ]; then
  check "with 3.5 GB of memory" bash -c 'ulimit -v 3500000 && exec "$@"' _ "${shot[@]}"
  check "a mesh too" bash -c 'ulimit -v 3500000 && exec "$@"' _ "${shot[@]/corner/far.obj}"
fi

# What a view needs of memory is judged before it is taken, against what the machine has or `ulimit -m` leaves (which the kernel
# does not hold). First the picture alone, 1920 x 1080 x 72 bytes and one truth; then the surface that is rebuilt from it.
view() { # KILOBYTES SIZE
  bash -c "ulimit -m $1 && exec \"\$@\"" _ "$program" shot --technique gtao --scene plane --backend null --size "$2" --reference-spp 2
}
expect 2 "scene 'plane': a view of 1920x1080 pixels with a guard band of 0 and 2 visibilities needs 0.166 GB of memory, and it may take 0.102 GB: lower the resolution or the guard band, or give fewer targets" view 100000 1920x1080
expect 2 "GB of memory, and it may take 0.205 GB: lower the resolution or the guard band" view 200000 960x540
check "which is the screen-space bound's" grep -q "scene 'plane': screen-space bound of 960x540 pixels: its [0-9]* triangles need 0\.[23]" "$folder/.stderr"
check "a smaller one fits" view 100000 96x54
finish
