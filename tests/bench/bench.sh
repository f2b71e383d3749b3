#!/usr/bin/env bash
# Times, speeds and sizes that the project holds itself to: a row each, with its bar. `./dev bench [TEXT]` runs the
# sections whose name holds the text: reference, fetch, cases, merge, linear, divided, bent, effects, lit, thrift, temporal, effects_plan, tune, split, volumes, defaults, damaged, papers, timing, timer, trace, compare, history, watch, cache, shapes, stress, trend, demo, gpu-check, mutants, test. A bar that is not met stands as SHORT.
set -euo pipefail
cd "$(dirname "$0")/../.."
only=${1:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export AOBUDGET_CACHE=$folder/cache

row() { # NAME VALUE UNIT [>=|<= BAR]
  local verdict=
  if [ $# -ge 5 ]; then
    verdict=$(awk -v v="$2" -v o="$4" -v b="$5" 'BEGIN { print ((o == ">=" ? v >= b : v <= b) ? "OK" : "SHORT") }')
  fi
  printf '%-44s %10s %-8s %-2s %-6s %s\n' "$1" "$2" "$3" "${4:-}" "${5:-}" "$verdict"
}

number() { sed -n "s/^ *\"$2\": *\\([-0-9.e+]*\\),\\{0,1\\}\$/\\1/p" "$1" | head -1; } # of an indented JSON file

elapsed() { # COMMAND...: seconds of wall time
  local start=$(date +%s.%N)
  "$@" >/dev/null 2>"$folder/elapsed.log" || { cat "$folder/elapsed.log" >&2; return 1; }
  awk -v s="$start" -v e="$(date +%s.%N)" 'BEGIN { printf "%.2f", e - s }'
}

wanted() { [[ -z $only || $1 == *"$only"* ]]; }

echo "machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1), $(nproc) cores, load $(cut -d' ' -f1 /proc/loadavg); $(uname -sr)"
echo "clocks: process CPU time for costs on software drivers, monotonic wall time for durations"
printf '%-44s %10s %-8s %-9s %s\n' row value unit bar verdict

if wanted reference; then
  while read -r name value unit; do
    case $name in
      reference_speed_bunny*) row "$name" "$value" "$unit" ">=" 0.8 ;;
      *) row "$name" "$value" "$unit" ;;
    esac
  done < <(build/release/bench/bench_tracer)
fi

# A device's clock, beside the host's, of passes of 16 ms or more. On a busy machine the host waits for a processor, so
# bars are judged on a quiet one only: where wall time is processor time / threads within 10 %.
if wanted timer; then
  build/release/bench/bench_timer >"$folder/timer"
  while read -r name value unit; do
    backend=${name%%_*}
    case $name in
      vulkan_trusted) row "timer: $name" "$value" "$unit" ">=" 1 ;;
      gl-*_trusted) row "timer: $name" "$value" "$unit" ;;
      *_quiet) ;;
      vulkan_missing_*)
        if grep -q "^${backend}_quiet 1" "$folder/timer"; then
          row "timer: $name" "$value" "$unit" "<=" 3
        else
          row "timer: $name" "$value" "$unit, not judged: busy"
        fi ;;
      *) row "timer: $name" "$value" "$unit" ;;
    esac
  done <"$folder/timer"
fi

# The ceilings of a trace are 128 MiB on the device, which is this machine's memory too, and 512 MiB here.
if wanted trace; then
  while read -r name value unit; do
    case $name in
      words_missing) row "trace: $name" "$value" "$unit" "<=" 0 ;;
      added_peak) row "trace: 4K x 64 samples, memory added" "$value" "$unit" "<=" 640 ;;
      *) row "trace: 4K x 64 samples, $name" "$value" "$unit" ;;
    esac
  done < <(MESA_SHADER_CACHE_DISABLE=true build/release/bench/bench_trace)
fi

if wanted damaged; then
  while read -r name value unit; do
    case $name in
      *_files) row "damaged: $name" "$value" "$unit" ">=" 5000 ;;
      *_faults) row "damaged: $name" "$value" "$unit" "<=" 0 ;;
      *) row "damaged: $name" "$value" "$unit" ;;
    esac
  done < <(AOBUDGET_BUILD=$PWD/build/release build/release/bench/bench_damaged 5000)
fi

if wanted fetch; then
  cat >"$folder/fetch.yaml" <<EOF
name: fetch
scenes: [{name: corner}]
resolutions: [1280x720]
backends: [vulkan]
options: {fetch: [sampled, storage]}
techniques: [{name: gtao, params: {slices: 3, steps: 6, blur: 0}}]
measure: {error: false, images: false, seconds: 20}
EOF
  build/release/aobudget run "$folder/fetch.yaml" --out "$folder/fetch" --quiet
  cost() { sed -n "s/.*\"fetch\":\"$1\".*\"ratio_to_ref\":\\([0-9.e+-]*\\),.*/\\1/p" "$folder/fetch/journal.jsonl"; }
  rounds=$(sed -n 's/.*"rounds":\([0-9]*\),.*/\1/p' "$folder/fetch/journal.jsonl" | head -1)
  row "fetch: sampled gtao 3x6 720p / fixed pass" "$(cost sampled)" ratio
  row "fetch: storage gtao 3x6 720p / fixed pass" "$(cost storage)" ratio
  row "fetch: sampled / storage ($rounds rounds)" "$(awk -v a="$(cost sampled)" -v b="$(cost storage)" 'BEGIN { printf "%.3f", a / b }')" ratio ">=" 1.3
fi

source tests/bench/cases.sh
source tests/bench/merge.sh
source tests/bench/techniques.sh
source tests/bench/effects.sh
source tests/bench/papers.sh
source tests/bench/timing.sh
source tests/bench/compare.sh
source tests/bench/history.sh
source tests/bench/tune.sh
source tests/bench/watch.sh
source tests/bench/cache.sh
source tests/bench/cache_shapes.sh
source tests/bench/stress.sh

# 1,000 series of 103 nights, of which one in forty is missing.
if wanted trend; then
  mkdir "$folder/trend"
  while read -r name value unit; do
    case $name in
      points) row "trend: $name" "$value" "$unit" ">=" 100000 ;;
      seconds) row "trend: duration of the page" "$value" "$unit" "<=" 3 ;;
      *) row "trend: $name of the page" "$value" "$unit" ;;
    esac
  done < <(build/release/bench/bench_trend "$folder/trend" 1000 103)
fi

if wanted demo; then
  start=$(date +%s.%N)
  build/release/aobudget run configs/demo.yaml --out "$folder/demo" --quiet
  row "demo: duration, cold cache" "$(awk -v s="$start" -v e="$(date +%s.%N)" 'BEGIN { printf "%.1f", e - s }')" s "<=" 180
  run=$folder/demo/run.json
  rest=$(number "$run" total)
  for share in measured warmup reference images report; do
    row "demo: share of $share" "$(awk -v v="$(number "$run" $share)" -v t="$(number "$run" total)" 'BEGIN { printf "%.1f", 100 * v / t }')" "%"
    rest=$(awk -v r="$rest" -v v="$(number "$run" $share)" 'BEGIN { print r - v }')
  done
  row "demo: harness overhead (the rest)" "$(awk -v r="$rest" -v t="$(number "$run" total)" 'BEGIN { printf "%.1f", 100 * r / t }')" "%" "<=" 15
  row "demo: size of the page with its figures" "$(du -sm "$folder/demo/report" | cut -f1)" MB
fi

if wanted gpu-check; then
  ./dev gpu-check --pack "$folder/gpu-check" 2>/dev/null
  row "gpu-check: size of its folder" "$(du -sm "$folder/gpu-check" | cut -f1)" MB "<=" 40
  code=0
  "$folder/gpu-check/gpu-check" --out "$folder/gpu-check.json" >/dev/null || code=$?
  row "gpu-check: duration" "$(number "$folder/gpu-check.json" seconds)" s "<=" 300
  row "gpu-check: exit code" "$code" ""
  row "gpu-check: findings" "$(jq '.findings | length' "$folder/gpu-check.json")" lines "<=" 0
  row "gpu-check: what was cut" "$(jq '[.sections[].items[] | select(.status == "cut")] | length' "$folder/gpu-check.json")" items
fi

# The fuzzer's frames of two seeds, under the validation layer; what fails is shown again by the lines above its row.
if wanted mutants; then
  ./dev mutants >"$folder/mutants" 2>/dev/null || grep -vE '^mutant |^mutants: | killed +[0-9]+$' "$folder/mutants" || true
  read -r _ killed _ all _ _ seconds _ < <(grep '^mutants: ' "$folder/mutants")
  row "mutants: single faults that a test finds" "${killed:-0}" "" ">=" "${all:-1}"
  row "mutants: duration" "${seconds:-0}" s
fi

if wanted test; then
  start=$(date +%s)
  if ./dev test >"$folder/test.log" 2>&1; then
    row "test: duration of ./dev test" "$(($(date +%s) - start))" s "<=" 480
  else
    row "test: FAILED" "$(($(date +%s) - start))" s "<=" 0
  fi
fi
