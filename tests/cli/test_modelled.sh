#!/usr/bin/env bash
# Modelled times, from what the shaders execute to record, table and journal.
source "$(dirname "$0")/lib.sh"
cd "$folder"
# A device of round rates: in a ms 1e8 operations of its lanes, 1e7 texels, 1.6e8 bytes into L1, 2e7 bytes of memory, 4e6
# pixels.
profile() { # MEMORY
  cat <<END
title: a device for a test
units: {value: 2, confirmed: "here"}
in_flight: {value: 4, confirmed: "here"}
tile: {value: 8x8, confirmed: "here"}
warp: {value: 8x4, confirmed: "here"}
layout: {value: linear, confirmed: "here"}
rates:
  clock: {value: 1, confirmed: "here"}
  lanes: {value: 100, confirmed: "here"}
  special: {value: 0.25, unverified: "made up"}
  special_blocks: {value: true, confirmed: "here"}
  texture_units: {value: 10, confirmed: "here"}
  tags: {value: 1, confirmed: "here"}
  rops: {value: 4, confirmed: "here"}
  memory: {value: $1, confirmed: "here"}
  launch: {value: 10, confirmed: "here"}
levels:
  - {name: L1, size: {value: 1 KiB, confirmed: "here"}, line: {value: 64, confirmed: "here"},
     ways: {value: 2, confirmed: "here"}, index: {value: modulo, confirmed: "here"},
     fill: {value: 16, confirmed: "here"}, ports: {value: 10, confirmed: "here"}}
  - {name: L2, size: {value: 4 KiB, confirmed: "here"}, line: {value: 64, confirmed: "here"},
     ways: {value: 4, confirmed: "here"}, index: {value: modulo, confirmed: "here"}}
END
}
profile 20 >mine.yaml
shot=("$program" cache --technique alchemy --scene cornell --size 48x32 --backend gl-osmesa -p divisor=2)
check "a frame" "${shot[@]}" --profile generic,./mine.yaml --json shot.json --quiet
"${shot[@]}" --profile generic,./mine.yaml >table.txt
check "a device without rates has no times" jq -e '.cache.generic | .status == "ok" and .modelled == null' shot.json
check "a time for each pass" jq -e '.cache.mine | (.passes | length) > 2 and
  [.passes[].name] == [.modelled.passes[].name]' shot.json

# The formulas of docs/model.md, from the record's own counts; those are printed with nine digits.
near='def near(a; b): (a - b) * (a - b) <= 1e-16 * b * b;'
passes='.cache.mine | . as $p | all(range(.passes | length); . as $i | $p.passes[$i] as $c | $p.modelled.passes[$i] as $m |'
check "alu" jq -e "$near $passes near(\$m.resources.alu; (\$c.operations.alu + 4 * \$c.operations.special) / 1e8))" shot.json
check "L1" jq -e "$near $passes near(\$m.resources.L1; 32 * (\$c.levels[0] | .one.misses + .most.misses) / 1.6e8))" shot.json
check "memory" jq -e "$near $passes near(\$m.resources.memory;
  (32 * (\$c.levels[1] | .one.misses + .most.misses) + \$c.bytes_written) / 2e7))" shot.json
check "targets" jq -e "$near $passes near(\$m.resources.targets; \$c.invocations / 4e6))" shot.json
check "launch" jq -e "$near $passes near(\$m.launch_ms; 0.01))" shot.json
check "texture: a texel takes a quad's time at least" jq -e "$passes \$m.resources.texture >= \$c.distinct / 1e7)" shot.json
check "the point" jq -e "$near $passes near(\$m.ms;
  ([\$m.resources[] | . * .] | add | sqrt) + \$m.launch_ms))" shot.json
check "the band holds it" jq -e "$passes \$m.low_ms <= \$m.ms and \$m.ms <= \$m.high_ms and
  \$m.low_ms < \$m.high_ms)" shot.json
check "the limit takes longest" jq -e "$passes \$m.resources[\$m.limit] == ([\$m.resources[]] | max))" shot.json
check "a frame is its passes" jq -e "$near .cache.mine.modelled | . as \$m |
  all((\"ms\", \"low_ms\", \"high_ms\", \"launch_ms\"); . as \$k | near(\$m.frame[\$k]; [\$m.passes[][\$k]] | add))" shot.json
check "its operations too" jq -e "$near .cache.mine | . as \$m |
  all((\"alu\", \"special\", \"image\"); . as \$k | near(\$m.frame.operations[\$k]; [\$m.passes[].operations[\$k]] | add))" shot.json
# What the file leaves out is a choice of ours.
check "what is in doubt" jq -e '.cache.mine.modelled.unverified == ["rates.special", "rates.point_64", "levels.L1.sector",
  "levels.L2.sector", "levels.L2.units", "levels.L2.cold", "block"]' shot.json
check "image operations are the trace's" jq -e "$passes \$c.operations.image <= \$c.fetches and
  \$c.operations.image >= \$c.distinct and \$c.operations.image > 0)" shot.json

line=$(jq -r '.cache.mine.modelled.frame | "\(.ms) \(.low_ms) \(.high_ms) \(.limit)"' shot.json | awk '
  { printf "modelled on mine: %.3g ms (%.3g .. %.3g), limited by %s", $1, $2, $3, $4 }')
check "the table says so" grep -qF "  $line" table.txt
check "of a pass as well" test "$(grep -c ', limited by ' table.txt)" -eq $((1 + $(jq '.cache.mine.passes | length' shot.json)))

# What cannot be counted keeps its other figures, and says why it has no times.
uncounted=("$program" cache --module "$AOBUDGET_BUILD/tests/modules/uncounted.so" --technique uncounted
  --scene cornell --size 48x32 --backend gl-osmesa --profile generic,./mine.yaml)
check "what cannot be counted" "${uncounted[@]}" --json uncounted.json --quiet
check "is traced" jq -e '.cache.mine | .status == "ok" and .frame.fetches > 0 and .texels_differ == 0' uncounted.json
check "and has no times" jq -e '.cache.mine | .modelled == null and .frame.operations == null and
  (.not_modelled | test("cannot be counted"))' uncounted.json
check "which is no word on a device without rates" jq -e '.cache.generic | has("not_modelled") | not' uncounted.json
check "the table says why" test "$("${uncounted[@]}" | grep -c '^  not modelled: uncounted: .* cannot be counted')" -eq 1

# A rate is one of the device's numbers: where it changes, a run measures again.
cat >config.yaml <<END
name: sweep
scenes: [{name: corner, view: far}]
resolutions: [32x18]
backends: [gl-osmesa]
techniques: [{name: gtao, params: {blur: 0}}]
measure: {time: false, error: false, images: false, cache: [./mine.yaml]}
END
check "a run" "$program" run config.yaml --out out --quiet
check "has times" jq -e '.cache.mine.modelled.frame.ms > 0' out/journal.jsonl
sed 's/, cache: .*/}/' config.yaml >plain.yaml
estimate() { "$program" plan "$1" --json - | jq .estimated_s; }
check "the plan foretells what counting takes" awk -v a="$(estimate config.yaml)" -v b="$(estimate plain.yaml)" \
  'BEGIN { exit !((a - b - (0.9 + 576 * 3e-6)) ^ 2 < 1e-12) }'
profile 10 >mine.yaml
check "a slower memory" "$program" run config.yaml --out out --quiet
check "takes twice as long" jq -se "$near (map(.cache.mine.modelled.frame.resources.memory) |
  length == 2 and near(.[1]; 2 * .[0]))" out/journal.jsonl
sed -i 's/^  rops.*//' mine.yaml
expect 2 "mine.yaml:8:3: 'rops' is missing" "$program" run config.yaml --out out --quiet
finish
