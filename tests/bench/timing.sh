# Sourced by bench.sh: what the times of a run are worth. One block of six cases is recorded once, in many processes; then it is
# measured anew five times in three processes each; then to a precision of 1 %.
if wanted timing; then
  block() { # NAME SECONDS PRECISION TECHNIQUE...
    printf 'name: %s\nscenes: [{name: atrium}]\nresolutions: [320x180]\nbackends: [vulkan]\n' "$1"
    printf 'techniques: [%s]\nmeasure: {error: false, images: false, seconds: %s, precision: %s}\n' \
      "$(printf '{name: %s}, ' "${@:4}")" "$2" "$3"
  }
  six=(none alchemy gtao crytek_ssao hbao volumetric_obscurance)
  times() { jq -r "select(.technique == \"$2\") | .time.$3" "$1/journal.jsonl"; } # RUN TECHNIQUE FIELD
  measure() { build/release/aobudget run "$folder/$1.yaml" --out "$folder/$2" --fresh --quiet; } # CONFIG RUN

  block recorded 40 0.1% "${six[@]}" >"$folder/recorded.yaml"
  measure recorded recorded
  verdict=$(build/release/bench/bench_rounds "$folder"/recorded/rounds/*.jsonl.zst 3 15 400)
  found() { sed -n "s/^$1 //p" <<<"$verdict"; }
  row "timing: recorded rounds" "$(found rounds)" "" ">=" 2000
  row "timing: recorded processes" "$(found processes)"
  row "timing: intervals that cover, of 400 a slot" "$(found all)" % ">=" 90
  row "timing: intervals that cover, of 400 a slot" "$(found all)" % "<=" 98
  row "timing: the worst slot's" "$(sed -n 's/^slot_[0-9]* //p' <<<"$verdict" | sort -n | head -1)" % ">=" 90

  # A machine is quiet where the fixed pass's wall time is its processor time over the threads that work on it.
  quiet=$(jq -s 'map(.time) | (map(.wall_ms) | add) / (map(.cpu_ms / .threads) | add) | . < 1.1' "$folder/recorded/journal.jsonl")
  [ "$quiet" = true ] && bar=3 || bar=6
  block spread 1.5 0.1% "${six[@]}" >"$folder/spread.yaml"
  for i in 1 2 3 4 5; do measure spread "spread-$i"; done
  for name in "${six[@]}"; do
    wide=$bar
    [ "$name" = none ] && wide=10
    row "timing: spread of $name over five runs" "$(for i in 1 2 3 4 5; do times "$folder/spread-$i" "$name" ratio_to_ref; done |
      sort -g | sed -n '1p; $p' | paste -sd' ' | awk '{ printf "%.1f", 100 * ($2 / $1 - 1) }')" % "<=" "$wide"
  done
  row "timing: quiet machine (spread's bar 3 %, else 6 %)" "$quiet"

  # What one second foretells, and what it then takes.
  block short 1 1% gtao >"$folder/short.yaml"
  block long 200 1% gtao >"$folder/long.yaml"
  measure short short
  measure long long
  told=$(times "$folder/short" gtao seconds_needed) took=$(times "$folder/long" gtao seconds)
  row "timing: 1 % of gtao, seconds foretold after one" "$told" s
  row "timing: 1 % of gtao, seconds that it took" "$took" s
  row "timing: 1 % of gtao, precision reached" "$(times "$folder/long" gtao '"precision" * 100')" % "<=" 1
  if [ "$told" != null ]; then
    row "timing: foretold / took" "$(awk -v a="$told" -v b="$took" 'BEGIN { printf "%.2f", a / b }')" ratio ">=" 0.5
    row "timing: foretold / took" "$(awk -v a="$told" -v b="$took" 'BEGIN { printf "%.2f", a / b }')" ratio "<=" 2
  fi
fi
