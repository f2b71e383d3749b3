#!/usr/bin/env bash
# The journal under bad luck: zeros after a loss of power, a full disk, somebody who takes it away, a stop before its first line.
source "$(dirname "$0")/lib.sh"
cd "$folder"
meddle=$AOBUDGET_BUILD/tests/modules/meddle.so
export AOBUDGET_CACHE=$folder/cache
cat >config.yaml <<EOF
name: journal
scenes: [{name: corner}, {name: spheres}]
resolutions: [48x27]
backends: ["null"]
techniques:
  - {name: gtao, sweep: [{param: slices, values: [1, 2, 3]}, {param: steps, values: [2, 4]}]}
measure: {seconds: 0.02, images: false}
reference: {spp: 2}
EOF
run=("$program" run config.yaml --quiet --out)
check "a run" "${run[@]}" good
report_json() { "$program" report "$1" --quiet --json report.json 2>/dev/null; }

# A line that is zeros: every other one counts, and its case alone is measured again. Twelve lines, the fourth is lost.
zero_line() { # FOLDER LINE: as many zeros as the line has bytes
  awk -v line="$2" 'NR == line { gsub(/./, "\001") } { print }' "$1/journal.jsonl" | tr '\001' '\000' >zeroed
  cat zeroed >"$1/journal.jsonl"
}
cp -r good zeros && zero_line zeros 4
check "the line is zeros" test "$(sed -n 4p zeros/journal.jsonl | tr -d '\000\n' | wc -c)" -eq 0
expect 3 "zeros/journal.jsonl: line 4 of 12 is damaged and passed over" "$program" report zeros --quiet --json report.json
check "the report has all others" test "$(jq -c '[.planned, .cases, .ok]' report.json)" = '[12,11,11]'
check "the page says it too" grep -q 'line 4 of 12 is damaged' zeros/report/index.html
expect 0 "zeros/journal.jsonl: line 4 of 12 is damaged and passed over" "${run[@]}" zeros
check "one case is measured again" test "$(wc -l <zeros/journal.jsonl)" -eq 13
check "the one that was lost" test "$(tail -n 1 zeros/journal.jsonl | jq -r .key)" = "$(sed -n 4p good/journal.jsonl | jq -r .key)"
cp zeros/journal.jsonl before
expect 0 "line 4 of 13 is damaged" "${run[@]}" zeros
check "nothing is measured again" cmp zeros/journal.jsonl before
report_json zeros
check "the report is whole" test "$(jq -c '[.planned, .cases, .ok]' report.json)" = '[12,12,12]'

# Zeros before a line that was written after the start: what follows them is kept.
cp -r good before-line
{ head -n 11 good/journal.jsonl && head -c 4096 /dev/zero && tail -n 1 good/journal.jsonl; } >before-line/journal.jsonl
cp before-line/journal.jsonl before
expect 0 "line 12 of 12 is damaged" "${run[@]}" before-line
check "no case is measured again" cmp before-line/journal.jsonl before

# Stopped between the two files that a run begins with, or before its first line: an empty run, of any config.
mkdir empty && : >empty/journal.jsonl
check "an empty journal without run.json" "${run[@]}" empty
check "is a whole run" test "$(wc -l <empty/journal.jsonl)" -eq 12
mkdir other && : >other/journal.jsonl && sed 's/"config_hash": "./&x/' good/run.json >other/run.json
check "an empty journal of another config" "${run[@]}" other
cp -r good lone && rm lone/run.json
expect 2 "lone holds a run whose run.json is missing" "${run[@]}" lone

# A disk that is full, for which a limit of the files' size stands: the cause is told, and what was stored stays. Lines have
# about 2 KB, so some fit into 16 KB; the others follow when there is room. All else that a run needs lies in the cache.
cp -r good full && : >full/journal.jsonl
limited() { (ulimit -f 16 && exec "${run[@]}" full); }
expect 2 "full/journal.jsonl: cannot write: File too large" limited
stored=$(wc -l <full/journal.jsonl)
check "some lines were stored" test "$stored" -ge 2 -a "$stored" -lt 12
check "they are whole" test "$(jq -r .key full/journal.jsonl | wc -l)" -eq "$stored"
cp full/journal.jsonl before
check "with room again" "${run[@]}" full
check "each case has one line" test "$(wc -l <full/journal.jsonl)" -eq 12
check "and the stored ones stand" test "$(head -n "$stored" full/journal.jsonl | cmp - before && echo same)" = same

# Somebody takes it away while the run goes on: it ends at the next line, with a line that says what happened. The module
# does it where it lays out its passes, and the other cases have lines by then.
cat >meddle.yaml <<EOF
name: meddle
scenes: [{name: corner}]
resolutions: [48x27]
backends: ["null"]
techniques: [{name: none}, {name: gtao}, {name: meddle}]
measure: {time: false, error: false, images: false}
EOF
taken() { # 'WHAT THE MODULE DOES' 'TEXT'
  rm -rf out moved
  check "lines" "$program" run meddle.yaml --out out --quiet --module "$meddle" --filter gtao
  MEDDLE="$1" expect 2 "$2" "$program" run meddle.yaml --out out --quiet --module "$meddle"
}
taken 'rm out/journal.jsonl' 'out/journal.jsonl: it was deleted or replaced during the run, and its cases with it'
taken 'rm -rf out' 'out/journal.jsonl: it was deleted or replaced'
taken 'cp out/journal.jsonl moved && mv moved out/journal.jsonl' 'out/journal.jsonl: it was deleted or replaced'
taken ': >out/journal.jsonl' 'out/journal.jsonl: somebody cut it from'
taken '[ -e moved ] || mv out moved' 'out/journal.jsonl: it or its folder was moved during the run: put it back and run again'
check "what was measured is where it went" test "$(jq -r .technique moved/journal.jsonl)" = gtao
check "put back" mv moved out
check "it goes on" "$program" run meddle.yaml --out out --quiet --module "$meddle"
check "and has all cases" test "$(jq -r .technique out/journal.jsonl | sort | tr '\n' ' ')" = "gtao meddle none "

# A reason is always there and always text, and names its cause: the path gives way in its middle, between characters, at
# an even and at an odd place.
long=$(printf 'ä%.0s' {1..100})
mkdir -p "$long/$long/$long/$long"
for name in a ab; do
  echo rubbish >"$long/$long/$long/$long/$name.obj"
  sed "s|scenes: .*|scenes: [{file: $long/$long/$long/$long/$name.obj}]|" config.yaml >long.yaml
  expect 2 "nothing could run" "$program" run long.yaml --quiet --out "long-$name"
  jq -r .reason "long-$name/journal.jsonl" | iconv -f UTF-8 -t UTF-8 >reasons
  check "every case has a reason" test "$(wc -l <reasons)" -eq 6
  check "which begins with the path, once, and ends with the cause" \
    test "$(grep -c "^ä[ä/]*\.\.\.[ä/]*ä/$name.obj: cannot load: the file is damaged, .* (OBJ-file is too small\.)\$" reasons)" -eq 6
done
finish
