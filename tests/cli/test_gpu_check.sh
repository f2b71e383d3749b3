#!/usr/bin/env bash
# gpu-check, packed small and run here: what it says of drivers that agree, and of faults that are planted.
source "$(dirname "$0")/lib.sh"
root=$(realpath "$(dirname "$0")/../..")
cd "$folder"
mkdir configs
for config in images times; do
  cat >configs/$config.yaml <<YAML
name: $config
scenes: [{name: cornell, view: blocks}]
resolutions: [96x54]
backends: [vulkan]
techniques: [{name: gtao}, {name: crytek_ssao, params: {divisor: 2}}, {name: ao_volumes}]
target: {radius: 0.5}
measure: {time: false}
reference: {spp: 16}
YAML
done
sed -i 's/96x54/64x36/' configs/times.yaml
cat >configs/outputs.yaml <<YAML
name: outputs
scenes: [{name: gallery, view: ball}]
resolutions: [96x54]
backends: [vulkan]
options: {bent_normal: "on", visibility_rgb: "on", specular: "on", irradiance: "on", lit: "on"}
techniques: [{name: gtao}]
target: {radius: 0.5}
measure: {time: false}
reference: {spp: 16}
YAML
cat >configs/sequence.yaml <<YAML
name: sequence
scenes: [{name: cornell, view: blocks, motion: {frames: 3}}]
resolutions: [96x54]
backends: [vulkan]
techniques: [{name: gtao, params: {history: 8}}]
target: {radius: 0.5}
measure: {time: false}
reference: {spp: 16}
YAML
check "packing" bash "$root/dev.d/gpu_check.sh" "$AOBUDGET_BUILD" configs pack
expect 2 "exists and is no packed gpu-check" bash "$root/dev.d/gpu_check.sh" "$AOBUDGET_BUILD" configs configs
touch pack/of_an_earlier_time
check "packing again in the same place" bash "$root/dev.d/gpu_check.sh" "$AOBUDGET_BUILD" configs pack
check "leaves nothing of the earlier pack" test ! -e pack/of_an_earlier_time
mkdir gpu
cat >gpu/journal.jsonl <<JSON
{"key": "0", "technique": "gtao", "status": "ok", "image": "none.exr", "fingerprint": {"class": "discrete", "device": "Card"}}
JSON
expect 2 "gtao was drawn by Card: the images must be of a software driver" "$AOBUDGET_BUILD/gpu-check-data" made gpu gpu
record() { # RECORD: a run of one case, whose image is a G-buffer of the pack
  mkdir -p lacking && cp pack/data/view-1.exr lacking/
  jq -c "{key: \"0\", status: \"ok\", image: \"view-1.exr\", technique: \"gtao\", scene: \"cornell\", view: \"blocks\", metre: 1,
    params: {}, options: {}, camera: .views[1].camera, fingerprint: {class: \"cpu\"}} + $1" pack/data/check.json >lacking/journal.jsonl
}
record '{outputs: ["visibility", "specular"]}'
expect 2 "the image has nothing of the output visibility" "$AOBUDGET_BUILD/gpu-check-data" made lacking lacking
record '{outputs: [], light: {name: "probe.exr"}}'
expect 2 "cornell is lit by 'probe.exr', which is no listed light" "$AOBUDGET_BUILD/gpu-check-data" made lacking lacking
record '{outputs: ["visibility"], view: "blocks-4-frames", camera: {eye: [0, 1, 4], target: [0, 1, 0], fov_deg: 50, ortho_height: 0, shift: [0, 0],
  previous: {eye: [0, 1, 5], target: [0, 1, 0]}}, motion: {frames: 4}}'
expect 2 "cornell blocks-4-frames moves: a sequence must be of a still view" "$AOBUDGET_BUILD/gpu-check-data" made lacking lacking
mv pack "moved elsewhere"
pack=$folder/moved\ elsewhere

# What the folder needs of a machine: C's library and a driver's loaders, which it brings in case.
allowed='^(lib(c|m|dl|pthread|gcc_s|vulkan|OpenEXRCore-3_1|z|GLdispatch)\.so\.[0-9]+|ld-linux-x86-64\.so\.2)$'
[ -z "${AOBUDGET_SANITIZED:-}" ] || allowed="$allowed|^lib(asan|ubsan|stdc\+\+)\.so"
while IFS= read -r -d '' file; do
  needs=$(readelf -d "$file" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' | grep -vE "$allowed")
  check "$file needs only what is there, not: $needs" test -z "$needs"
done < <(find "$pack" -type f ! -name gpu-check \( -perm -u+x -o -name '*.so*' \) -print0)
for file in lib/libOpenEXRCore-3_1.so.30 lib/libz.so.1 lib/vulkan/libvulkan.so.1 lib/egl/libEGL.so.1 lib/egl/libGLdispatch.so.0; do
  check "it brings $file" test -s "$pack/$file"
done
check "and names the library of C that it needs" grep -qx 'needed=2\.[0-9]*' "$pack/gpu-check"
for package in glslang-dev libegl1 libglvnd0 libjansson-dev libopenexr-3-1-30 libstdc++-12-dev libvulkan1 libxxhash-dev spirv-tools zlib1g; do
  check "it brings the licence of $package" test -s "$pack/licences/$package"
done
[ -n "${AOBUDGET_SANITIZED:-}" ] || check "programs and libraries fit" test "$(du -sm "$pack" | cut -f1)" -le 20

run() { # CODE WHAT ARGUMENTS...: results.json and the table in `said`
  local code=$1 what=$2 got=0
  shift 2
  "$pack/gpu-check" --out results.json --seconds "${seconds:-250}" "$@" >said 2>complaint || got=$?
  [ "$got" -eq "$code" ] || { echo "FAILED: $what: code $got for $code"; cat said complaint; failures=$((failures + 1)); }
}
holds() { check "$1" jq -e "$2" results.json; } # WHAT FILTER

run 0 "drivers that agree" --precision 50%
holds "the document" '.schema == "aobudget gpu-check 1" and .verdict == "passed" and (.findings | length) == 0'
holds "where and when" '.program and .date and .machine.cpu and .machine.cores > 0 and .machine.system and .made_on.device'
holds "its sections" '[.sections[] | .backend + " " + .section] == ["vulkan device", "gl-egl device", "vulkan timer",
  "gl-egl timer", "vulkan images", "gl-egl images", "vulkan validation", "vulkan times", "gl-egl times"]'
for backend in vulkan gl-egl; do
  holds "$backend: its device" ".sections[] | select(.backend == \"$backend\" and .section == \"device\").items[0] |
    (.item | contains(\"llvmpipe\")) and .driver and .class == \"cpu\" and .software"
  holds "$backend: its images" "[.sections[] | select(.backend == \"$backend\" and .section == \"images\").items[]] |
    length == 10 and all(.status == \"passed\" and .pixels > 5000 and .visible_share == 0 and .max < 1e-5 and
                        .expected_rmse > 0.01 and .rmse > 0.01)"
  holds "$backend: its further outputs" "[.sections[] | select(.backend == \"$backend\" and .section == \"images\").items[] |
    select(.item | startswith(\"gtao bent_normal=on\"))] | map(.output) == [\"visibility\", \"bent_normal\",
    \"visibility_rgb\", \"specular\", \"irradiance\", \"lit\"] and all(.[1:][]; .output as \$o | .item |
    endswith(\" on gallery ball 96x54 \" + \$o)) and map(.scale)[:4] == [1, 2, 1, 1] and .[4].scale > 0.5 and .[4].scale < 1.5 and .[5].scale == .[4].scale"
  holds "$backend: its times" "[.sections[] | select(.backend == \"$backend\" and .section == \"times\").items[] |
    select(.item != \"A/A\")] | length == 10 and all(.status == \"passed\" and .ms > 0 and .rounds > 0 and .fixed_ms > 0 and
    .control > 0 and (.passes | length) > 0)"
  holds "$backend: the mean over time" "[.sections[] | select(.backend == \"$backend\" and .section == \"times\").items[] |
    select(.item == \"gtao history=16\") | .passes[].name] | index(\"changes\") and index(\"temporal\")"
  holds "$backend: A/A" ".sections[] | select(.backend == \"$backend\" and .section == \"times\").items[-1] | .item == \"A/A\" and has(\"spread\")"
done
holds "a clock that lies is not used" '[.sections[] | select(.backend == "gl-egl")] |
  (.[] | select(.section == "timer") | .status == "skipped" and (.reason | startswith("its clock says")) and
   (.items[0].checks | any(.good | not))) and
  (.[] | select(.section == "times").items | all(.item == "A/A" or .clock == "cpu"))'
holds "one that tells the truth is" '[.sections[] | select(.backend == "vulkan")] |
  ((.[] | select(.section == "timer").status) == "passed") as $trusted |
  (.[] | select(.section == "times").items | all(.item == "A/A" or .clock == (if $trusted then "device" else "cpu" end)))'
holds "the layer has nothing to say" '.sections[] | select(.section == "validation") | .status == "passed" and (.items | length) == 5'
check "the table names each technique" test "$(grep -c ' x fixed pass' said)" -eq 20
check "and the verdict" grep -q '^verdict: passed, 0 findings' said

# Another radius than that of the expected image stands for a driver that draws something else.
data="$pack/data/check.json"
cp "$data" kept.json
jq '(.images[] | select(.technique == "gtao" and .light == null and .frames == 1).params.radius) = 0.45' kept.json >"$data"
run 1 "an image that differs" --backend vulkan --section images
holds "is named" '.verdict == "disagrees" and (.findings | length) == 1 and
  (.findings[0] | startswith("vulkan, images: gtao on cornell blocks 96x54: "))'
check "in the table too" grep -q '^FINDING vulkan, images: gtao on' said
changed() { # FILTER: what findings the data give with that change
  jq "$1" kept.json >"$data"
  run 1 "$1" --backend vulkan --section images
}
changed '(.images[] | select(.frames == 3).frames) = 1'
holds "a frame without a history is another" '(.findings | length) == 1 and
  (.findings[0] | startswith("vulkan, images: gtao history=8 on cornell blocks-3-frames 96x54: "))'
changed '(.images[] | select(.light).light[0][]) *= 1.1'
holds "another light is another irradiance and lit image, and nothing else" '(.findings | length) == 2 and
  (.findings[0] | test("^vulkan, images: gtao .* on gallery ball 96x54 irradiance: .*pixels differ by more than")) and
  (.findings[1] | test("^vulkan, images: gtao .* on gallery ball 96x54 lit: .*pixels differ by more than"))'
changed '(.images[] | select(.light).params.specular_by) = "cone"'
holds "nor does another specular change more" '(.findings | length) == 2 and
  (.findings[0] | test("^vulkan, images: gtao .* on gallery ball 96x54 specular: ")) and
  (.findings[1] | test("^vulkan, images: gtao .* on gallery ball 96x54 lit: "))'
changed '.images[0].options.bent_normal = "on"'
holds "an output without an image" '(.findings | length) == 1 and
  (.findings[0] | endswith("data/image-0.exr: it has no image of the output bent_normal: pack it again"))'
jq '.images[3].light = [[1, 1, 1]]' kept.json >"$data"
expect 2 "is not nine coefficients" "$pack/gpu-check" --out results.json
jq '.images[3].frames = 0' kept.json >"$data"
expect 2 "an image lacks a field" "$pack/gpu-check" --out results.json
jq '.schema = "aobudget gpu-check data 2"' kept.json >"$data"
expect 2 "its schema is 'aobudget gpu-check data 2', and this program reads 'aobudget gpu-check data 3': pack it again" "$pack/gpu-check" --out results.json
jq '(.images[] | select(.technique == "gtao").params.radius) = 1e9' kept.json >"$data"
run 1 "values that the technique refuses" --backend vulkan --section images
holds "are no crash" '.sections[] | select(.section == "images") | .status == "failed" and (.items | length) == 5'
jq '.techniques.hbao = "0"' kept.json >"$data"
expect 2 "made with other techniques than this program's" "$pack/gpu-check" --out results.json
echo '{"schema": "another"}' >"$data"
expect 2 "its schema is 'another'" "$pack/gpu-check" --out results.json
cp kept.json "$data"
cp "$pack/data/image-0.exr" kept.exr
head -c 1000 kept.exr >"$pack/data/image-0.exr"
run 1 "a damaged image" --backend gl-egl --section images
check "is named" grep -q '^FINDING gl-egl, images: .*image-0.exr' said
cp kept.exr "$pack/data/image-0.exr"

# A layer, a driver, a device that is not there.
VK_LAYER_PATH=/nonexistent run 0 "no validation layer" --backend vulkan --section validation
holds "is told" '.sections[] | select(.section == "validation") | .status == "skipped" and (.reason | contains("no validation layer"))'
export VK_ICD_FILENAMES=/nonexistent.json VK_DRIVER_FILES=/nonexistent.json
run 0 "one backend without a driver" --section images
holds "is told, and the other is checked" '(.sections[0] | .section == "device" and .status == "skipped" and (.reason | contains("no driver"))) and
  ([.sections[] | select(.backend == "gl-egl")] | length) == 2 and ([.sections[] | select(.backend == "vulkan")] | length) == 1'
expect 2 "nothing could be checked: vulkan: no driver" "$pack/gpu-check" --out results.json --backend vulkan
unset VK_ICD_FILENAMES VK_DRIVER_FILES
expect 2 "nothing could be checked: vulkan: no device '99'" "$pack/gpu-check" --out results.json --backend vulkan --device 99
export MESA_EXTENSION_OVERRIDE=-GL_ARB_gl_spirv # a driver that lists its device, and then does not open it
run 1 "a listed device that cannot be opened" --backend gl-egl --section device
unset MESA_EXTENSION_OVERRIDE
holds "is a finding" '.sections[0].items[0].status == "failed" and (.findings | length) == 1 and
  (.findings[0] | startswith("gl-egl, device: llvmpipe") and contains("lacks GL_ARB_gl_spirv"))'
expect 2 "--device needs --backend" "$pack/gpu-check" --device 0
expect 2 "is not one of vulkan, gl-egl" "$pack/gpu-check" --backend null
expect 2 "is not one of device, timer, images" "$pack/gpu-check" --section image
expect 2 "is outside 10 .. 3600" "$pack/gpu-check" --seconds 5
expect 2 "is no percentage within 0.1% .. 50%" "$pack/gpu-check" --precision 60%
expect 2 "unknown flag --quick" "$pack/gpu-check" --quick
expect 2 "check.json" "$pack/gpu-check" --data nowhere --out results.json
expect 2 "nowhere/results.json" "$pack/gpu-check" --out nowhere/results.json
check "help" "$pack/gpu-check" --help

# A worker that crashes when a device is opened, on both backends and on one; one that hangs; one that finds no time.
mv "$pack/gpu-check-device" kept
worker() { printf '#!/bin/sh\n%s\n' "$1" >"$pack/gpu-check-device" && chmod +x "$pack/gpu-check-device"; }
worker 'kill -SEGV $$'
run 1 "drivers that crash when they are opened"
holds "are findings" '.verdict == "disagrees" and (.sections | length) == 2 and .findings == (["vulkan", "gl-egl"] |
  map(. + ", device: crashed (signal 11, segmentation fault)"))'
check "in the table" test "$(grep -c '^FINDING .*, device: crashed' said)" -eq 2
item='{"item": "a card", "number": 0, "status": "%s", "reason": "no time was left for it"}\n'
worker "read job; case \$job in *vulkan*) kill -SEGV \$\$ ;; esac; printf '$item' passed"
run 1 "one that crashes beside one that is good"
holds "is a finding" '(.findings | length) == 1 and any(.sections[]; .backend == "gl-egl" and .section == "times")'
worker "read job; case \$job in *images*) printf '$item$item' passed cut ;; *) printf '$item' passed ;; esac"
run 3 "a section that is cut" --backend vulkan --section images
holds "is told" '.verdict == "cut" and (.findings | length) == 0 and
  .cut == ["vulkan, images: 1 of 2 items, the first is a card: no time was left for it"]'
check "in a line" grep -qx 'CUT vulkan, images: 1 of 2 items, the first is a card: no time was left for it' said
worker "ln -sf /dev/null \"\$AOBUDGET_LOCK\"; printf '$item' passed"
run 3 "a lock of measuring that goes away" --backend vulkan --section times
holds "cuts what is timed, and is no finding" '(.findings | length) == 0 and (.cut | length) == 2 and
  all(.cut[]; contains("1 of 1 items, the first is the lock of measuring: "))'
expect 2 "cannot be used as the lock of measuring: " "$pack/gpu-check" --out results.json --backend vulkan --section timer
worker "printf '$item' passed"
run 0 "and is not needed where nothing is timed" --backend vulkan --section images
rm "$AOBUDGET_LOCK"
worker 'exec sleep 1000'
seconds=10 run 1 "one that hangs" --backend vulkan
check "is a finding" grep -q '^FINDING vulkan, device: did nothing for' said
mv kept "$pack/gpu-check-device"

# What a machine may lack: another library of C, another processor, the system's loaders and those of the pack.
mkdir bin
export PATH=$folder/bin:$PATH
tool() { printf '#!/bin/sh\n%s\n' "$2" >"bin/$1" && chmod +x "bin/$1"; } # NAME SCRIPT
tool getconf 'echo glibc 2.9'
expect 2 "this machine has glibc 2.9; it needs a 64-bit x86 Linux with glibc 2." "$pack/gpu-check" --help
tool getconf 'echo glibc 2.100'
check "a newer one" "$pack/gpu-check" --help
rm bin/getconf
tool uname 'echo Linux aarch64'
expect 2 "this machine is Linux aarch64" "$pack/gpu-check" --help
rm bin/uname
mv "$pack/gpu-check-main" kept
LC_ALL=C sed 's/GLIBC_2\.34/GLIBC_2.94/' kept >"$pack/gpu-check-main"
chmod +x "$pack/gpu-check-main"
expect 2 "version \`GLIBC_2.94' not found" "$pack/gpu-check" --help
mv kept "$pack/gpu-check-main"
LC_ALL=C sed 's/libvulkan\.so\.1/libvulkam.so.1/' "$pack/gpu-check-device" >kept
chmod +x kept
mv "$pack/gpu-check-device" whole
mv kept "$pack/gpu-check-device"
expect 2 "nothing could be checked: $pack/gpu-check-device: error while loading shared libraries: libvulkam.so.1" \
  "$pack/gpu-check" --out results.json --backend vulkan
finish
