#!/usr/bin/env bash
# An include of a higher room, planted in each room in turn, is found; so are a folder that is no room, and a technique or
# a module header that reaches into the harness.
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r "$here/../../include" "$here/../../harness" "$here/../../reports" "$here/../../techniques" "$folder"
failures=0
bash "$here/layers.sh" "$folder" || { echo "FAILED: the tree itself has a breach"; failures=1; }

# plant FILE INCLUDE: a new file with this include must be complained of, by its name.
plant() {
  mkdir -p "$(dirname "$folder/$1")"
  echo "#include $2" >"$folder/$1"
  if bash "$here/layers.sh" "$folder" >"$folder/said"; then
    echo "FAILED: $1 with $2 is not found"
    failures=$((failures + 1))
  elif ! grep -qF "$1" "$folder/said" || [ "$(wc -l <"$folder/said")" -ne 1 ]; then
    echo "FAILED: $1 with $2: one line that names it is expected, not:"
    cat "$folder/said"
    failures=$((failures + 1))
  fi
  rm "$folder/$1"
}
plant include/aobudget/planted.h '"base/error.h"'
plant include/aobudget/planted.h '<base/error.h>'
plant harness/base/planted.c '"config/config.h"'
plant harness/config/planted.c '"plan/plan.h"'
plant harness/config/planted.c '"technique/param.h"' # of its own layer
plant harness/technique/planted.c '"gpu/gpu.h"'
plant harness/scene/planted.c '"gpu/gpu.h"'
plant harness/gpu/planted.c '"store/image.h"'
plant harness/gpu/vulkan/planted.c '"frame/frame.h"'
plant harness/gpu/gl/planted.c '"gpu/vulkan/vk.h"'
plant harness/gpu/null/planted.c '"gpu/gl/gl.h"'
plant harness/plan/planted.c '"store/journal.h"'
plant harness/reference/planted.c '"gbuffer/gbuffer.h"'
plant harness/store/planted.c '"frame/frame.h"'
plant harness/gbuffer/planted.c '"score/score.h"'
plant harness/job/planted.c '"gbuffer/gbuffer.h"'
plant harness/frame/planted.c '"timing/timing.h"'
plant harness/score/planted.c '"timing/timing.h"'
plant reports/page/planted.c '"run/run.h"'
plant reports/page/planted.c '"reports/plot/viz.h"'
plant reports/plot/planted.c '"scene/scene.h"'
plant reports/plot/planted.cpp '"reports/page/page.h"'
plant harness/timing/planted.c '"run/run.h"'
plant harness/run/planted.c '"worker/worker.h"'
plant harness/worker/planted.c '"run/dispatch.h"'
plant harness/papers/planted.c '"command/command.h"'
plant harness/gpu_check/planted.c '"reference/tracer.h"'
plant harness/command/planted.c '"gpu_check/check.h"'
plant harness/nowhere/planted.c '<stdio.h>'
plant harness/base/planted.c '"../config/config.h"'
plant techniques/gtao/planted.c '"config/config.h"'
plant techniques/gtao/planted.c '"plan/plan.h"'
plant techniques/gtao/planted.c '<harness/base/text.h>'
plant techniques/gtao/planted.c '"reports/page/page.h"'
plant techniques/planted.c '<stdio.h>'
[ $failures -eq 0 ] && echo "all plants were found"
exit $((failures > 0))
