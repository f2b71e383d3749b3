#!/usr/bin/env bash
# watch_record.sh NIGHTS WORK: records what bench_watch draws from, with build/release, into tests/bench/watch_nights.tsv and
# watch_pairs.tsv. A "night" is a run of twelve cases in five processes, one right after the other; after every fourth, two
# builds of equal code are compared in twenty processes. What WORK holds already is not measured again. A night takes half a minute.
set -euo pipefail
cd "$(dirname "$0")/../.."
nights=$1 work=$2 build=$PWD/build/release
techniques=(gtao hbao alchemy volumetric_obscurance crytek_ssao none) backends=(vulkan gl-osmesa)
mkdir -p "$work"
export AOBUDGET_CACHE=$work/cache

cat >"$work/nights.yaml" <<EOF
name: nights
scenes: [{name: corner}]
resolutions: [320x180]
backends: [vulkan, gl-osmesa]
techniques:
  - name: none
  - name: alchemy
  - name: gtao
    params: {slices: 1, steps: 4}
  - name: crytek_ssao
  - name: hbao
  - name: volumetric_obscurance
measure: {error: false, images: false, seconds: 1.25, precision: 1%}
EOF

pair() { # NUMBER
  local technique=${techniques[$(($1 % 6))]} backend=${backends[$(($1 / 6 % 2))]}
  [ ! -e "$work/pair-$1/journal.jsonl" ] || return 0
  printf 'name: pair\nscenes: [{name: corner}]\nresolutions: [320x180]\nbackends: [%s]\ntechniques: [{name: %s}]\nmeasure: {error: false, images: false}\n' \
    "$backend" "$technique" >"$work/pair.yaml"
  echo "another build" >"$work/note"
  objcopy --add-section .another="$work/note" "$build/modules/$technique.so" "$work/$technique.so"
  "$build/aobudget" compare "$build/modules/$technique.so" "$work/$technique.so" --config "$work/pair.yaml" --seconds 5 \
    --precision 0.2% --out "$work/pair-$1" --quiet >/dev/null || [ $? -ne 2 ]
}

for ((night = 1; night <= nights; night++)); do
  if [ ! -e "$work/loads/$night" ]; then
    "$build/aobudget" run "$work/nights.yaml" --out "$work/night-$night" --fresh --quiet
    mkdir -p "$work/loads"
    cut -d' ' -f1 /proc/loadavg >"$work/loads/$night"
  fi
  [ $((night % 4)) -ne 0 ] || pair $((night / 4 - 1))
done

heading() { # WHAT
  echo "# $1"
  jq -rs '.[0] | "# \(.fingerprint.cpu), \(.fingerprint.cores) cores; \(.fingerprint.driver); clock: \(.time.clock) (processor time of the process)"' \
    "$work/night-1/journal.jsonl"
  echo "# $(date -u -r "$work/night-1/journal.jsonl" '+%F %R') to $(date -u -r "$work/night-$nights/journal.jsonl" '+%R') UTC, 320x180; load $(sort -g "$work"/loads/* |
    awk '{ l[NR] = $1 } END { print l[1] " to " l[NR] ", median " l[int((NR + 1) / 2)] }'): other programs were built and tested on the machine meanwhile"
}

# Deviations from the median over nights.
{
  heading "Nights that bench_watch draws from: a row each; of each case the deviation of ln(ratio) and half of ln(high / low), in 1e-5."
  jq -rs 'sort_by(.backend, .technique) | map("\(.technique) \(.backend)") | join("\t")' "$work/night-1/journal.jsonl"
  for ((night = 1; night <= nights; night++)); do
    jq -rs 'sort_by(.backend, .technique) | map("\(.time.ratio_to_ref | log) \((.time.ci_high / .time.ci_low | log) / 2)") | join(" ")' \
      "$work/night-$night/journal.jsonl"
  done | awk '{ for (i = 1; i <= NF; i++) v[NR, i] = $i; n = NF }
    function median(i, r, k, x, s) {
      for (r = 1; r <= NR; r++) { x = v[r, i]; for (k = r - 1; k > 0 && s[k] > x; k--) s[k + 1] = s[k]; s[k + 1] = x }
      return (s[int((NR + 1) / 2)] + s[int((NR + 2) / 2)]) / 2
    }
    END { for (i = 1; i <= n; i += 2) m[i] = median(i)
      for (r = 1; r <= NR; r++) for (i = 1; i <= n; i += 2)
        printf "%.0f\t%.0f%s", 1e5 * (v[r, i] - m[i]), 1e5 * v[r, i + 1], i + 1 < n ? "\t" : "\n" }'
} >tests/bench/watch_nights.tsv

{
  heading "Two builds of equal code in one block: a row a process; its recording, its case, ln(B / A) of its rounds, and of its two fixed passes, in 1e-4."
  for folder in $(ls -d "$work"/pair-[0-9]* | sort -V); do
    case=$(jq -rs '.[0] | "\(.technique) \(.backend)"' "$folder/journal.jsonl")
    zstdcat "$folder"/rounds/*.jsonl.zst | jq -rs --arg name "$(basename "$folder")" --arg case "$case" '
      def ms(i): .slots[i] | .cpu_ns / .frames;
      def change(a; b): (ms(b) / ms(a) | log * 1e4 | round);
      group_by(.process)[] | "\($name)\t\($case)\t\(map(change(2; 3)) | join(","))\t\(map(change(0; 1)) | join(","))"'
  done
} >tests/bench/watch_pairs.tsv
wc -c tests/bench/watch_nights.tsv tests/bench/watch_pairs.tsv
