#!/usr/bin/env bash
# `papers`: every row runs and stands on the page in docs/, one that cannot run, and input that is wrong.
source "$(dirname "$0")/lib.sh"
root=$(dirname "$0")/../..
check "all rows run" "$program" papers --quick --out "$folder/out" --json "$folder/a.json"
check "each config once, since this is a look" test "$(grep -c 'papers: running .* again' "$folder/.stdout")" -eq 0
check "figures where a row has a config" jq -e '.quick and all(.rows[]; .verdict != "could not be run") and
  ([.rows[] | select(.measured | length > 0)] | length == 22)' "$folder/a.json"
check "each figure in its interval" jq -e 'all(.rows[]; (.measured | length) == (.intervals | length)
  and all([.measured, .intervals] | transpose[]; .[1][0] <= .[0] and .[0] <= .[1][1]))' "$folder/a.json"
check "an interval has some width where there are times, and none where there are not" jq -e '
  (.rows[] | select(.name == "alchemy-vo").intervals[0] | .[0] < .[1]) and
  (.rows[] | select(.name == "alchemy-lod").intervals | all(.[0] == .[1]))' "$folder/a.json"
check "a reason where one is owed" jq -e 'all(.rows[]; (.reason == "") == (.verdict == "reproduced"))' "$folder/a.json"
names() { sed -n 's/^| \([a-z0-9]*-[a-z0-9-]*\) | .*/\1/p' "$1"; }
check "docs/papers.md has these rows" diff <(names "$folder/out/papers.md") <(names "$root/docs/papers.md")
check "rows without a run" "$program" papers --quiet --filter words --out "$folder/out" --json "$folder/b.json"
check "their verdict" jq -e 'all(.rows[]; .verdict == "not judged" and .reason != "")' "$folder/b.json"
check "the table" grep -q "alchemy-words" "$folder/out/papers.md"
mkfifo "$folder/pipe"
cat "$folder/pipe" >"$folder/read.json" &
check "a pipe for the document" timeout 60 "$program" papers --quiet --filter words --out "$folder/out" --json "$folder/pipe"
wait
check "which holds it whole" jq -e '.rows | length == 1' "$folder/read.json"
expect 2 "no row's name holds 'nothing'" "$program" papers --filter nothing --out "$folder/out"
expect 2 "nope.so: cannot open" "$program" papers --filter words --module "$folder/nope.so" --out "$folder/out"
expect 2 "gone/x.json: cannot write" "$program" papers --out "$folder/out" --json "$folder/gone/x.json"
expect 2 "cannot write: it is a folder" "$program" papers --filter words --out "$folder/out" --json "$folder"
expect 2 "a folder's name is empty" "$program" papers --filter words --out ""

mkdir -p "$folder/moved/bin" "$folder/moved/share/aobudget/papers"
cp "$program" "$folder/moved/bin/aobudget"
expect 2 "alchemy-beta.yaml: not found" "$folder/moved/bin/aobudget" papers --filter alchemy-beta --out "$folder/out"
sed 's/name: alchemy,/name: "a|b",/' "$root/configs/papers/alchemy-beta.yaml" \
  >"$folder/moved/share/aobudget/papers/alchemy-beta.yaml"
code=0
"$folder/moved/bin/aobudget" papers --quiet --filter alchemy-beta --out "$folder/out" --json "$folder/c.json" || code=$?
check "a row that cannot be run: 3" test $code -eq 3
check "and why" jq -e '.rows[0].verdict == "could not be run" and (.rows[0].reason | contains("a|b"))' "$folder/c.json"
check "which does not break the table" grep -qF 'a\|b' "$folder/out/papers.md"
finish
