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
# A modelled row's figures from the journal of its run: the two passes of a filter, with as many columns as the text's.
near='def near(a; b): (a - b) * (a - b) <= 1e-14 * b * b;'
check "a modelled row is what its passes take, in the text's picture" jq -e --slurpfile run "$folder/out/model-alchemy/journal.jsonl" "$near"'
  ($run[] | select(.params | .samples_per_band == 4 and .bands == 3 and .blur == 13)) as $case
  | [$case.cache["gtx580-alchemy"].modelled.passes[] | select(.name | startswith("blur"))] as $passes
  | (1280 / $case.width) as $scale
  | def whole(k): [$passes[] | $scale * (.[k] - .launch_ms) + .launch_ms] | add;
    def part(k): $scale * ([$passes[].resources[k]] | add);
  ($passes | length) == 2 and $scale == 16 and (.modelled.rows[] | select(.name == "alchemy-580-filter-12")
    | near(.ms; whole("ms")) and near(.band_ms[0]; whole("low_ms")) and near(.band_ms[1]; whole("high_ms"))
    and near(.parts.alu; part("alu"))
    and near(.parts.texture; part("texture")) and near(.parts.memory; part("memory"))
    and near(.parts.targets; part("targets")) and near(.parts.fills; part("L1")))' "$folder/a.json"
check "a text's time, printed or from frames a second" jq -e "$near"'.modelled.rows | (map({(.name): .text_ms}) | add) as $text
  | near($text["alchemy-580-filter-12"][0]; 0.95) and near($text["alchemy-580-filter-12"][1]; 1)
  and near($text["hbao-8800gt-half-4x4"][1]; 1000 / 81 - 1000 / 127)' "$folder/a.json"
check "a ratio is to the text's time, and bands hold times" jq -e "$near"'[.modelled.rows[] | select(.ms)] | length == 36 and
  all(.[]; near(.ratio; .ms / .text_ms[1]) and .text_ms[0] < .text_ms[1] and .text_ms[1] < .text_ms[2]
  and .band_ms[0] <= .ms and .ms <= .band_ms[1])' "$folder/a.json"
check "a limit is the part that takes longest" jq -e 'all(.modelled.rows[] | select(.ms);
  (.parts | [.alu, .texture, .memory, .targets] | max) as $most | .parts[.limit] // .parts.fills | . >= $most)' "$folder/a.json"
check "a row counts where no reason speaks against it" jq -e '([.modelled.rows[] | select(.counted)] | length == 10) and
  all(.modelled.rows[]; .counted == (.reason == "") and (.ms != null or .ratio == null))' "$folder/a.json"
check "a look has no pairs and no sums" jq -e '.modelled | .pairs == [] and (has("counted") or has("all") | not)' "$folder/a.json"
figures=$(jq -r '.modelled.rows[] | select(.name == "alchemy-580-filter-12") | "\(.ms) \(.band_ms[0]) \(.band_ms[1]) \(.ratio) \(.limit)"' \
  "$folder/a.json" | awk '{ printf "| 1 [0.95, 1.05] | %.3g [%.3g, %.3g] | %.2f | %s |", $1, $2, $3, $4, $5 }')
check "the page has the same figures" grep -qF "| gtx580-alchemy $figures" "$folder/out/papers.md"
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
