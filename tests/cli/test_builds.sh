#!/usr/bin/env bash
# Several builds of one technique in one run, each addressed by its module (tests/modules/loop/loop.c).
source "$(dirname "$0")/lib.sh"
tree=$(realpath "$(dirname "$0")/../..")
modules=$AOBUDGET_BUILD/tests/modules
mkdir "$folder/configs" "$folder/elsewhere"
cd "$folder/configs"
cp "$modules/loop16.so" old.so
cp "$modules/loop_moved.so" new.so

config() { # FILE BACKENDS ENTRY...
  local file=$1 backends=$2
  shift 2
  {
    echo "name: builds"
    echo "scenes: [{name: corner}]"
    echo "resolutions: [64x36]"
    echo "backends: [$backends]"
    echo "measure: {seconds: 0.05}"
    echo "reference: {spp: 2}"
    echo "techniques:"
    printf '  - {%s}\n' "$@"
  } >"$file"
}

# Both builds share a block, whose worker holds both at once.
config both.yaml "vulkan, gl-egl" "name: loop, module: old.so" "name: loop, module: new.so" "name: none"
cd "$folder/elsewhere" # modules are seen from the config's folder
check "a run" "$program" run ../configs/both.yaml --out out --quiet
check "each case is ok" jq -es 'length == 6 and all(.[]; .status == "ok")' out/journal.jsonl
check "the records name the modules" jq -es '[.[] | [.technique, .module]] | unique ==
  [["loop", "new.so"], ["loop", "old.so"], ["none", null]]' out/journal.jsonl
check "each build has its keys" jq -es '[.[] | .key] | unique | length == 6' out/journal.jsonl
check "builds share a series" jq -es '[.[] | select(.technique == "loop") | .series] | unique | length == 2' out/journal.jsonl
image() { # BACKEND MODULE
  jq -rs ".[] | select(.backend == \"$1\" and .module == \"$2\") | .image" out/journal.jsonl
}
for backend in vulkan gl-egl; do
  apart=$("$AOBUDGET_BUILD/image_rmse" "out/$(image $backend old.so)" technique.AO "out/$(image $backend new.so)" technique.AO)
  check "$backend: the new build's image is darker by .05: $apart" awk "BEGIN { exit !($apart > 0.049999 && $apart < 0.050001) }"
done
check "run.json has both" jq -e '[.techniques[] | select(.name == "loop") | .module, .digest] | unique | length == 4' out/run.json
for build in old new; do
  check "the page tells $build from the other" grep -qF "loop ($build.so)" out/report/index.html
  check "so does cases.csv" grep -qF ",loop,$build.so," out/report/cases.csv
done
check "it stands" "$program" run ../configs/both.yaml --out out --quiet
check "nothing is measured twice" test "$(wc -l <out/journal.jsonl)" -eq 6

# The plan names the modules where it has two builds of a name, and only there.
cd ../configs
lines() { # CONFIG FLAGS...
  "$program" plan "$@" | head -n -1
}
same() { # GOT WANTED
  [ "$1" = "$2" ] || { diff <(echo "$1") <(echo "$2"); return 1; }
}
check "a plan" same "$(lines both.yaml | grep vulkan)" $'loop (old.so) vulkan\nloop (new.so) vulkan\nnone vulkan'
config one.yaml vulkan "name: loop, module: old.so" "name: none"
check "one build goes by its name" same "$(lines one.yaml)" $'loop\nnone'
check "a filter" "$program" run both.yaml --out filtered --quiet --filter "loop (new.so) gl-egl"
check "has the one case" jq -es 'length == 1 and .[0].module == "new.so"' filtered/journal.jsonl

# --module stands in where an entry names no module, whatever other entries name.
config mixed.yaml vulkan "name: loop" "name: loop, module: old.so"
check "--module and module" same "$(lines mixed.yaml --module ./new.so)" $'loop (./new.so)\nloop (old.so)'
config gtao.yaml vulkan "name: gtao" "name: gtao, module: gtao.so"
cp "$AOBUDGET_BUILD/modules/gtao.so" .
check "beside the built-in" same "$(lines gtao.yaml)" $'gtao\ngtao (gtao.so)'
check "in its place" same "$(lines gtao.yaml --module gtao.so)" gtao

# Names of one build are one case, however often it lies on the disk.
ln old.so hard.so
ln -s old.so soft.so
cp old.so copy.so
config names.yaml vulkan "name: loop, module: old.so" "name: loop, module: ./old.so" "name: loop, module: hard.so" \
  "name: loop, module: soft.so" "name: loop, module: copy.so"
check "names of one build" same "$(lines names.yaml | wc -l)" 1
check "by whatever path to the config" same "$(lines ./../configs/names.yaml --module old.so | wc -l)" 1
check "which is measured" "$program" run names.yaml --out names --quiet
expect 0 "1 cases: 1 ok" "$program" run names.yaml --out names2 --module old.so --module hard.so

# Two builds may call themselves by one name inside.
so() { # OUT SHIFT
  gcc -std=c11 -O2 -shared -fPIC -DLOOP_TRIPS=2 -DLOOP_WORK=2 -DLOOP_SHIFT="$2" -Wl,-soname,loop.so \
    -I"$tree/include" "$tree/tests/modules/loop/loop.c" -o "$1"
}
so first.so 0
so second.so 10
config soname.yaml gl-egl "name: loop, module: first.so" "name: loop, module: second.so"
check "one soname" "$program" run soname.yaml --out soname --quiet
apart=$("$AOBUDGET_BUILD/image_rmse" soname/"$(jq -rs '.[0].image' soname/journal.jsonl)" technique.AO \
  soname/"$(jq -rs '.[1].image' soname/journal.jsonl)" technique.AO)
check "two images: $apart apart" awk "BEGIN { exit !($apart > 0.09999 && $apart < 0.10001) }"

# A file that is replaced once the run has begun is another build; it costs its own cases.
cp old.so fleeting.so
cp "$modules/meddle.so" .
config replaced.yaml gl-egl "name: meddle, module: meddle.so" "name: loop, module: fleeting.so" "name: none"
MEDDLE="cp '$PWD/new.so' '$PWD/part' && mv '$PWD/part' '$PWD/fleeting.so'" \
  expect 3 "3 cases: 2 ok, 0 unsupported, 0 invalid, 1 failed" "$program" run replaced.yaml --out replaced
check "the reason" jq -es "any(.[]; .technique == \"loop\" and .status == \"failed\" and
  (.reason | contains(\"fleeting.so: the file is another one than when its technique 'loop' was planned: start again\")))" \
  replaced/journal.jsonl

# What cannot be addressed is one line with its place.
bad() { # 'TEXT' ENTRY...
  local text=$1
  shift
  config bad.yaml gl-egl "$@"
  expect 2 "$text" "$program" plan bad.yaml
}
bad "bad.yaml:8:12: old.so has no technique 'lop'; it has loop" "name: lop, module: old.so"
bad "bad.yaml:9:26: $PWD/nowhere.so: cannot open" "name: none" "name: none, module: nowhere.so"
bad "bad.yaml:8:26: $PWD/one.yaml: cannot load the module" "name: none, module: one.yaml"
bad "bad.yaml:8:26: a value is missing here" "name: none, module: ''"
bad "bad.yaml:8:12: unknown technique 'loop' without a module; write module: new.so beside its name" "name: loop" \
  "name: loop, module: new.so"
sed 's/name: corner/name: corner, module: old.so/' one.yaml >scene.yaml
expect 2 "scene.yaml:2:25: unknown key 'module'" "$program" plan scene.yaml
config ambiguous.yaml gl-egl "name: loop"
expect 2 "ambiguous.yaml:8:12: technique 'loop' is in old.so and in new.so: load one of them, or write module: FILE.so" \
  "$program" plan ambiguous.yaml --module old.so --module new.so
cp new.so ../elsewhere/old.so
cd ../elsewhere
expect 2 "one.yaml:8:26: old.so names two modules, old.so and ../configs/old.so" "$program" plan ../configs/one.yaml --module old.so
finish
