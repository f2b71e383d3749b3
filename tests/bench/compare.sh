# Sourced by bench.sh: how often `aobudget compare` says what is true. Rounds are recorded once for each pair of builds, in
# 80 processes or more; the rule is applied to 400 choices of five of them, the least that a comparison measures.
if wanted compare; then
  builds=build/release/tests/modules processes=5 trials=400
  cat >"$folder/compare.yaml" <<EOY
name: compare
scenes: [{name: corner}]
resolutions: [320x180]
backends: [vulkan]
techniques: [{name: loop}]
measure: {error: false}
EOY
  record() { # A B: into $folder/compare-A-B
    build/release/aobudget compare "$builds/$1.so" "$builds/$2.so" --config "$folder/compare.yaml" --seconds 20 \
      --precision 0.2% --out "$folder/compare-$1-$2" --quiet || [ $? -ne 2 ]
  }
  verdicts() { # A B PRECISION [FROM TO]: lines "VERDICT COUNT"; FROM TO: 1 0 for A against B
    build/release/bench/bench_compare "$folder/compare-$1-$2"/rounds/*.jsonl.zst "${4:-0}" "${5:-1}" "$3" "$processes" "$trials"
  }
  share() { awk -v a="$1" -v b="${2:-$1}" -v n="$trials" '$1 == a || $1 == b { sum += $2 } END { printf "%.1f", 100 * sum / n }'; }
  for pair in "loop100 loop_again" "loop16 loop17" "loop100 loop103"; do
    record $pair
  done
  load=$(verdicts loop100 loop_again 0.02 | sed -n 's/^load //p')
  row "compare: processors left to the fixed pass" "$load" share
  row "compare: A/A flagged, $trials pairs" "$(verdicts loop100 loop_again 0.02 | share SLOWER FASTER)" % "<=" 2
  row "compare: A/A flagged at 1 %" "$(verdicts loop100 loop_again 0.01 | share SLOWER FASTER)" % "<=" 2
  row "compare: A/A SAME" "$(verdicts loop100 loop_again 0.02 | share SAME)" %
  row "compare: 17 trips against 16 SLOWER" "$(verdicts loop16 loop17 0.02 | share SLOWER)" % ">=" 90
  row "compare: 16 trips against 17 FASTER" "$(verdicts loop16 loop17 0.02 1 0 | share FASTER)" % ">=" 90
  row "compare: +3 % SLOWER with --precision 1%" "$(verdicts loop100 loop103 0.01 | share SLOWER)" % ">=" 80
fi
