#!/usr/bin/env bash
# --device and the devices of `list backends`. The machine may have a GPU beside its processor: only the latter is sure.
source "$(dirname "$0")/lib.sh"
cd "$folder"
check "list" "$program" list backends --json list.json
for backend in vulkan gl-egl gl-osmesa null; do
  jq -e --arg b $backend '.backends[] | select(.name == $b) | .devices | length >= 1 and ([.[] | select(.chosen)] | length) == 1
    and all(.[]; .name != "" and .driver != "" and (.software | type) == "boolean" and (.timer | type) == "boolean" and .lacks == "")' \
    list.json >.answer || true
  check "$backend has devices, one of them chosen" grep -qx true .answer
done
"$program" list backends >list.txt
check "a line each, the chosen one with a star" test "$(grep -c '^  \* 0  ' list.txt)" -ge 1
check "which says all" grep -qE '^  \* 0  none: cpu, software; none; timer$' list.txt
number=$(jq '[.backends[] | select(.name == "vulkan") | .devices[] | .name | startswith("llvmpipe")] | index(true)' list.json)
name=$(jq -r ".backends[] | select(.name == \"vulkan\") | .devices[$number].name" list.json)
"$program" list backends --device "$number" --json chosen.json
check "the chosen one is another" test "$(jq -r ".backends[0].devices[$number].chosen" chosen.json)" = true

shot=(shot --technique none --scene plane --size 32x18 --reference-spp 0)
for device in "$number" LLVMpipe "$name"; do
  "$program" "${shot[@]}" --device "$device" --json shot.json --quiet
  check "a shot on '$device'" test "$(jq -r .fingerprint.device shot.json)" = "$name"
done
expect 2 "vulkan: no device 'nonsense': there " "$program" "${shot[@]}" --device nonsense
expect 2 "vulkan: no device '99': there " "$program" "${shot[@]}" --device=99
expect 2 "$number $name" "$program" "${shot[@]}" --device=
expect 2 "gl-egl: no device 'nonsense'" "$program" "${shot[@]}" --backend gl-egl --device nonsense
expect 2 "null: no device 'llvm': there is 0 none" "$program" "${shot[@]}" --backend null --device llvm
check "a shot on EGL's" "$program" "${shot[@]}" --backend gl-egl --device llvmpipe
expect 2 "plan: unknown flag --device" "$program" plan x.yaml --device 0

cat >config.yaml <<YAML
name: devices
scenes: [{name: plane}]
resolutions: [32x18]
backends: [vulkan, "null"]
techniques: [{name: none}]
measure: {error: false, images: false, seconds: 0.05}
YAML
code=0
"$program" run config.yaml --out run --device llvmpipe --quiet 2>run.txt || code=$?
check "a backend without the device is done without" test $code -eq 3
check "its cases say why" grep -q "null: no device 'llvmpipe': there is 0 none" run/journal.jsonl
check "the others are done" test "$(jq -r 'select(.status == "ok") | .fingerprint.device' run/journal.jsonl)" = "$name"
expect 2 "no device 'nonsense': there " "$program" run config.yaml --out none --device nonsense
check "and no folder is made" test ! -e none
expect 2 "no backend that draws works" "$program" doctor --device nonsense --json doctor.json
check "doctor says what there is" grep -q "no device 'nonsense': there is 0 none" doctor.json
cure() { jq -r --arg name "$1" '.findings[] | select(.what == "backend" and .name == $name).cure' doctor.json; }
check "and that another name is the cure, not a package" test "$(cure vulkan)" = 'choose a device that `aobudget list backends` shows'

# A device that cannot be opened, and none at all: the list says why no device has a star, and doctor's cure is for that.
sick() { "$@" "$program" list backends --json list.json && "$@" "$program" doctor --json doctor.json; }
sick env MESA_GL_VERSION_OVERRIDE=3.3 >/dev/null 2>&1
check "the device is listed with what it lacks" jq -e '.backends[] | select(.name == "gl-egl") | (.devices | length) >= 1 and
  all(.devices[]; (.chosen | not) and (.lacks | startswith("OpenGL 4.5 (EGL error 0x"))) and
  (.reason | test("^gl-egl: no device can be opened; the first of [0-9]+ lacks OpenGL 4.5 "))' list.json
check "no package is the cure" test "$(cure gl-egl)" = "another device (--device) or a newer driver"
sick env __EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json >/dev/null 2>&1
check "without a driver there is no device" jq -e '.backends[] | select(.name == "gl-egl") | .devices == [] and
  (.reason | startswith("gl-egl: no driver gives OpenGL 4.5 without a window: install "))' list.json
check "and packages are the cure" test "$(cure gl-egl)" = "apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri"
check "what is not sick has no cure" test -z "$(cure gl-osmesa)"
finish
