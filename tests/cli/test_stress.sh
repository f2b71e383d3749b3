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
# What ends its worker with a good code is no answer either.
"$program" stress --module "$modules/leaver.so" --backend vulkan --property plane_is_open --json left.json >left.txt
check "a module that leaves fails" test $? -eq 1
check "its reason" jq -e '.rows[0].cells[0] | .outcome == "fail" and .reason == "the worker ended without an answer"' left.json

# The program's own techniques, and what measures them.
"$program" stress --quick --backend vulkan --out quick >quick.txt
check "no technique fails a quick property" test $? -eq 0
check "each technique has its row" jq -e '[.rows[].technique] | length == 9 and (unique | length == 9)' quick/stress.json
check "most pass" jq -e '.counts | .fail == 0 and .pass > 250 and 10 * .["by definition"] <= (.pass + .["by definition"] + .["n/a"])' quick/stress.json
check "the counts are of the cells" jq -e '(.counts | add) == ([.rows[].cells | length] | add)' quick/stress.json
check "who gives no light is not asked for it" jq -e '[.rows[] | select(.technique == "hbao") | .cells[] | select(.property == "irradiance_uniform")] | length == 1 and .[0].outcome == "n/a" and .[0].reason == "it gives no irradiance"' quick/stress.json
check "who gives light is asked" jq -e '[.rows[] | select(.technique == "gtao") | .cells[] | select(.property | test("^(bounced|specular|irradiance)_"))] | length >= 12 and all(.[]; .outcome == "pass")' quick/stress.json
check "every cell has its command" jq -e '[.rows[] as $r | $r.cells[] | .command == "aobudget stress --technique \($r.technique) --backend vulkan --property \(.property)"] | all' quick/stress.json
check "what is by definition shows its sentence and its place" jq -e '[.rows[].cells[] | select(.outcome == "by definition")] | length > 0 and all(.[]; .declared and .where != "" and .reason != .where and .image)' quick/stress.json
check "its image is there" test -s "quick/images/$(jq -r '[.rows[].cells[] | select(.image)][0].image' quick/stress.json)"
check "the page has its picture" grep -q '<img loading="lazy"' quick/index.html
check "no declaration is for nothing" jq -e '[.rows[].cells[] | select(.declared and .outcome == "pass")] == []' quick/stress.json
"$program" stress --property tracer_plane_open --property times_unit --json instruments.json >instruments.txt
check "the instruments are asked without a technique" jq -e '.rows | length == 1 and .[0].technique == null and (.[0].cells | length == 2)' instruments.json
finish
