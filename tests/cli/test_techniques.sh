#!/usr/bin/env bash
# The page of techniques: written from a run, refused from less; the one in docs/ names all that the program has.
source "$(dirname "$0")/lib.sh"
root=$(realpath "$(dirname "$0")/../..")
cd "$folder"
cat >config.yaml <<EOF2
name: page
scenes: [{name: cornell}, {name: corner}]
resolutions: [48x27]
backends: [null]
techniques: [{name: none}, {name: gtao, sweep: [{param: slices, values: [3, 1]}]}]
measure: {seconds: 0.1}
reference: {spp: 2}
EOF2
check "a run" "$program" run config.yaml --out run --quiet
check "its page" "$program" report run --techniques pages/t.md --quiet
check "a technique" grep -q '^## `gtao`: Ground-truth' pages/t.md
check "its pictures" test -s pages/t/gtao-cornell-front.png
check "an oracle has none" test ! -e pages/t/gtao-corner-front.png
check "the page shows it" grep -qF '](t/gtao-cornell-front.png)' pages/t.md
check "the closed form" grep -q '^| O2 | `corner/front` |' pages/t.md
expect 2 "ends in .md" "$program" report run --techniques pages/t.html
expect 2 "one folder" "$program" report run run --techniques t.md
expect 2 "one folder" "$program" report run --techniques t.md --out there
expect 2 "nowhere" "$program" report nowhere --techniques t.md
sed -i 's/"techniques"/"others"/' run/run.json
expect 2 "describes no techniques" "$program" report run --techniques t.md

page=$root/docs/techniques.md
names() { # "TECHNIQUE PARAMETER..." a line, from the document's indentation
  awk '
    /^  "options"/ { exit }
    /^      "name"/ { gsub(/[",]/, ""); printf "%s%s", lines++ ? "\n" : "", $2 }
    /^          "name"/ { gsub(/[",]/, ""); printf " %s", $2 }
    END { print "" }' techniques.json
}
"$program" list techniques --json techniques.json
check "there are techniques" test "$(names | wc -l)" -ge 4
check "with parameters" grep -q '^gtao radius falloff ' <(names)
check "the config plans" "$program" plan "$root/configs/techniques.yaml" --quiet
"$program" plan "$root/configs/techniques.yaml" >plan.txt
while read -r name params; do
  check "configs/techniques.yaml has $name" grep -q "/[a-z]* $name " plan.txt
  check "docs/techniques.md has $name: run ./dev docs" grep -q "^## \`$name\`: " "$page"
  sed -n "/^## \`$name\`: /,/^## /p" "$page" >section
  for param in $params; do
    check "docs/techniques.md has $name's $param: run ./dev docs" grep -q "^| \`$param\` |" section
  done
done < <(names)
# The table of defaults has every technique on every listed view but those of the scenes that are for shading.
shaded='matte_white_room matte_dark_room gallery coloured_walls window_room rocks scattered_rocks thicket open_sky passing_box'
"$program" plan "$root/configs/defaults.yaml" >plan.txt
"$program" list scenes --json scenes.json
while read -r place; do
  check "docs/defaults.md has $place: run ./dev docs" grep -q "^| \`$place\` |" "$root/docs/defaults.md"
  while read -r name _; do
    check "configs/defaults.yaml has $place $name" grep -q "$place $name " <(sed 's/$/ /' plan.txt)
    check "docs/defaults.md has $name: run ./dev docs" grep -q "^| view |.* \`$name\` |" "$root/docs/defaults.md"
  done < <(names)
done < <(jq -r --arg shaded "$shaded" '.scenes[] | .name as $s | select($shaded | split(" ") | index($s) | not) | .views[] | "\($s)/\(.name)"' scenes.json)
# The page is of the present defaults: a number is where one is, and a choice is one of its texts.
while IFS=$'\t' read -r name param initial; do
  sed -n "/^## \`$name\`: /,/^## /p" "$page" >section
  check "docs/techniques.md has $name's $param = $initial: run ./dev docs" grep -qE "^\| \`$param\` \| \`?$initial( m)?\`? \|" section
done < <(jq -r '.techniques[] | .name as $n | .params[] |
  [$n, .name, (if .choices then .choices[.initial] else .initial end)] | @tsv' techniques.json)
while read -r picture; do
  check "docs/$picture is there" test -s "$root/docs/$picture"
done < <(sed -n 's/^!\[.*](\(.*\))$/\1/p' "$page")
for oracle in O1 O2 O3 O4 O5 O6 O7; do
  check "docs/techniques.md has $oracle" grep -q "^| $oracle | " "$page"
done
finish
