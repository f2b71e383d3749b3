#!/usr/bin/env bash
# A frame of another renderer, end to end; what is no such frame, in one line.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
shot=("$program" shot --technique gtao --size 96x54 --backend null)
capture=("$program" shot --technique none --backend null --scene capture:F.exr)
check "a frame of our own" "${shot[@]}" --scene corner --reference-spp 2 --out F.exr
check "as a capture" "${capture[@]}" --json one.json --out again.exr
check "ok" grep -q '"status": "ok"' one.json
check "of the file's size" grep -q '"width": 96' one.json
check "with a time" grep -q '"cpu_ms"' one.json
check "compared with the screen-space bound" grep -q '"reference": "screen"' one.json
check "by the default of rays" grep -q '"spp": 256' one.json
check "by flags" "${capture[@]}" --depth distance --far 50 --normals world --handed left --up 0,1,1 --eye 0,1,4 --target 0,1,0 --fov 40

# What looks like no depth is doubted in one line, unless the convention is stated or the file is of this program.
LC_ALL=C sed 's/aobudget\.fov_deg/aobudget.fov_dex/' F.exr >M.exr
doubtful=("$program" shot --technique none --backend null --reference-spp 2 --scene capture:M.exr --fov 50 --normals derived)
expect 0 "M.exr: every depth lies within 0..1 (" "${doubtful[@]}" --depth-channel reference.AO
check "no word if it is stated" bash -c '"$@" 2>err && ! test -s err' - "${doubtful[@]}" --depth-channel reference.AO --depth planar
check "nor of a depth" bash -c '"$@" 2>err && ! test -s err' - "${doubtful[@]}"

expect 2 "nowhere.exr: cannot open" "$program" shot --technique none --backend null --scene capture:nowhere.exr
echo rubbish >rubbish.exr
expect 2 "rubbish.exr: cannot read the image" "$program" shot --technique none --backend null --scene capture:rubbish.exr
expect 2 "rubbish.exr: cannot read the image" "$program" shot --technique none --backend null --scene capture:rubbish.exr --fov 60
expect 2 "unsupported: it needs the scene's triangles" "$program" shot --technique ao_volumes --backend null --scene capture:F.exr
expect 2 "depth: 'deep' is not one of planar" "${capture[@]}" --depth deep
expect 2 "needs near and a far" "${capture[@]}" --depth device
expect 2 "is it planar?" "${capture[@]}" --depth device_reversed --near 0.1 --far inf
expect 2 "near: '-1' is not a length" "${capture[@]}" --near -1
expect 2 "far: 'x' is not a length" "${capture[@]}" --far x
expect 2 "up: '0,0,0' has no direction" "${capture[@]}" --up 0,0,0
expect 2 "no channel 'W'" "${capture[@]}" --depth-channel W
expect 2 "all depths are sky" "${capture[@]}" --far 0.01
expect 2 "its own size" "${capture[@]}" --size 8x8
expect 2 "its own size" "${capture[@]}" --view front
expect 2 "guard_band must be 0" "${capture[@]}" -p guard_band=8
check "an off-centre frame" "${shot[@]}" --scene corner --reference-spp 2 --eye 0,2,4 --target 0,1,0 --shift 0.5,0 --out S.exr
expect 2 "S.exr: its view is off-centre (shift 0.5, 0)" "$program" shot --technique none --backend null --scene capture:S.exr
expect 2 "gbuffer must be canonical" "${capture[@]}" -p gbuffer=raster
expect 2 "stated of a capture" "${shot[@]}" --scene corner --normals view

config() { # SCENE [REST]
  cat >config.yaml <<END
name: capture
scenes: [$1]
backends: [null]
techniques: [{name: none}, {name: gtao, params: {slices: [1, 2]}}]
measure: {seconds: 0.05}
$2
END
}
config '{capture: F.exr}'
check "a run without resolutions" "$program" run config.yaml --out out --quiet
check "three cases" test "$(grep -c '"status":"ok"' out/journal.jsonl)" -eq 3
check "all against the bound" test "$(grep -c '"reference":"screen"' out/journal.jsonl)" -eq 3
check "the page says so" grep -q 'capture:F.exr' out/report/index.html
config '{name: "capture:F.exr", depth: distance, normals: world, up: [0, 1, 1], eye: [0, 1, 4], target: [0, 1, 0], fov_deg: 40}'
check "all keys" "$program" plan config.yaml
config '{capture: F.exr, depth: deep}'
expect 2 "config.yaml:2:34: depth: 'deep'" "$program" plan config.yaml
config '{capture: F.exr, depth: device}'
expect 2 "config.yaml:2:10: depth device needs near" "$program" plan config.yaml
config '{capture: rubbish.exr}'
expect 2 "config.yaml:2:10: rubbish.exr: cannot read" "$program" run config.yaml --out out2
config '{name: corner, near: 1}'
expect 2 "keys of a capture" "$program" plan config.yaml
config '{name: corner}'
expect 2 "'resolutions' is missing" "$program" plan config.yaml
config '{capture: F.exr}' 'options: {guard_band: [0, 16]}'
expect 2 "guard_band must be 0" "$program" plan config.yaml

# The same depth and normals give the same image.
if "${shot[@]:0:6}" --scene corner --backend gl-egl --reference-spp 2 --out G.exr >/dev/null 2>&1; then
  check "on a device" "$program" shot --technique gtao --backend gl-egl --scene capture:G.exr --out H.exr
  check "the images are the same" "$AOBUDGET_BUILD/compare_images" G.exr H.exr technique.AO Z N.X N.Y N.Z
fi
finish
