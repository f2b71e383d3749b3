# Sourced by bench.sh: what the number of cases costs where nothing is measured. The journal of a finished run is written,
# not run: the record of one case, with the identity of each.
if wanted cases; then
  cat >"$folder/cases.yaml" <<EOF
name: cases
scenes: [{name: corner, views: [front, far]}]
resolutions: [64x36]
backends: ["null"]
options: {fetch: [sampled, storage], guard_band: [0, 8, 16, 24, 32]}
techniques:
  - name: gtao
    sweep:
      - {param: radius, from: 0.02, to: 2, step: 0.02}
      - {param: slices, from: 1, to: 10, step: 1}
target: {radius: 1}
measure: {time: false, images: false}
reference: {spp: 2}
EOF
  row "cases: plan of 20,000" "$(elapsed build/release/aobudget plan "$folder/cases.yaml")" s "<=" 2
  # The record of one case with all its figures, and 10,000 of them that differ in cost and error.
  cat >"$folder/one.yaml" <<EOF
name: one
scenes: [{name: corner}]
resolutions: [160x90]
backends: [vulkan]
techniques: [{name: gtao}]
measure: {seconds: 0.2, images: false, cache: [ps4]}
reference: {spp: 2}
EOF
  build/release/aobudget run "$folder/one.yaml" --out "$folder/one" --quiet
  cp "$folder/one/journal.jsonl" "$folder/one.jsonl"
  cp "$folder/one/run.json" "$folder/one.json"
  # budget_row FILTER KEYS WHAT: FILTER makes of the record what each case has, KEYS run.json's list.
  budget_row() {
    jq -c "$1"' | . as $r | range(10000) | . as $i | $r | .key = "\($i)" | .params.radius = $i
      | .time.cpu_ms = 1 + ($i * 7919 % 10007) / 1000 | .errors[].band_rmse = (1 + $i * 104729 % 10009) / 10010' \
      "$folder/one.jsonl" >"$folder/one/journal.jsonl"
    jq ".cases = 10000 | $2" "$folder/one.json" >"$folder/one/run.json"
    row "cases: budget of 10,000, $3, $(($(wc -c <"$folder/one/journal.jsonl") / 1000000)) MB" \
      "$(elapsed build/release/aobudget budget "$folder/one" --ms 5)" s "<=" 1
  }
  budget_row . 'del(.keys)' "1 view, target and profile"
  budget_row '.errors = [range(3) as $t | .errors[0] | .target.radius += $t] | .cache.second = .cache.ps4' \
    '.keys = [range(10000) | tostring]' "3 targets, 2 profiles, keys"
  # A config near its limit of a megabyte: what reads it must not look at every entry for each entry.
  {
    echo 'name: cameras'
    echo 'scenes:'
    awk 'BEGIN { for (i = 1; i <= 19000; i++) print "- {name: corner, eye: [0, " i ", 4], target: [0, 0, 0]}" }'
    printf 'resolutions: [8x8]\nbackends: ["null"]\ntechniques: [{name: none}]\n'
  } >"$folder/cameras.yaml"
  row "cases: plan of 19,000 cameras, a config of 0.9 MB" "$(elapsed build/release/aobudget plan "$folder/cameras.yaml")" s "<=" 3
  build/release/aobudget run "$folder/cases.yaml" --out "$folder/cases" --quiet \
    --filter "corner/front gtao radius=0.02 slices=1 guard_band=0 fetch=sampled "
  build/release/aobudget plan "$folder/cases.yaml" --json "$folder/cases.json"
  cp "$folder/cases/journal.jsonl" "$folder/first.jsonl"
  jq -c --slurpfile first "$folder/first.jsonl" '.cases[] | $first[0] + (. | del(.status, .reason))' \
    "$folder/cases.json" >"$folder/cases/journal.jsonl"
  # The journal is newer than the page here: the first resume draws it, as a run that was stopped before its end would.
  row "cases: run resumes 20,000 and draws their page" "$(elapsed build/release/aobudget run "$folder/cases.yaml" --out "$folder/cases" --quiet)" s
  row "cases: run resumes 20,000 finished ones" "$(elapsed build/release/aobudget run "$folder/cases.yaml" --out "$folder/cases" --quiet)" s "<=" 3
  row "cases: records in the journal after it" "$(wc -l <"$folder/cases/journal.jsonl")" lines "<=" 20000
fi
