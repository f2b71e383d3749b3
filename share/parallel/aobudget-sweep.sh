#!/bin/bash
# Measures a sweep in parts with GNU parallel: truths, then the parts, one at a time on each machine, then the merge.
#
#   bash aobudget-sweep.sh CONFIG
#
# Call it again after whatever stopped it: parts that ended are not started again, and one that was killed goes on behind the last
# case that its journal has. With several machines, call it in a folder that all of them share under the same path. These
# variables are read:
#   PARTS          into how many parts the sweep is dealt (4)
#   OUT            the folder of the merged run (results/NAME, for NAME.yaml); the parts are OUT-1-of-4 and so on
#   AOBUDGET       the program, by a path that all machines have (aobudget)
#   AOBUDGET_CACHE the folder of the truths, on the shared disk (results/cache)
#   HOSTS          the machines, as --sshlogin takes them: "a,b" (none: this one)
set -u
config=${1:?the config of the sweep}
parts=${PARTS:-4}
out=${OUT:-results/$(basename "$config" .yaml)}
program=${AOBUDGET:-aobudget}
export AOBUDGET_CACHE=${AOBUDGET_CACHE:-$PWD/results/cache}
mkdir -p "$(dirname "$out")" "$(dirname "$AOBUDGET_CACHE")"

# Some cases may be such as no machine can measure. They are told, and are no reason to start the part again.
in_part_is_done() { [ "$1" -eq 0 ] || [ "$1" -eq 3 ]; }

"$program" run "$config" --truth-only --quiet
in_part_is_done $? || exit

# The log of what ended is that of this config as it is now: of another one all parts are to be started.
log=$out-of-$parts-$(md5sum <"$config" | head -c 8).joblog
part=$(printf 'cd %q && AOBUDGET_CACHE=%q %q run %q --shard {}/%q --out %q-{}-of-%q --quiet; code=$?; [ $code -eq 0 ] || [ $code -eq 3 ]' \
  "$PWD" "$AOBUDGET_CACHE" "$program" "$config" "$parts" "$out" "$parts")
# Times are those of a machine that does nothing else, hence one job a machine (-j1).
seq "$parts" | parallel -j1 ${HOSTS:+--sshlogin "$HOSTS"} --joblog "$log" --resume-failed "$part"
failed=$?
[ $failed -eq 0 ] || echo "$0: $failed parts failed: call it again" >&2

"$program" merge "$out"-*-of-"$parts" --out "$out"
