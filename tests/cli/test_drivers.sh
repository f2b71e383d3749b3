#!/usr/bin/env bash
# A sweep on every driver there is, from config to page, Vulkan under its validation layer; then the fields of the
# contract in journal, JSON documents and images.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_VALIDATE=1
cat >config.yaml <<EOF
name: drivers
scenes: [{name: corner}, {name: spheres, view: close}]
resolutions: [96x54]
backends: [vulkan, gl-egl, gl-osmesa]
options: {guard_band: 16, fetch: [sampled, storage]}
techniques: # one on every driver, and others beside it on each
  - {name: gtao, params: {radius: 0.5}}
  - {name: gtao, params: {radius: 1}, backends: [vulkan]}
  - {name: alchemy, params: {radius: 0.5}, backends: [gl-egl]}
  - {name: none, backends: [gl-osmesa]}
measure: {seconds: 0.1}
reference: {spp: 64}
EOF
check "the sweep" "$program" run config.yaml --out out --json summary.json
grep -q '"ok": 24' summary.json || { cat summary.json out/journal.jsonl | cut -c1-400; }
check "24 cases ok" grep -q '"ok": 24' summary.json
check "the page" grep -q '<html' out/report/index.html
check "its pictures" test "$(ls out/report/figures/*.png | wc -l)" -ge 10
for field in key scene view technique revision params options backend width height status time error memory_bytes \
  image fingerprint clock cpu_ms wall_ms device_ms ratio_to_ref ci_low ci_high precision precision_wanted seconds seconds_needed \
  processes rounds clean_rounds frames seed threads setup_ms ref_ms control_low control_high slots rounds_file passes reference \
  rmse band_rmse border_rmse mae bias p95 max flip ssim reference_se definition_rmse pixels; do
  check "every line has $field" test "$(grep -c "\"$field\":" out/journal.jsonl)" -eq 24
done

# One technique at one place: the same figures on every backend and fetch, to the last digit.
scores=$(jq -c 'select(.technique == "gtao" and .params.radius == 0.5 and .scene == "corner") | .error | [.rmse, .band_rmse]' \
  out/journal.jsonl | sort -u | wc -l)
check "backends agree" test "$scores" -eq 1

# shot: one document on standard output, nothing else; its image has the contract's channels.
check "shot" "$program" shot --technique alchemy --scene spheres --size 96x54 --reference-spp 16 --out shot.exr --json shot.json -p fetch=storage -p radius=0.3
check "its fields" grep -q '"band_rmse"' shot.json
"$program" shot --technique none --scene plane --size 32x18 --backend gl-egl --reference-spp 2 --json - >document 2>/dev/null
check "nothing but the document" test "$(head -c1 document)$(tail -c2 document | head -c1)" = "{}"
for channel in Z N.X N.Y N.Z technique.AO reference.AO reference.SE error.AO definition.AO aobudget.eye aobudget.fov_deg; do
  check "the image has $channel" grep -qa "$channel" shot.exr
done

# Colours only of a painted scene, velocity only of a camera that moves; the lens shift in an attribute.
cat >moving.yaml <<'YAML'
name: moving
scenes:
  - {name: cornell, eye: [0, 1, 3.4], target: [0, 1, 0], shift: [0.25, 0], previous: {eye: [0.1, 1, 3.4], target: [0, 1, 0]}}
resolutions: [32x18]
backends: ["null"]
techniques: [{name: none}]
measure: {time: false, error: false}
YAML
check "a moving, off-centre camera" "$program" run moving.yaml --out moving --quiet
for channel in albedo.R albedo.G albedo.B roughness metalness V.X V.Y V.Z aobudget.shift; do
  check "its image has $channel" grep -qa "$channel" moving/images/*.exr
done
check "and its record" grep -q '"shift":\[0.25,0.0\],"previous":{"eye":\[0.1' moving/journal.jsonl
check "the image of a still one has no velocity" test "$(grep -ca 'V\.X\|albedo' shot.exr)" -eq 0

# A user's mesh, framed by itself and by a camera.
printf 'v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 1 -1\nv 1 1 -1\nf 1 3 2\nf 1 4 3\nf 1 2 6\nf 1 6 5\n' >mesh.obj
check "a mesh file" "$program" shot --technique gtao --scene mesh.obj --size 96x54 --reference-spp 16
awk '/^v/ { $2 += 3e5; $3 += 3e5 } { print }' mesh.obj >far.obj
"$program" shot --technique none --scene far.obj --size 16x9 --reference-spp 2 --backend null >/dev/null 2>far.err
check "a mesh far from the origin is warned of, with the step of its rounding" grep -q 'warning: far.obj: it lies .* rounded to steps of 0.031' far.err
awk '/^v/ { $2 += 2e4 } { print }' mesh.obj >four.obj
"$program" shot --technique none --scene four.obj --size 16x9 --reference-spp 2 --backend null >/dev/null 2>four.err
check "at 10,000 times its side it is, in one line" test "$(grep -c 'warning: four.obj: it lies .* rounded to steps of 0.002;' four.err)" -eq 1
awk '/^v/ { $2 += 200 } { print }' mesh.obj >two.obj
"$program" shot --technique none --scene two.obj --size 16x9 --reference-spp 2 --backend null >/dev/null 2>two.err
check "at 100 times its side it is not" test "$(grep -c warning two.err)" -eq 0
{
  printf 'ply\nformat ascii 1.0\nelement vertex 600\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'element tristrips 1\nproperty list int int vertex_indices\nend_header\n'
  for i in $(seq 600); do echo "$i 0 $((i % 2))"; done
  echo "600 $(seq -s ' ' 0 599)"
} >strip.ply
code=0
"$program" shot --technique none --scene strip.ply --size 16x9 --reference-spp 2 --backend null >/dev/null 2>strip.err || code=$?
check "and strips that were not understood" grep -q 'warning: strip.ply: .* bytes but only 1 triangles' strip.err
check "and a camera" "$program" shot --technique gtao --scene mesh.obj --eye 0,1,3 --target 0,0.3,0 --fov 50 --size 96x54 --reference-spp 16
check "off-centre" "$program" shot --technique gtao --scene mesh.obj --eye 0,1,3 --target 0,0.3,0 --shift 0.2,-0.1 --size 96x54 --reference-spp 16
check "orthographic" "$program" shot --technique gtao --scene mesh.obj --eye 0,1,3 --target 0,0.3,0 --ortho 2 --size 96x54 --reference-spp 16
check "a module in place of the built-in" "$program" shot --technique gtao --scene corner --size 32x18 --reference-spp 2 --module "$AOBUDGET_BUILD/modules/gtao.so"

# What the rasteriser draws in place of what rays see: nearly the same, on each backend; and on a mesh from a file.
for backend in vulkan gl-egl gl-osmesa; do
  check "a raster G-buffer on $backend" "$program" shot --technique gtao --scene corner --size 96x54 --reference-spp 16 \
    --backend $backend -p gbuffer=raster -p guard_band=16 --json raster.json
  check "its share of other pixels" awk '/"primitive_share"/ { ok = $2 + 0 <= 0.01 } END { exit !ok }' raster.json
  check "and its other figures" test "$(grep -cE '"(edge_share|depth_rmse|depth_max)"' raster.json)" -eq 3
done
check "of a mesh file" "$program" shot --technique gtao --scene mesh.obj --size 96x54 --reference-spp 16 -p gbuffer=raster --json raster.json
check "compared too" grep -q '"primitive_share"' raster.json
expect 2 "unsupported: gbuffer=raster: backend 'null' draws nothing" "$program" shot --technique gtao --scene corner --size 32x18 --backend null -p gbuffer=raster
check "canonical says nothing of it" bash -c "! grep -q primitive_share shot.json"

check "doctor" "$program" doctor --json doctor.json
check "every backend is found" test "$(grep -c '"what": "backend"' doctor.json)" -eq 4
code=0; VK_ICD_FILENAMES=/nonexistent.json VK_DRIVER_FILES=/nonexistent.json "$program" doctor >sick 2>&1 || code=$?
check "a missing driver gives 3" test $code -eq 3
check "with its cure" grep -q 'apt-get install libvulkan1 mesa-vulkan-drivers' sick

for what in techniques scenes backends; do
  check "list $what" "$program" list $what
  check "list $what --json" "$program" list $what --json list.json
  check "its list" grep -q "\"$what\"" list.json
done
check "plan" "$program" plan config.yaml
head -n 20 out/journal.jsonl >short.jsonl && mv short.jsonl out/journal.jsonl
expect 3 "20 of 24 cases" "$program" report out --out page2
check "the second page" test -s page2/index.html
check "resume measures the rest" "$program" run config.yaml --out out --quiet
check "24 lines" test "$(wc -l <out/journal.jsonl)" -eq 24
finish
