# Sourced by bench.sh: every technique on every backend put to every property, the technique that keeps all of them, and the
# frame fuzzer. jq reads the documents.
if wanted stress; then
  start=$(date +%s)
  build/release/aobudget stress --quiet --json "$folder/stress.json" >/dev/null || true
  row "stress: duration of the whole" "$(($(date +%s) - start))" s "<=" 600
  row "stress: properties" "$(jq '.properties | length' "$folder/stress.json")" "" ">=" 60
  for outcome in pass fail "by definition" n/a; do
    count=$(jq --arg o "$outcome" '.counts[$o]' "$folder/stress.json")
    [ "$outcome" = fail ] && row "stress: cells that fail" "$count" cells "<=" 0 || row "stress: cells: $outcome" "$count" cells
  done
  row "stress: cells by definition" "$(jq '100 * .counts["by definition"] / (.counts | add)' "$folder/stress.json" | cut -c1-5)" "%" "<=" 10
  row "stress: backends that are missing" "$(jq '[.rows[] | select(.missing)] | length' "$folder/stress.json")" rows "<=" 0
  jq -r '.rows[] | . as $r | .cells[] | select(.outcome == "fail") | "  fails: \($r.technique) on \($r.backend): \(.property): \(.reason)"' "$folder/stress.json"
  start=$(date +%s)
  build/release/aobudget stress --quick --quiet --backend vulkan --json "$folder/quick.json" >/dev/null || true
  row "stress: duration of --quick on vulkan" "$(($(date +%s) - start))" s "<=" 60
  while IFS=: read -r name wanted; do
    build/release/aobudget stress --quiet --module "build/release/tests/broken/$name.so" --backend vulkan --json "$folder/broken.json" >/dev/null || true
    failed=$(jq -r '.rows[].cells[] | select(.outcome == "fail") | .property' "$folder/broken.json")
    unlike=$(comm -3 <(tr ' ' '\n' <<<"$wanted" | sed '/^$/d' | sort) <(sed '/^$/d' <<<"$failed" | sort) | tr -d '\t' | tr '\n' ' ')
    row "stress: $name: answers that are not as listed" "$(wc -w <<<"$unlike")" cells "<=" 0
    echo "  fails: $(tr '\n' ' ' <<<"$failed")${unlike:+; not as listed: $unlike}"
  done < <(sed '/^#/d' tests/broken/caught.txt)
fi

# Frames drawn by lot, under the validation layer.
if wanted stress; then
  for seed in 1 2; do
    AOBUDGET_VALIDATE=1 build/release/aobudget stress --fuzz 50000 --seed $seed --json "$folder/fuzz-$seed.json" \
      --quiet || true
    jq -r '.rows[] | select(.findings != []) | .findings[] | "\(.fault), \(.frames) frames: \(.command)"' "$folder/fuzz-$seed.json"
  done
  fuzz() { jq -s "$1" "$folder"/fuzz-[12].json; }
  row "stress: frames drawn by lot, seeds 1 and 2" "$(fuzz 'map(.frames) | add')" "" ">=" 100000
  row "stress: those that fail" "$(fuzz 'map(.failed) | add')" "" "<=" 0
  row "stress: those that are refused" "$(fuzz 'map(.refused) | add')" ""
  row "stress: frames a second" "$(fuzz '(map(.frames) | add) / (map(.seconds) | add) | round')" 1/s
fi
