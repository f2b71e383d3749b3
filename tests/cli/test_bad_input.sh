#!/usr/bin/env bash
# Rubbish at every door: one clear line, the right exit code, nothing half-written.
source "$(dirname "$0")/lib.sh"
cd "$folder"
modules=$AOBUDGET_BUILD/tests/modules
shot=("$program" shot --technique gtao --scene corner --backend null --size 32x18 --reference-spp 2)

config() { # TECHNIQUES [SCENES]
  cat >config.yaml <<EOF
name: bad
scenes: [${2:-{name: plane\}}]
resolutions: [32x18]
backends: [null]
techniques: [$1]
measure: {seconds: 0.05}
reference: {spp: 2}
EOF
}

expect 2 "unknown command 'rum'" "$program" rum
expect 2 "unknown flag --outt" "$program" run config.yaml --outt x
expect 2 "usage: aobudget run" "$program" run
expect 2 "needs a value" "$program" run config.yaml --out
expect 2 "not both" "$program" run config.yaml --fresh --resume
expect 2 "config.yaml: cannot open" "$program" run config.yaml
expect 2 "'colours' is not one of" "$program" list colours
expect 2 "technique and --scene are needed" "$program" shot
expect 2 "'0x0' is not WIDTHxHEIGHT" "${shot[@]:0:8}" --size 0x0
expect 2 "is not WIDTHxHEIGHT" "${shot[@]:0:8}" --size 32x18x
expect 2 "unknown technique 'gtoa'" "$program" shot --technique gtoa --scene corner
expect 2 "unknown scene 'crner'" "$program" shot --technique gtao --scene crner
expect 2 "no view 'up'" "${shot[@]}" --view up
expect 2 "unknown backend 'metal'" "$program" shot --technique gtao --scene corner --backend metal
expect 2 "radius: '1x' is not a number" "${shot[@]}" -p radius=1x
expect 2 "radius: -1 is outside" "${shot[@]}" -p radius=-1
expect 2 "gtao has no 'radii'" "${shot[@]}" -p radii=1
expect 2 "'radius' is not name=value" "${shot[@]}" -p radius
expect 2 "reference-radius is now --target-radius" "${shot[@]}" --reference-radius 1
expect 2 "target-radius: 'far' is not a radius" "${shot[@]}" --target-radius 1,far
expect 2 "target-radius: 'flat' is not one of cosine, uniform" "${shot[@]}" --target-radius 1 --target-weighting flat
expect 2 "fetch: 'tex' is not one of sampled, storage" "${shot[@]}" -p fetch=tex
expect 2 "must be odd" "${shot[@]}" -p blur=4
expect 2 "--eye and --target go together" "${shot[@]}" --eye 0,0,1
expect 2 "--shift need --eye" "${shot[@]}" --shift 1,0
expect 2 "is not x,y" "${shot[@]}" --eye 0,0,1 --target 0,0,0 --shift 1
expect 2 "shift 17" "${shot[@]}" --eye 0,0,1 --target 0,0,0 --shift 17,0
expect 2 "is not x,y,z" "${shot[@]}" --eye 0,0,1z --target 0,0,0
expect 2 "even whole number" "$program" shot --technique none --scene plane --backend null --reference-spp 3
expect 2 "cannot" "${shot[@]}" --json /proc/nowhere/x.json
expect 2 "/proc/nowhere" "${shot[@]}" --out /proc/nowhere/x.exr

config '{name: gtao, params: {radius: 0.5x}}'
expect 2 "config.yaml:5:44: gtao: radius: '0.5x' is not a number" "$program" run config.yaml
expect 2 "config.yaml:5:44" "$program" plan config.yaml
config '{name: gtao, params: {blur: 4}}'
expect 2 "config.yaml:5:42: gtao: blur: 4: must be odd, or 0" "$program" run config.yaml --quiet
config '{name: crytek_ssao, params: {samples: 9}}'
expect 2 "nothing could run" "$program" run config.yaml --quiet
config '{name: none}'
expect 2 "cannot create the folder" "$program" run config.yaml --out /proc/nowhere
echo "not a folder" >file
expect 2 "file" "$program" run config.yaml --out file
check "a run" "$program" run config.yaml --out out --quiet
echo "# changed" >>config.yaml
expect 2 "a run of another config" "$program" run config.yaml --out out --quiet
check "the earlier journal is whole" grep -q '"status":"ok"' out/journal.jsonl
expect 2 "gone/x.json: cannot write" "$program" run config.yaml --out out --fresh --json gone/x.json
check "the earlier journal is still whole" grep -q '"status":"ok"' out/journal.jsonl
check "fresh discards it" "$program" run config.yaml --out out --fresh --quiet
expect 2 "no case of config.yaml matches 'xyz'" "$program" run config.yaml --out out2 --filter xyz
expect 2 "not the folder of a run" "$program" report "$folder/nowhere"

# Meshes.
echo "solid rubbish" >broken.obj
head -c 3000 /dev/urandom >broken.ply
printf 'ply\nformat ascii 1.0\nelement vertex 99999999\nproperty float x\nend_header\n' >huge.ply
expect 2 "huge.ply" "$program" shot --technique none --scene huge.ply --backend null --size 8x8
for mesh in broken.obj broken.ply; do
  expect 2 "$mesh" "$program" shot --technique none --scene "$mesh" --backend null --size 8x8
  config '{name: none}' "{file: $mesh}"
  expect 2 "nothing could run" "$program" run config.yaml --out "out-$mesh" --quiet
  check "the reason is in the journal" grep -q "$mesh" "out-$mesh/journal.jsonl"
done

# Modules.
expect 2 "made for module interface 3, this program has 11" "$program" list techniques --module "$modules/old_abi.so"
expect 2 "cannot load" "$program" list techniques --module config.yaml
expect 2 "is it a file" "$program" list techniques --module "$folder"
expect 2 "cannot open" "$program" list techniques --module nowhere.so
config '{name: crash_build}, {name: none}'
expect 3 "2 cases: 1 ok, 0 unsupported, 0 invalid, 1 failed" "$program" run config.yaml --out crash --module "$modules/crash_build.so"
check "the crash is named" grep -q 'crash_build: laying out its passes: .*crashed' crash/journal.jsonl
# What a worker does after its last answer is no case's fault. A heap that is read too far is the sanitizer's to find.
config '{name: crash_exit}, {name: gtao, params: {slices: [1, 2, 3]}}'
check "layout of a module that dies at its end" "$program" run config.yaml --out crash3 --quiet --module "$modules/crash_exit.so"
check "costs no other case" test "$(grep -c '"technique":"gtao".*"status":"ok"' crash3/journal.jsonl)" -eq 3
config '{name: crash_build}'
expect 2 "nothing could run" "$program" run config.yaml --out crash2 --quiet --module "$modules/crash_build.so"

config '{name: bad_definition, sweep: [{param: fault, values: [radius, falloff]}]}, {name: none}'
expect 3 "3 cases: 1 ok, 0 unsupported, 2 invalid, 0 failed" "$program" run config.yaml --out nonsense --module "$modules/bad_definition.so"
check "the radius is named" grep -q 'definition.s radius is -1' nonsense/journal.jsonl
check "the falloff is named" grep -q 'falloff is not finite' nonsense/journal.jsonl

# Outputs that are no plain files keep what they are; inputs that never end are not begun.
mkfifo pipe
cat pipe >from-pipe &
check "into a pipe" "${shot[@]}" --json pipe
wait
check "it is still one" test -p pipe
check "and got the document" grep -q '"band_rmse"' from-pipe
echo old >target && ln -s target link
check "through a link" "${shot[@]}" --json link
check "it is still one" test -L link
check "its target was written" grep -q '"band_rmse"' target
expect 2 "no regular file" "${shot[@]}" --out pipe
expect 2 "is it a file" "$program" shot --technique none --scene pipe --backend null --size 8x8
expect 2 "not UTF-8" "$program" shot --technique none --scene "$(printf 'b\377.obj')" --backend null --size 8x8
expect 2 "40 million pixels" "$program" shot --technique none --scene plane --backend null --size 16384x16384

# No driver.
config '{name: none}'
sed -i 's/backends: \[null\]/backends: [vulkan, null]/' config.yaml
VK_ICD_FILENAMES=/nonexistent.json VK_DRIVER_FILES=/nonexistent.json \
  expect 3 "2 cases: 1 ok, 1 unsupported" "$program" run config.yaml --out nodriver
check "the missing driver is named" grep -q '"unsupported","reason":"vulkan: .*mesa-vulkan-drivers' nodriver/journal.jsonl
VK_ICD_FILENAMES=/nonexistent.json VK_DRIVER_FILES=/nonexistent.json \
  expect 2 "mesa-vulkan-drivers" "$program" shot --technique none --scene plane --size 8x8 --reference-spp 0

check "no part file is left over" test -z "$(find . -name '*.part')"
expect 2 "near 3 is not below far 2" "$program" shot --technique gtao --scene corner --backend null -p depth_encoding=device24 -p near=3 -p far=2
expect 2 "needs a perspective view" "$program" shot --technique gtao --scene corner --backend null -p depth_encoding=device32_infinite --eye=0,2,4 --target=0,1,0 --ortho 3
finish
