#!/usr/bin/env bash
# `cache --lines` and `list profiles`: figures in closed form, what is refused, and profiles where the program is installed.
source "$(dirname "$0")/lib.sh"
cd "$folder"
numbers() { # FILE NUMBER...: as 32-bit words
  local file=$1 number
  shift
  for number; do
    printf "\\x$(printf %02x $((number & 255)))\\x$(printf %02x $((number >> 8 & 255)))\\x$(printf %02x $((number >> 16 & 255)))\\x$(printf %02x $((number >> 24)))"
  done >"$file"
}
figures() { "$program" cache --lines "$@" --json - | jq -r '"\(.accesses) \(.misses) \(.compulsory) \(.capacity) \(.conflict)"'; }

# Cyclic over 9 lines, 10 rounds: a list of 8 misses all; of 4 sets of 2 the first, with lines 0, 4 and 8, does.
numbers nine $(for _ in 1 2 3 4 5 6 7 8 9 10; do seq 0 8; done)
check "fully associative" test "$(figures nine --sets 1 --ways 8 --index modulo)" = "90 90 9 81 0"
check "of four sets" test "$(figures nine --sets 4 --ways 2 --index modulo)" = "90 36 9 81 -54"
check "as many ways as can be written" test "$(figures nine --sets 1 --ways 2147483647 --index modulo)" = "90 9 9 0 0"
# A stride of 16 lines: one of 16 sets by modulo, which two ways do not hold; xor spreads them.
numbers stride $(for _ in 1 2 3 4 5; do seq 0 16 240; done)
check "modulo" test "$(figures stride --sets 16 --ways 2 --index modulo)" = "80 80 16 0 64"
check "xor" test "$(figures stride --sets 16 --ways 2 --index xor)" = "80 16 16 0 0"
numbers largest 4294967295 0 4294967295
check "the largest number" test "$(figures largest --sets 4 --ways 4 --index xor)" = "3 2 2 0 0"
: >empty
check "an empty stream" test "$(figures empty --sets 4 --ways 4 --index xor)" = "0 0 0 0 0"
"$program" cache --lines stride --sets 16 --ways 2 --index modulo >told
check "a line for people" grep -qx "80 accesses, 80 misses (100.00 %): 16 compulsory, 0 capacity, 64 conflict" told

good=(--sets 4 --ways 4 --index xor)
printf abc >odd
expect 2 "odd: 3 bytes are no whole number of 32-bit line numbers" "$program" cache --lines odd "${good[@]}"
expect 2 "gone: cannot open" "$program" cache --lines gone "${good[@]}"
expect 2 "--sets is missing" "$program" cache --lines nine
expect 2 "--ways is missing" "$program" cache --lines nine --sets 4
expect 2 "--index is missing" "$program" cache --lines nine --sets 4 --ways 4
expect 2 "--sets: '0'" "$program" cache --lines nine --sets 0 --ways 4 --index xor
expect 2 "--ways: '-4'" "$program" cache --lines nine --sets 4 --ways -4 --index xor
expect 2 "--ways: '1e30'" "$program" cache --lines nine --sets 4 --ways 1e30 --index xor
expect 2 "--index: 'random'" "$program" cache --lines nine --sets 4 --ways 4 --index random
expect 2 "xor needs a power of two" "$program" cache --lines nine --sets 5 --ways 4 --index xor
expect 2 "larger than this machine can hold" "$program" cache --lines nine --sets 2147483647 --ways 2147483647 --index modulo
expect 2 "a cache of 8388608 sets and 4 ways with a stream of 90 numbers may take 0.125 GiB, and 0.0312 GiB is left" \
  bash -c 'ulimit -S -m 65536; "$@"' _ "$program" cache --lines nine --sets 8388608 --ways 4 --index xor
expect 2 "--lines FILE" "$program" cache

"$program" list profiles --json profiles.json
check "all profiles" test "$(jq -r '[.profiles[].name] | join(" ")' profiles.json)" = \
  "adreno640 geforce8600gts geforce8800gt geforce8800gtx geforce8800ultra generic gtx460se gtx580 llvmpipe ps4 ps5 rx6800xt turing xbox360 xboxone xboxseriesx"
check "each number has a source" test "$(jq '[.profiles[].facts[] | select((.source | length) < 4 or (.confirmed | type) != "boolean")] | length' profiles.json)" = 0
check "unverified is said" test "$(jq -r '.profiles[] | select(.name == "xbox360") | .facts[] | select(.key == "levels.L1.size") | .confirmed' profiles.json)" = false
check "for people" grep -q "levels.L1.size  *16 KiB  *confirmed" <("$program" list profiles)

check "so is what a file leaves out" test "$(jq -r '[.profiles[] | select(.name == "ps4") | .facts[] |
  select(.source | startswith("default: ")) | "\(.key)=\(.value) \(.confirmed)"] | join(", ")' profiles.json)" = \
  "levels.L1.sector=64 false, levels.L2.sector=64 false, levels.L2.units=all false, levels.L2.cold=frame false, block=8x8 false"

# Beside an installed program they are in share/. One that cannot be read says so, and the others are listed.
mkdir -p prefix/bin prefix/share/aobudget/profiles
cp "$program" prefix/bin/
echo broken >prefix/share/aobudget/profiles/first.yaml
cp "$AOBUDGET_BUILD/../../configs/profiles/ps4.yaml" prefix/share/aobudget/profiles/
sed 's/machine/nothing/' "$AOBUDGET_BUILD/../../configs/profiles/llvmpipe.yaml" >prefix/share/aobudget/profiles/vm.yaml
check "a list with broken ones" prefix/bin/aobudget list profiles --json broken.json --quiet
check "each has a line" test "$(jq -r '[.profiles[] | "\(.name) \(.title) \(.facts | length > 0) \(.reason == "")"] | join(", ")' broken.json)" = \
  "first null false false, ps4 PlayStation 4 (Liverpool), 18 compute units of GCN true true, vm null false false"
check "which says why" test "$(jq -r '[.profiles[].reason | test("first.yaml:1:1: |vm.yaml:4:16: .*nothing")] | join(" ")' broken.json)" = "true false true"
prefix/bin/aobudget list profiles >broken.txt
check "so does the text" grep -q "first.yaml:1:1: " broken.txt
check "and goes on" grep -q "^ps4: PlayStation" broken.txt
expect 2 "first.yaml:1:1: " prefix/bin/aobudget cache --technique none --scene corner --profile first
finish
