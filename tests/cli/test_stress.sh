#!/usr/bin/env bash
# stress: what it prints and refuses, what it makes of modules that die, and the faults that each property is for.
source "$(dirname "$0")/lib.sh"
here=$(realpath "$(dirname "$0")")
modules=$AOBUDGET_BUILD/tests/modules
cd "$folder"
"$program" stress --list >list
check "the list has the properties" test "$(grep -c '^[a-z0-9_]* (' list)" -ge 60
# Each of the 62 faults has its row, and each property that the table names is one.
docs=$here/../../docs/stress.md
for fault in $(seq 62); do check "fault $fault has a row" grep -q "^| $fault [^|]* | [^|]* |$" "$docs"; done
for name in $(sed -n '/^| fault/,$p' "$docs" | grep -o '`[a-z0-9_]*`' | tr -d '`' | sort -u); do
  [ "$name" = invalid ] || check "the property $name of docs/stress.md exists" grep -q "^$name (" list
done
for name in $(sed -n 's/^\([a-z0-9_]*\) (.*/\1/p' list); do
  check "docs/stress.md names the property $name" grep -qF "\`$name\`" "$docs"
done

expect 2 "there is no 'sky'; see: aobudget stress --list" "$program" stress --property sky
expect 2 "there is no 'metal'; see: aobudget list backends" "$program" stress --backend metal
expect 2 "unknown technique 'gato'" "$program" stress --technique gato
expect 2 "cannot open" "$program" stress --module nothing.so

# A module that dies in build() fails each property, with the cause, and the program goes on.
"$program" stress --module "$modules/crash_build.so" --backend vulkan --property plane_is_open --property plane_any_fov \
  --json crash.json >crash.txt
check "a module that dies fails" test $? -eq 1
check "each property has its reason" jq -e '[.rows[].cells[]] | length == 2 and all(.[]; .outcome == "fail" and (.reason | test("crashed")))' crash.json
finish
