#!/usr/bin/env bash
# Frames drawn by lot: every technique on every backend stands them; what is planted is found, made as small as it can be, and
# shown again by the line that tells of it.
source "$(dirname "$0")/lib.sh"
cd "$folder"
modules=$AOBUDGET_BUILD/tests/modules

check "every technique on every backend" "$program" stress --fuzz 2000 --seed 1 --json all.json
check "all of them were drawn" jq -e '.frames == 2000 and .seed == 1 and ([.rows[].frames] | add) == 2000' all.json
check "few were refused" jq -e '.refused * 20 < .frames' all.json
check "there are several rows" jq -e '[.rows[].backend] | unique | length >= 3' all.json

# The fault needs two parameters at a bound each, and a surface with sky to its left: so two pixels and nothing else.
"$program" stress --fuzz 600 --seed 1 --module "$modules/planted.so" --technique planted --backend vulkan --out found \
  >found.txt 2>&1
check "the code says so" test $? = 1
smallest='.rows[0].findings[0].smallest'
check "it is found once" jq -e '[.rows[].findings[]] | length == 1 and .[0].fault == "not finite"' found/fuzz.json
check "two pixels are left" jq -e "$smallest.view | .width == 2 and .height == 1 and .guard == 0" found/fuzz.json
check "its parameters are left" jq -e "$smallest.params == {radius: \"0.5\", strength: \"4\", bias: \"0.25\", width: \"3\"}" found/fuzz.json
check "all options are at their defaults" jq -e "$smallest.options |
  .fetch == \"sampled\" and .depth_encoding == \"r32f\" and .normal_encoding == \"rgba32f\" and .normals == \"geometric\"" \
  found/fuzz.json
index=$(jq '.rows[0].findings[0].index' found/fuzz.json)
check "its frame is written" cmp <(jq -S . "found/planted-vulkan-$index.json") <(jq -S "$smallest" found/fuzz.json)
check "its pixels are written" test -s "found/planted-vulkan-$index-gbuffer.exr" -a -s "found/planted-vulkan-$index-image.exr"

# As a reader would: the line's own words, from "aobudget" on.
command=$(sed -n 's/^ *shown again by: aobudget //p' found.txt)
eval "\"\$program\" ${command% DIR} again" >again.txt 2>&1
check "shown again, the code says so" test $? = 1
check "it is one frame" jq -e '.frames == 1' again/fuzz.json
check "the same frame fails, and shrinks to the same" cmp <(jq -S "$smallest" found/fuzz.json) <(jq -S "$smallest" again/fuzz.json)
check "with the same images" cmp "found/planted-vulkan-$index-gbuffer.exr" "again/planted-vulkan-$index-gbuffer.exr"

# A frame that takes its worker away is told, and the rest goes on.
"$program" stress --fuzz 300 --seed 1 --module "$modules/planted.so" --technique planted_death --backend vulkan \
  --json death.json >death.txt 2>&1
check "a death is bad" test $? = 1
check "it is told" jq -e '.rows[0].findings[0] | .fault == "worker ended" and .frames >= 2' death.json
check "the rest goes on" jq -e '.frames == 300' death.json
index=$(jq '.rows[0].findings[0].index' death.json)
"$program" stress --fuzz 1 --seed 1 --from "$index" --module "$modules/planted.so" --technique planted_death \
  --backend vulkan >once.txt 2>&1
check "and shown again" grep -q "worker ended in 1 frames: frame $index: " once.txt

expect 2 "'0' is not a whole number from 1" "$program" stress --fuzz 0
expect 2 "'1.5' is not a whole number" "$program" stress --fuzz 10 --seed 1.5
expect 2 "leave out --property" "$program" stress --fuzz 10 --property plane_is_open
expect 2 "choose frames of --fuzz" "$program" stress --seed 3
finish
