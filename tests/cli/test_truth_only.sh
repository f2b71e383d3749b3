#!/usr/bin/env bash
# `run --truth-only`: the truths of a plan, in the cache, so that a run of it traces nothing.
source "$(dirname "$0")/lib.sh"
cd "$folder"
cat >sweep.yaml <<'YAML'
name: sweep
scenes: [{name: corner, views: [front, far]}, {name: passing_box, motion: {frames: 3}}]
resolutions: [64x36]
backends: [vulkan, "null"]
options: {bent_normal: [off, on], lit: [off, on]}
measure: {time: false, images: false}
target: [{radius: 0.5}, {radius: 1, weighting: uniform}]
reference: {spp: 4}
techniques:
  - {name: none}
  - {name: gtao, sweep: [{param: slices, values: [1, 2]}, {param: radius, values: [0.5, 1]}]}
YAML
# What was traced or cast; the names are those of what it depends on.
traced() { find "$1" -name 'gbuffer-*' -o -name 'visibility-*' | sed 's|.*/||' | sort; }
marks() { (cd "$1" && find . -type f | sort | xargs stat -c '%n %i %y'); } # a file that is made again is another
errors() { jq -cS '[.key, .errors, .sequence]' "$1/journal.jsonl" | sort; }

export AOBUDGET_CACHE=$folder/fresh
"$program" run sweep.yaml --out without --quiet # `none` has no bent normals, and `null` draws nothing
check "a run without" test $? -eq 3
traced "$AOBUDGET_CACHE" >needed

export AOBUDGET_CACHE=$folder/cache
"$program" run sweep.yaml --truth-only --json truths.json 2>told
check "three views" jq -e '.views == 3 and .failed == [] and .name == "sweep" and .seconds > 0' truths.json
check "one line says it" grep -q "^aobudget: 3 of 3 views have their truths in $AOBUDGET_CACHE (" told
check "there is no more" test "$(wc -l <told)" -eq 1
check "it has made what the run needs, and nothing else" diff needed <(traced "$AOBUDGET_CACHE")
check "no folder was made" test ! -e results
marks "$AOBUDGET_CACHE" >before
"$program" run sweep.yaml --out with --quiet
check "a run with" test $? -eq 3
check "has traced nothing" diff before <(marks "$AOBUDGET_CACHE")
check "and has the same errors" diff <(errors without) <(errors with)
check "36 of them have one" test "$(jq -c 'select(.error.rmse > 0)' with/journal.jsonl | wc -l)" -ge 36

# A run of a part needs no more, whatever else is there: bent truths serve other cases too, but not where none is measured.
export AOBUDGET_CACHE=$folder/bent
sed 's/bent_normal: \[off, on\]/bent_normal: [on]/' sweep.yaml >bent.yaml
check "truths of bent normals" "$program" run bent.yaml --truth-only --quiet
check "then of all" "$program" run sweep.yaml --truth-only --quiet
marks "$AOBUDGET_CACHE" >before
"$program" run sweep.yaml --filter bent_normal=off --out plain --quiet
check "a run of the others alone traces nothing" diff before <(marks "$AOBUDGET_CACHE")
check "though it ran" test "$(jq -s "map(select(.status == \"ok\")) | length" plain/journal.jsonl)" -ge 12
export AOBUDGET_CACHE=$folder/shards
for i in 1 2 3; do check "truths of shard $i" "$program" run sweep.yaml --truth-only --shard $i/3 --quiet; done
check "are those of all" diff needed <(traced "$AOBUDGET_CACHE")

# A technique that cannot be asked is no technique that needs nothing.
{ sed '/sweep:/d; s/backends: .*/backends: ["null"]/; /^options/d' sweep.yaml; echo '  - {name: crash_build}'; } >crash.yaml
"$program" run crash.yaml --truth-only --module "$AOBUDGET_BUILD/tests/modules/crash_build.so" --quiet --json crash.json 2>told
check "its death is told" test $? -eq 3 -a "$(grep -c crash_build told)" -ge 1
check "in the document too" jq -e '.views == 3 and (.failed | length) == 1' crash.json

# A shard or a filter has fewer views; what another technique claims is its own.
export AOBUDGET_CACHE=$folder/part
check "a filter" "$program" run sweep.yaml --truth-only --filter corner/far --quiet --json part.json
check "has one view" jq -e '.views == 1' part.json
check "and less in the cache" test "$(traced "$AOBUDGET_CACHE" | wc -l)" -gt 0 -a "$(comm -13 needed <(traced "$AOBUDGET_CACHE") | wc -l)" -eq 0 -a "$(traced "$AOBUDGET_CACHE" | wc -l)" -lt "$(wc -l <needed)"

# A view that shows nothing costs itself.
sed 's/^scenes:.*/scenes: [{name: corner, view: front}, {name: corner, eye: [0, 2, 4], target: [0, 9, 9]}]/' sweep.yaml >empty.yaml
export AOBUDGET_CACHE=$folder/empty
expect 3 "no pixel of the view shows a surface" "$program" run empty.yaml --truth-only --quiet --json empty.json
check "the other one is there" jq -e '.views == 2 and (.failed | length) == 1 and (.failed[0] | contains("corner"))' empty.json
sed -i 's/{name: corner, view: front}, //' empty.yaml
"$program" run empty.yaml --truth-only --quiet 2>told
check "none is left: a usage error" test $? -eq 2
check "and a line says it" grep -q 'no view of empty.yaml has its truths: the warnings say why' told

expect 2 "run: --truth-only makes no folder, times nothing and opens no device: it takes no --out" "$program" run sweep.yaml --truth-only --out x
expect 2 "run: --truth-only makes no folder" "$program" run sweep.yaml --truth-only --fresh
expect 2 "run: --truth-only makes no folder" "$program" run sweep.yaml --truth-only --device 1
expect 2 "no case of sweep.yaml matches 'nix'" "$program" run sweep.yaml --truth-only --filter nix
{ sed '/^options/d; /sweep:/d; s/^reference.*/effects: auto/' sweep.yaml; echo '  - {name: gtao}'; } >auto.yaml
expect 2 "auto.yaml: effects: auto chooses its cases by what it measures" "$program" run auto.yaml --truth-only
finish
