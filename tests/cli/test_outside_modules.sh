#!/usr/bin/env bash
# Small modules of tests/outside/, made of the installed files only: two outputs, a pyramid of depths, broken rules.
source "$(dirname "$0")/lib.sh"
tree=$(realpath "$(dirname "$0")/../..")
prefix=$folder/prefix
export ASAN_OPTIONS=detect_leaks=0 # drivers are loaded here

check "install" cmake --install "$AOBUDGET_BUILD" --prefix "$prefix"
cp -r "$tree/tests/outside" "$folder/outside"
cd "$folder/outside"
program=$prefix/bin/aobudget
check "configure" cmake -S . -B build -DCMAKE_C_FLAGS="-Wall -Wextra -Werror" -DCMAKE_PREFIX_PATH="$prefix"
check "build" cmake --build build

# A step that does not exist, and one that a text of the folder hides, are named when the module is built.
steps() { # STEP...: the table of two_outputs' texts with these steps
  cmake -DNAME=two_outputs -DFOLDER=shaders/two_outputs "-DSTEPS=$1" -DSHADERS="$prefix/share/aobudget/shaders" \
    -DOUT=texts.h -P "$prefix/lib/cmake/aobudget/shaders.cmake" 2>&1
}
check "the text of a step" bash -c "$(declare -f steps); prefix='$prefix' steps 'upsample;blur' && grep -F '{\"blur\",' texts.h"
check "no such step" bash -c "$(declare -f steps); prefix='$prefix' steps blurr | grep -F \"no step 'blurr'\""
cp "$prefix/share/aobudget/shaders/steps/upsample.glsl" shaders/two_outputs/
check "a step and a file" bash -c "$(declare -f steps); prefix='$prefix' steps upsample | grep -F 'both a step and a file'"
rm shaders/two_outputs/upsample.glsl

config() { # TECHNIQUE PARAMS BACKENDS
  cat <<YAML
name: outside
scenes: [{name: spheres}]
resolutions: [101x59]
backends: [$3]
options: {fetch: [sampled, storage]}
techniques:
  - {name: $1, params: {$2}}
measure: {time: false}
reference: {spp: 2}
YAML
}

# A rule that is broken in a config has its place there.
config two_outputs "taps: 4" '"null"' >taps.yaml
expect 2 "taps.yaml:7:40: two_outputs: taps: 4: must be odd, or 0" "$program" plan taps.yaml --module build/two_outputs.so
config two_outputs "divisor: [1, 3]" '"null"' >divisor.yaml
expect 2 "divisor.yaml:7:47: two_outputs: divisor: 3: must be a power of two" "$program" run divisor.yaml \
  --module build/two_outputs.so
check "the list says the rule" bash -c "'$program' list techniques --module build/two_outputs.so | grep -F 'in 0 .. 9 count, odd, or 0'"
check "so does its JSON" bash -c "'$program' list techniques --module build/two_outputs.so --json - |
  jq -e '[.techniques[] | select(.name == \"two_outputs\").params[].rule] == [\"any\", \"odd\", \"power_of_two\"]'"

backends='"null"'
for backend in vulkan gl-egl gl-osmesa; do
  "$program" shot --technique none --scene plane --size 8x8 --reference-spp 0 --backend $backend >/dev/null 2>&1 &&
    backends+=", $backend"
done
echo "backends: $backends"
all_ok() {
  jq -es 'length > 0 and all(.[]; .status == "ok")' "$1/journal.jsonl" && return
  jq -c '[.backend, .status, .reason]' "$1/journal.jsonl"
  return 1
}

# Two outputs, at full size and upsampled.
config two_outputs "divisor: [1, 2]" "${backends#\"null\", }" | sed 's/^options: *{/&bent_normal: "on", /' >two.yaml
check "two outputs" "$program" run two.yaml --module build/two_outputs.so --out two --quiet
check "each case is ok" all_ok two
check "the graph shows both" bash -c "grep -h -e '-> visibility;' two/graphs/*.dot && grep -h -e '-> bent_normal;' two/graphs/*.dot"

# The second output is scored against the traced mean of the open directions. The module writes the normal: right by
# definition on a convex body, and wrong where something stands beside the surface.
sed 's/spheres/sphere}, {name: cornell/; s/101x59/64x36/; s/spp: 2/spp: 256/; s/fetch: .sampled, storage./fetch: sampled/; s/divisor: .1, 2./divisor: 1, taps: 1/' \
  two.yaml >bent.yaml
check "bent normals" "$program" run bent.yaml --module build/two_outputs.so --out bent --quiet
angles() { jq -s "[.[] | select(.scene == \"$1\") | .errors[].bent_mean] | $2" bent/journal.jsonl; }
check "both outputs stand in the record" test "$(jq -c .outputs bent/journal.jsonl | sort -u)" = '["visibility","bent_normal"]'
check "the normal of a convex body: $(angles sphere max) degrees" awk "BEGIN { exit !($(angles sphere max) < 1) }"
check "not that of a room: $(angles cornell min) degrees" awk "BEGIN { exit !($(angles cornell min) > 5) }"
image=bent/$(jq -rs '[.[] | select(.scene == "cornell")][0].image' bent/journal.jsonl)
truth=bent/$(jq -rs '[.[] | select(.scene == "cornell")][0].errors[0].truth' bent/journal.jsonl)
check "the image file holds both" test "$("$AOBUDGET_BUILD/image_rmse" "$image" reference.bent.Y "$truth" B.Y)" = 0
written=$("$AOBUDGET_BUILD/image_rmse" "$image" technique.bent.Y "$image" N.Y)
check "and what the module wrote, the normal, to half floats: $written" awk "BEGIN { exit !($written < 3e-4) }"

# The nearest depth of each block of 16 pixels, with sides that no power of two divides.
config pyramid "scale: 100" "${backends#\"null\", }" >pyramid.yaml
check "a pyramid" "$program" run pyramid.yaml --module build/pyramid.so --out pyramid --quiet
check "each case is ok" all_ok pyramid
for image in pyramid/images/*.exr; do
  read -r worst varied < <("$AOBUDGET_BUILD/block_minimum" "$image" 16 100)
  check "$(basename "$image"): the least depth of each block ($worst, $varied)" \
    awk "BEGIN { exit !(\"$worst\" != \"\" && $worst < 1e-6 && $varied >= 8) }"
done
texels=$((112 * 64 + 56 * 32 + 28 * 16 + 14 * 8 + 7 * 4 + 101 * 59))
check "what is allocated is counted" jq -es "all(.[]; .memory_bytes == 4 * $texels)" pyramid/journal.jsonl
finish
