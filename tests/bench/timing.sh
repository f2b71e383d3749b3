# Sourced by bench.sh: what the times of a run are worth. One block of six cases is recorded once, in a hundred processes, and
# rules are applied to what was recorded; then it is measured anew five times in three processes each, and five times in six;
# then one case to a precision of 1 %. It takes about twelve minutes. Of what the device's clock and comparisons must show, the sections timer
# and compare have the rows.
if wanted timing; then
  block() { # NAME SECONDS PRECISION TECHNIQUE...
    printf 'name: %s\nscenes: [{name: atrium}]\nresolutions: [320x180]\nbackends: [vulkan]\n' "$1"
    printf 'techniques: [%s]\nmeasure: {error: false, images: false, seconds: %s, precision: %s}\n' \
      "$(printf '{name: %s}, ' "${@:4}")" "$2" "$3"
  }
  six=(none alchemy gtao crytek_ssao hbao volumetric_obscurance)
  times() { jq -r "select(.technique == \"$2\") | .time.$3" "$1/journal.jsonl"; } # RUN TECHNIQUE FIELD
  measure() { build/release/aobudget run "$folder/$1.yaml" --out "$folder/$2" --fresh --quiet; } # CONFIG RUN

  block recorded 60 0.1% "${six[@]}" >"$folder/recorded.yaml"
  measure recorded recorded
  recorded=$(echo "$folder"/recorded/rounds/*.jsonl.zst)
  verdict=$(build/release/bench/bench_rounds "$recorded" 3 15 400)
  found() { sed -n "s/^$1 //p" <<<"$verdict"; }
  row "timing: recorded rounds" "$(found rounds)" "" ">=" 2000
  row "timing: recorded processes" "$(found processes)" ""
  row "timing: intervals that cover, of 400 a slot" "$(found all)" % ">=" 90
  row "timing: intervals that cover, of 400 a slot" "$(found all)" % "<=" 98
  row "timing: the worst slot's" "$(sed -n 's/^slot_[0-9]* //p' <<<"$verdict" | sort -n | head -1)" % ">=" 90

  # On a software driver a frame is what its passes take; their medians are taken apart.
  for name in "${six[@]}"; do
    row "timing: passes of $name off their frame" "$(jq -r "select(.technique == \"$name\").time |
      ((.passes | map(.cpu_ms) | add) / .cpu_ms - 1) * 1e4 | fabs | round / 100" "$folder/recorded/journal.jsonl")" % "<=" 3
  done

  # What one second foretells for each case by itself, and what it takes then: medians of 200 runs of recorded processes.
  for precision in 0.01 0.005; do
    while read -r slot told took; do
      key=$(jq -rs ".[0].time.slots[${slot#slot_}]" "$folder/recorded/journal.jsonl")
      name=$(jq -r "select(.key == \"$key\").technique" "$folder/recorded/journal.jsonl")
      if [[ $told == *nan* || $told == 1e+09 || $took == 1e+09 ]]; then
        row "timing: foretold $name to $precision" "$told" "s of $took, not judged"
      else
        row "timing: foretold $told s of $took, $name to $precision" \
          "$(awk -v a="$told" -v b="$took" 'BEGIN { printf "%.2f", (a > b ? a / b : b / a) }')" times "<=" 2
      fi
    done < <(build/release/bench/bench_forecast "$recorded" 1 $precision 200)
  done

  # A machine is quiet where the fixed pass's wall time is its processor time over the processors, within 10 %.
  quiet=$(zstdcat "$recorded" | jq -s "map(.slots[0]) | (map(.wall_ns) | add) * $(nproc) / (map(.cpu_ns) | add) < 1.1")
  [ "$quiet" = true ] && bar=3 || bar=6
  for seconds in 0.75 1.5; do # three processes, and as many as a run has by default
    block spread $seconds 0.1% "${six[@]}" >"$folder/spread.yaml"
    for i in 1 2 3 4 5; do measure spread "spread-$i"; done
    processes=$(times "$folder/spread-1" gtao processes)
    for name in "${six[@]}"; do
      wide=$bar
      [ "$name" = none ] && wide=10
      row "timing: spread of $name, 5 runs of $processes processes" "$(for i in 1 2 3 4 5; do times "$folder/spread-$i" "$name" ratio_to_ref; done |
        sort -g | sed -n '1p; $p' | paste -sd' ' | awk '{ printf "%.1f", 100 * ($2 / $1 - 1) }')" % "<=" "$wide"
    done
  done
  row "timing: quiet machine (spread's bar 3 %, else 6 %)" "$quiet" ""

  block long 200 1% gtao >"$folder/long.yaml"
  measure long long
  row "timing: 1 % of gtao, seconds that it took" "$(times "$folder/long" gtao seconds)" s
  row "timing: 1 % of gtao, precision reached" "$(times "$folder/long" gtao precision | awk '{ print 100 * $1 }')" % "<=" 1
fi
