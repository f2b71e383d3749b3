# Sourced by bench.sh: what the scene's own triangles cost, and the texts' figures.
if wanted volumes; then
  # The bunny has 69,666 triangles. A pair in one block, so that their ratio holds on a busy machine.
  entry ao_volumes 'radius: 0.1, divisor: 1' '{param: cull, values: [off, on]}' |
    config volumes '{name: bunny}' 480x270 'error: false, seconds: 20' 'spp: 2' >"$folder/volumes.yaml"
  entry ao_volumes 'radius: 0.1, divisor: 2' '' | sed 's/, sweep: \[\]//' >>"$folder/more"
  entry ao_volumes 'radius: 0.5, divisor: 4' '' | sed 's/, sweep: \[\]//' >>"$folder/more"
  entry ao_volumes 'radius: 0.5, divisor: 1' '' | sed 's/, sweep: \[\]//' >>"$folder/more"
  sed -i "/^techniques:/r $folder/more" "$folder/volumes.yaml"
  build/release/aobudget run "$folder/volumes.yaml" --out "$folder/volumes" --quiet || true
  volume() { jq -r "select(.params.radius == $1 and .params.divisor == $2 and .params.cull == \"$3\") | $4" "$folder/volumes/journal.jsonl"; }
  for point in "0.1 1 off" "0.1 1 on" "0.1 2 on" "0.5 4 on"; do
    read -r radius divisor cull <<<"$point"
    row "volumes: bunny, R $radius, divisor $divisor, cull $cull" "$(volume $radius $divisor $cull '.time.cpu_ms | round')" "ms cpu"
  done
  row "volumes: culled / all, R 0.1" "$(awk -v a="$(volume 0.1 1 on .time.ratio_to_ref)" -v b="$(volume 0.1 1 off .time.ratio_to_ref)" 'BEGIN { printf "%.3f", a / b }')" ratio "<=" 0.9
  row "volumes: textures at full size" "$(volume 0.1 1 on .memory_bytes)" bytes
  echo "volumes: R 0.5 at full size: $(volume 0.5 1 on .reason)"
fi

if wanted defaults; then
  build/release/aobudget run configs/defaults.yaml --out "$folder/defaults" --quiet || [ $? -eq 3 ]
  bad() { jq -s "[.[] | select(.status $1)] | length" "$folder/defaults/journal.jsonl"; }
  row "defaults: cases" "$(wc -l <"$folder/defaults/journal.jsonl")" "" ">=" 405
  row "defaults: cases that are not ok" "$(bad '!= "ok"')" "" "<=" 0
  jq -r 'select(.status != "ok") | "defaults: \(.scene)/\(.view) \(.technique): \(.status): \(.reason)"' "$folder/defaults/journal.jsonl"
fi

if wanted papers; then
  start=$(date +%s.%N)
  build/release/aobudget papers --quick --quiet --out "$folder/quick" --json "$folder/quick.json" || true
  row "papers: duration of papers --quick" "$(awk -v s="$start" -v e="$(date +%s.%N)" 'BEGIN { printf "%.1f", e - s }')" s "<=" 60
  row "papers: its rows without a verdict" "$(jq '[.rows[] | select(.verdict == "could not be run")] | length' "$folder/quick.json")" "" "<=" 0
  start=$(date +%s.%N)
  build/release/aobudget papers --quiet --out "$folder/papers" --json "$folder/papers.json" || true
  row "papers: duration of papers" "$(awk -v s="$start" -v e="$(date +%s.%N)" 'BEGIN { printf "%.1f", e - s }')" s
  paper() { jq ".rows[] | select(.name == \"hbao-samples\") | .measured[$1]" "$folder/papers.json"; }
  for i in 1 2; do # within 25 % of the text's
    text=$([ $i = 1 ] && echo 2.9 || echo 9.2)
    row "papers: HBAO $((4 * 2 ** i))x$((4 * 2 ** i)) / 4x4 against $text of the text" \
      "$(awk -v v="$(paper $i)" -v t="$text" 'BEGIN { d = v / t - 1; printf "%.3f", d < 0 ? -d : d }')" off "<=" 0.25
  done
  jq -r '.rows[] | "papers: \(.name): \(.verdict)\t\(.measured | map(. * 1000 | round / 1000) | join(" "))"' "$folder/papers.json" |
    while IFS=$'\t' read -r name measured; do row "$name" "$measured" ""; done
  # The texts' milliseconds, modelled: nothing is fitted, so these bars may be missed. The rows that count are judged.
  sum() { jq ".modelled.$1" "$folder/papers.json"; }
  row "papers: modelled / text, rows that count" "$(sum counted.rows)" ""
  row "papers: modelled / text, geometric mean" "$(sum 'counted.mean * 100 | round / 100')" "x" ">=" 0.8
  row "papers: modelled / text, geometric mean" "$(sum 'counted.mean * 100 | round / 100')" "x" "<=" 1.25
  row "papers: modelled / text, scatter (1 sd)" "$(sum 'counted.scatter * 100 | round / 100')" "x" "<=" 1.5
  row "papers: modelled / text, within a factor of 2" "$(sum 'counted.within_2x * 100 | round')" "%" ">=" 85
  for part in alu texture fills memory targets; do
    row "papers: the same by $part alone, mean" "$(sum "alone.$part.mean * 100 | round / 100")" "x"
    row "papers: the same by $part alone, scatter" "$(sum "alone.$part.scatter * 100 | round / 100")" "x"
  done
  row "papers: variants on one device within 25 %" "$(sum 'pairs_within * 100 | round')" "%" ">=" 70
fi
