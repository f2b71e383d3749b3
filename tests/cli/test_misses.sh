#!/usr/bin/env bash
# What caches miss of a frame's fetches, from the capture to journal, table and page.
source "$(dirname "$0")/lib.sh"
cd "$folder"
# A device whose order is worked out by hand below: one unit, tiles of 8 x 8 pixels, warps of 8 x 4, quads in them, rows of
# texels in memory, and a first level of 4 sets x 2 lines of 64 bytes.
profile() { # SIZE FLIGHT
  cat <<EOF
title: a device for a test
units: {value: 1, confirmed: "here"}
in_flight: {value: $2, confirmed: "here"}
tile: {value: 8x8, confirmed: "here"}
warp: {value: 8x4, confirmed: "here"}
layout: {value: linear, confirmed: "here"}
levels:
  - {name: L1, size: {value: $1, confirmed: "here"}, line: {value: 64, confirmed: "here"},
     ways: {value: 2, confirmed: "here"}, index: {value: modulo, confirmed: "here"}}
  - {name: L2, size: {value: 2 KiB, confirmed: "here"}, line: {value: 64, confirmed: "here"},
     ways: {value: 4, confirmed: "here"}, index: {value: modulo, confirmed: "here"}}
EOF
}
profile 512 1 >mine.yaml
frame=("$program" cache --technique none --scene corner --view far --size 64x64 --backend gl-osmesa)
check "a frame" "${frame[@]}" --profile ./mine.yaml --json frame.json --quiet
level() { jq ".cache.mine.frame.levels[$1].$2" "$3"; }

# `none` reads the depth once a pixel: 4 bytes, 64 texels a row, so line 4 y + x / 16. In the order of the profile, as
# little-endian numbers.
awk 'BEGIN {
  for (t = 0; t < 64; t++) for (w = 0; w < 2; w++) for (q = 0; q < 8; q++) for (l = 0; l < 4; l++) {
    x = t % 8 * 8 + q % 4 * 2 + l % 2
    y = int(t / 8) * 8 + w * 4 + int(q / 4) * 2 + int(l / 2)
    line = 4 * y + int(x / 16)
    printf "\\x%02x\\x%02x\\x00\\x00", line % 256, int(line / 256)
  }
}' >lines.txt
printf '%b' "$(cat lines.txt)" >lines.u32
check "as many numbers as pixels" test "$(stat -c %s lines.u32)" -eq $((4 * 64 * 64))
check "the stream alone" "$program" cache --lines lines.u32 --sets 4 --ways 2 --index modulo --json lines.json --quiet
for what in accesses misses compulsory capacity conflict; do
  check "the frame's $what are the stream's" test "$(level 0 one.$what frame.json)" -eq "$(jq ".$what" lines.json)"
done
check "the stream has conflicts" test "$(jq .conflict lines.json)" -gt 0
check "with one warp both ends are one" test "$(level 0 one frame.json)" = "$(level 0 most frame.json)"
check "the second level gets what the first missed" test "$(level 1 one.accesses frame.json)" -eq "$(level 0 one.misses frame.json)"
check "the second level's compulsory misses are all lines" test "$(level 1 one.compulsory frame.json)" -eq 256
check "bytes are lines" jq -e '.cache.mine.frame.levels[0].one | .bytes_per_pixel == 64 * .fills_per_pixel and
  .fills_per_pixel == .misses / 4096' frame.json
check "each pixel fetches once" jq -e '.cache.mine.frame | .fetches == 4096 and .distinct == 4096 and .lanes_busy == 1' frame.json
check "the image is that without a trace" test "$(jq .cache.mine.texels_differ frame.json)" -eq 0

# The table says what the record has, and the map adds up, over passes of two sizes.
profile 512 4 >four.yaml
shot=("$program" cache --technique alchemy --scene cornell --size 48x32 --backend gl-osmesa -p divisor=2)
"${shot[@]}" --profile ./four.yaml,generic --out map.exr --json shot.json >told.txt 2>warnings
check "no word of warning" test ! -s warnings
"${shot[@]}" --profile ./four.yaml,generic >table.txt
sum() { "$AOBUDGET_BUILD/exr_sum" "$@"; }
for name in four generic; do
  misses=$(jq ".cache.$name.frame.levels[0].most.misses" shot.json)
  check "the map of $name adds up" awk -v a="$(sum map.exr $name.misses)" -v b="$misses" 'BEGIN { exit !(b > 0 && (a - b) ^ 2 < (1e-4 * b) ^ 2) }'
  check "a picture of $name" test "$(head -c 4 "map-$name.png" | tail -c 3)" = PNG
  check "the file for ParaView of $name is the map" "$AOBUDGET_BUILD/same_vti" "map-$name.vti" $name.misses map.exr $name.misses
  check "the files of $name are named" grep -qxF "$name: misses by pixel are in map.exr, map-$name.png, map-$name.vti" told.txt
  check "the table has $name" grep -qE "^$name: $(jq ".cache.$name.units" shot.json) units?," table.txt
done
check "no map is told of where none is" test "$(grep -c 'misses by pixel' table.txt)" -eq 0
check "the table's misses are the record's" grep -q "  L1     $(jq -r '.cache.generic.frame.levels[0].one |
  100 * .miss_ratio' shot.json | awk '{ printf "%.2f ", $1 }')" table.txt
check "the levels of each pass add up to the frame's" jq -e '.cache[] | . as $p |
  all(range($p.frame.levels | length); . as $l | ([$p.passes[].levels[$l].most.misses] | add) == $p.frame.levels[$l].most.misses)' shot.json
check "a level gets what the one before missed" jq -e '.cache.four.frame.levels |
  .[1].one.accesses == .[0].one.misses and .[1].most.accesses == .[0].most.misses' shot.json

check "both ends of a band are the record's" grep -q "^  L1     $(jq -r '.cache.four.frame.levels[0] |
  "\(100 * .one.miss_ratio) \(100 * .most.miss_ratio)"' shot.json | awk '
  function show(v) { return sprintf(v >= 99.95 ? "%.0f" : v >= 9.995 ? "%.1f" : "%.2f", v) } { print show($1) " .. " show($2) }') " table.txt
check "which are two" jq -e '.cache.four.frame.levels[0] | .one.misses < .most.misses' shot.json

# A sweep: the journal, the columns of cases.csv, the page.
cat >config.yaml <<EOF
name: sweep
scenes: [{name: corner, view: far}]
resolutions: [32x18]
backends: [gl-osmesa, null]
techniques: [{name: gtao, params: {blur: 0}, sweep: [{param: radius, values: [0.5, 1, 2]}]}]
measure: {time: false, error: false, images: false, cache: [generic, ./mine.yaml]}
EOF
profile 512 4 >mine.yaml
check "a sweep" "$program" run config.yaml --out out --quiet
one() { jq -c "select(.backend == \"$1\") | $2" out/journal.jsonl; }
check "every traced case has both profiles" test "$(one gl-osmesa '.cache | map(.status) | unique' | sort -u)" = '["ok"]'
check "what draws nothing says so and stays good" test "$(one null '[.status, .cache.mine.status, (.cache.mine.reason | test("draws nothing"))]' | sort -u)" = '["ok","unsupported",true]'
check "a figure of cases.csv is the journal's" test \
  "$(awk -F, -v name=cache.mine.L2.most.bytes_per_pixel 'NR == 1 { sub(/\r/, ""); for (i = 1; i <= NF; i++) if ($i == name) c = i } /gl-osmesa/ { printf "%.6f\n", $c }' out/report/cases.csv | sort)" = \
  "$(one gl-osmesa '.cache.mine.frame.levels[1].most.bytes_per_pixel' | awk '{ printf "%.6f\n", $1 }' | sort)"
check "which differs from its other end" test "$(one gl-osmesa '.cache.mine.frame.levels[1] | .one.misses == .most.misses' | sort -u)" = false
check "the page has a section" grep -q '<h3>Cache</h3>' out/report/index.html
check "and its charts" test "$(ls out/report/figures | grep -c 'mine-.*-radius.*svg')" -eq 3
cp out/journal.jsonl whole.jsonl
check "a finished run measures nothing" "$program" run config.yaml --out out --quiet
check "the journal did not grow" cmp out/journal.jsonl whole.jsonl
sed -i 's/title: .*/title: the same device/' mine.yaml
check "a title is no number" "$program" run config.yaml --out out --quiet
check "the journal still did not grow" cmp out/journal.jsonl whole.jsonl
profile 1024 4 >mine.yaml
check "another cache is measured again" "$program" run config.yaml --out out --quiet
check "each case once" test "$(wc -l <out/journal.jsonl)" -eq 12
check "with fewer misses" jq -se 'map(select(.backend == "gl-osmesa") | .cache.mine.frame.levels[0].one.misses) |
  .[0] > .[3] and .[2] > .[5]' out/journal.jsonl
# Only the figures of a changed profile are: the case is not timed, scored or drawn again.
sed 's/time: false, error: false, images: false/seconds: 0.1/; s/gl-osmesa, null/gl-osmesa/; s/0.5, 1, 2/1/; s/generic, //' config.yaml >timed.yaml
printf 'reference: {spp: 2}\n' >>timed.yaml
check "a timed run" "$program" run timed.yaml --out timed --quiet
ls timed/rounds >rounds.txt
profile 512 4 >mine.yaml
check "another cache" "$program" run timed.yaml --out timed --quiet
check "another line" test "$(wc -l <timed/journal.jsonl)" -eq 2
check "all but the figures is as it was" test "$(jq -cS 'del(.cache)' timed/journal.jsonl | uniq | wc -l)" -eq 1
check "which has a time" jq -se 'all(.time.seconds > 0)' timed/journal.jsonl
check "the figures are others" jq -se '.[0].cache.mine.frame.levels[0].one.misses < .[1].cache.mine.frame.levels[0].one.misses' timed/journal.jsonl
check "nothing was timed" cmp <(ls timed/rounds) rounds.txt
check "after which it is finished" "$program" run timed.yaml --out timed --quiet
check "with two lines" test "$(wc -l <timed/journal.jsonl)" -eq 2
# A module that dies where it is laid out on that occasion costs these figures only: times, and those of a profile that has not
# changed, stay as they were.
sed 's/{name: gtao.*/{name: mortal}]/; s/cache: \[/cache: [generic, /' timed.yaml >mortal.yaml
die() { printf %s "$1" >fates && MORTAL=$PWD/fates "$program" run mortal.yaml --out mortal --quiet --module "$AOBUDGET_BUILD/tests/modules/mortal.so"; }
nth() { jq -sc ".[$1] | $2" mortal/journal.jsonl; }
check "a timed run of a mortal module" die ""
check "has figures of both" test "$(nth 0 '[.status, .cache.mine.status, .cache.generic.status]')" = '["ok","ok","ok"]'
profile 1024 4 >mine.yaml
check "another cache, and it dies" die x
check "it is told beside the profile" test "$(nth 1 '[.cache.mine.status, (.cache.mine.reason | test("laying out its passes"))]')" = '["failed",true]'
check "a death leaves all but the figures" test "$(jq -cS 'del(.cache)' mortal/journal.jsonl | uniq | wc -l)" -eq 1
check "a death leaves the other profile's figures" test "$(nth 1 .cache.generic)" = "$(nth 0 .cache.generic)"
check "what lacks figures is tried again" die ""
check "and has them" test "$(nth 2 '[.status, .cache.mine.status, .time.seconds > 0]')" = '["ok","ok",true]'
sed 's/, cache: .*/}/' config.yaml >plain.yaml
check "a run without" "$program" run plain.yaml --out plain --quiet
check "has no such member" jq -se 'all(has("cache") | not)' plain/journal.jsonl
check "nor such a section" test "$(grep -c '<h3>Cache</h3>' plain/report/index.html)" -eq 0
check "and the same keys" test "$(jq -r .key plain/journal.jsonl | sort | paste -sd' ')" = "$(jq -r .key out/journal.jsonl | sort -u | paste -sd' ')"

# Six cases of 576 pixels and two profiles: what a trace and a profile take.
estimate() { "$program" plan "$1" --json - | jq .estimated_s; }
check "the plan foretells it" awk -v a="$(estimate config.yaml)" -v b="$(estimate plain.yaml)" \
  'BEGIN { exit !((a - b - 6 * (0.5 + 576 * (5e-7 + 2 * 2e-6))) ^ 2 < 1e-12) }'

# What cannot be.
sed 's/generic, .*/xbox]}/' config.yaml >wrong.yaml
expect 2 "wrong.yaml:6:61: there is no profile 'xbox'" "$program" plan wrong.yaml
mkdir -p deep
sed 's/ways: {value: 2,/ways: {value: 3,/' mine.yaml >deep/odd.yaml
sed 's|generic, .*|deep/odd.yaml]}|' config.yaml >wrong.yaml
expect 2 "wrong.yaml:6:61: deep/odd.yaml:9:" "$program" plan wrong.yaml
cp mine.yaml deep/mine.yaml
sed 's|generic, .*|mine.yaml, deep/mine.yaml]}|' config.yaml >wrong.yaml
expect 2 "two profiles are called 'mine'" "$program" plan wrong.yaml
expect 2 "null: no trace" "$program" cache --technique none --scene corner --size 32x18 --backend null --profile generic
profile "256 MiB" 4 | sed '/L1/s/line: {value: 64/line: {value: 16/; s/ways: {value: 2,/ways: {value: 32,/' >large.yaml
expect 2 "profile large: its simulation may take" bash -c 'ulimit -S -m 524288; "$@"' _ \
  "$program" cache --technique none --scene corner --size 32x18 --backend gl-osmesa --profile ./large.yaml
expect 2 "--profile is needed" "$program" cache --technique none --scene corner
expect 2 "not both" "$program" cache --technique none --scene corner --lines lines.u32
finish
