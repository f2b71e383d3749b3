#!/usr/bin/env bash
# `papers`: a row that runs, one that cannot, and input that is wrong.
source "$(dirname "$0")/lib.sh"
check "a cheap row" "$program" papers --quick --quiet --filter alchemy-epsilon --out "$folder/out" --json "$folder/a.json"
check "its document" jq -e '.quick and (.rows | length == 1) and (.rows[0].measured | length == 4)' "$folder/a.json"
check "rows without a run" "$program" papers --quiet --filter devices --out "$folder/out" --json "$folder/b.json"
check "their verdict" jq -e 'all(.rows[]; .verdict == "needs a device model" and .reason != "")' "$folder/b.json"
check "the table" grep -q "hbao-devices" "$folder/out/papers.md"
expect 2 "no row's name holds 'nothing'" "$program" papers --filter nothing --out "$folder/out"

mkdir -p "$folder/moved/bin" "$folder/moved/share/aobudget/papers"
cp "$program" "$folder/moved/bin/aobudget"
expect 2 "alchemy-beta.yaml: not found" "$folder/moved/bin/aobudget" papers --filter alchemy-beta --out "$folder/out"
sed 's/name: alchemy,/name: gone,/' "$(dirname "$0")/../../configs/papers/alchemy-beta.yaml" \
  >"$folder/moved/share/aobudget/papers/alchemy-beta.yaml"
code=0
"$folder/moved/bin/aobudget" papers --quiet --filter alchemy-beta --out "$folder/out" --json "$folder/c.json" || code=$?
check "a row that cannot be run: 3" test $code -eq 3
check "and why" jq -e '.rows[0].verdict == "could not be run" and (.rows[0].reason | contains("gone"))' "$folder/c.json"
finish
