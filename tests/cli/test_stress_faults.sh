#!/usr/bin/env bash
# stress: each module of tests/broken fails the property that names its fault and what its list in caught.txt says, and of the
# other properties that the lists name none. The modules are those of the first part of that file.
source "$(dirname "$0")/lib.sh"
modules=$AOBUDGET_BUILD/tests/broken
sed '/^# --/,$d; /^#/d' "$(dirname "$0")/../broken/caught.txt" >"$folder/lists"
cd "$folder"

# The properties that name a fault: all modules are asked all of them.
named=$(sed -n 's/^[a-z_]*: \([a-z_]*\).*/\1/p' lists | sort -u)
flags=()
for property in $named; do flags+=(--property "$property"); done
check "there are sixteen faults" test "$(wc -w <<<"$named")" -ge 16

ask() { # MODULE: its answers into MODULE.json; one that fails ends with 1
  "$program" stress --quiet --module "$modules/$1.so" --backend vulkan "${flags[@]}" --json "$1.json" >"$1.txt" 2>&1 || true
}
declare -a running=()
while IFS=: read -r module _; do
  ask "$module" &
  running+=($!)
  [ ${#running[@]} -lt 2 ] || { wait "${running[0]}"; running=("${running[@]:1}"); }
done <lists
wait

while IFS=: read -r module wanted; do
  for property in $wanted; do
    grep -qx "$property" <<<"$named" || continue
    check "a fault is caught: $module fails $property" jq -e --arg p "$property" 'any(.rows[].cells[]; .property == $p and .outcome == "fail")' "$module.json"
  done
  for property in $named; do
    [[ " $wanted " == *" $property "* ]] && continue
    check "$module does not fail $property" jq -e --arg p "$property" '[.rows[].cells[] | select(.property == $p)] | length == 1 and all(.[]; .outcome != "fail")' "$module.json"
  done
done <lists
finish
