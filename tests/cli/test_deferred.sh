#!/usr/bin/env bash
# The module `deferred`: its G-buffer has the surface that the depth shows, and a budget takes its cost off the frame.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
module=$AOBUDGET_BUILD/modules/deferred.so
# Its image is 1 where a triangle was drawn onto the surface, as that of `none` is everywhere.
digest() { # TECHNIQUE BACKEND FLAGS...
  local technique=$1 backend=$2
  shift 2
  "$program" shot --module "$module" --technique "$technique" --backend "$backend" --size 96x54 --reference-spp 0 "$@" --json - |
    jq -r '.image_digest // .reason'
}
same() { # BACKEND FLAGS...
  local plain drawn
  plain=$(digest none "$@") drawn=$(digest deferred "$@")
  echo "$plain $drawn"
  [ ${#plain} -eq 32 ] && [ "$plain" = "$drawn" ]
}
check "planes up to the horizon" same vulkan --scene corner --view far
check "all about the eye" same vulkan --scene room --view inside
check "off-centre" same vulkan --scene cornell --eye 0.3,1.2,1 --target 0,1,0 --shift 0.2,0.1
check "orthographic" same vulkan --scene corner --eye 0,2,4 --target 0,1,0 --ortho 3
check "on OpenGL" same gl-egl --scene room --view inside
"$program" list techniques --json list.json
check "it is no technique of the list" jq -e '[.techniques[].name] | index("deferred") == null and index("none") != null' list.json

printf 'title: a frame\nsource: made up\nframe: 1000\nrest: 990\nerror: 1\n' >frame.yaml
cat >config.yaml <<EOF
name: frame
budget: ./frame.yaml
scenes: [{name: corner, views: [front, far]}]
resolutions: [96x54]
backends: [vulkan]
techniques: [{name: none}, {name: deferred, module: "$module"}, {name: crytek_ssao}]
measure: {seconds: 0.2, images: false}
target: {radius: 1}
reference: {spp: 2}
EOF
"$program" run config.yaml --out run --quiet
check "its passes are timed" jq -se '[.[] | select(.technique == "deferred")] | length == 2 and all(.[]; [.time.passes[].name] == ["gbuffer", "composite"] and all(.time.passes[]; .cpu_ms > 0))' run/journal.jsonl
"$program" budget run --json answer.json >table || true
check "the dearest goes off the frame by its upper end" jq -e --slurpfile r run/journal.jsonl '
  ([$r[] | select(.technique == "deferred") | .time | .cpu_ms * .ci_high / .ratio_to_ref] | max) as $high |
  ([$r[] | select(.technique == "deferred") | .time.cpu_ms] | max) as $at |
  (.questions[0] | (.frame_ms.at - $at | fabs) < 1e-6 and (.frame_ms.high - $high | fabs) < 1e-6 and (.ms - (10 - $high) | fabs) < 1e-6)' answer.json
check "it is never chosen" jq -e 'all(.questions[]; .cases == 1 and ([.front[].technique] == ["crytek_ssao"]))' answer.json
check "the head says so" grep -qE '^The frame has 1000 ms: the rest takes 990 ms, G-buffer and composite take [0-9.]+ \([0-9.]+ \.\. [0-9.]+\) ms, and ambient occlusion has [0-9.]+ ms\.$' table
finish
