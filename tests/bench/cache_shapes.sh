# Sourced by bench.sh: shapes that simulated caches must show, and how they compare with times of this machine.
if wanted shapes; then
  sweep() { # NAME SCENE SIZE TECHNIQUES MEASURE: runs it into $folder/NAME
    printf 'name: %s\nscenes: [%s]\nresolutions: [%s]\nbackends: [vulkan]\ntechniques: [%s]\nmeasure: {error: false, images: false, %s}\n' \
      "$@" >"$folder/$1.yaml"
    build/release/aobudget run "$folder/$1.yaml" --out "$folder/$1" --fresh --quiet
  }
  wall='{name: plane, view: top}' # all of it 5 m away: a radius in metres is one in pixels
  # Lines "radius figure" of a pass, by radius. FIGURE is of the pass's object.
  curve() { # RUN PROFILE PASS FIGURE [FILTER]
    jq -r "select(${5:-true}) | \"\\(.params.radius) \\(.cache.$2.passes[] | select(.name == \"$3\") | $4)\"" "$folder/$1/journal.jsonl" | sort -g
  }
  # The radius at half of the plateau, between two points by their logarithms.
  knee() {
    awk '{ x[NR] = $1; y[NR] = $2; if ($2 > top) top = $2 }
      END { for (i = 2; i <= NR; i++) if (y[i] >= top / 2) { print x[i - 1] * (x[i] / x[i - 1]) ^ ((top / 2 - y[i - 1]) / (y[i] - y[i - 1])); exit } }'
  }
  # Of lines "x y": "R^2 slope" of the straight line through those with LOW <= x <= HIGH.
  line() {
    awk -v low="$1" -v high="$2" '$1 >= low && $1 <= high { n++; a += $1; b += $2; aa += $1 * $1; bb += $2 * $2; ab += $1 * $2 }
      END { v = aa - a * a / n; w = bb - b * b / n; c = ab - a * b / n; print c * c / (v * w), c / v }'
  }
  level='.levels[0].one.miss_ratio'

  # 12 fixed samples of 8 and of 96 pixels' radius, 720p.
  sweep disc "$wall" 1280x720 '{name: alchemy, params: {blur: 0, radius: [0.06415, 0.7698]}}' 'time: false, cache: generic'
  row "shapes: generic, Alchemy, misses at 96 px over 8 px" "$(curve disc generic obscurance "$level" |
    awk '{ y[NR] = $2 } END { printf "%.1f", y[2] / y[1] }')" x ">=" 10

  sweep half "$wall" 1280x720 '{name: gtao, params: {blur: 0, depth_divisor: [1, 2]}, sweep: [{param: radius, from: 0.0625, to: 4, log2: 0.5}]}' \
    'time: false, cache: generic'
  for d in 1 2; do curve half generic horizon "$level" ".params.depth_divisor == $d" | knee; done >"$folder/knees"
  moved=$(paste -sd' ' "$folder/knees" | awk '{ printf "%.2f", $2 / $1 }')
  row "shapes: half-size depth moves gtao's knee by" "$moved" x ">=" 1.7
  row "shapes: half-size depth moves gtao's knee by" "$moved" x "<=" 2.3

  # Alchemy's figure 9 has time over the radius: straight to 1.5 m, then flat. A simulation gives no time: both levels are
  # printed beside it, and not judged.
  sweep radius '{name: atrium, view: nave}' 1280x720 \
    '{name: alchemy, params: {blur: 0}, sweep: [{param: radius, values: [0.25, 0.5, 0.75, 1, 1.25, 1.5, 2, 2.5, 3]}]}' 'time: false, cache: gtx580'
  for figure in '0 L1 misses .levels[0]' '1 memory bytes .levels[1]'; do
    read -r place name unit what <<<"$figure"
    for flight in one most; do
      curve radius gtx580 obscurance "$what.$flight.bytes_per_pixel" >"$folder/figure9"
      read -r r2 slope < <(line 0.25 1.5 <"$folder/figure9")
      read -r _ after < <(line 1.5 3 <"$folder/figure9")
      row "shapes: gtx580 over r, $name, $flight: R2 to 1.5 m" "$(printf %.3f "$r2")" ""
      row "shapes: gtx580 over r, $name, $flight: flatter after by" "$(awk -v a="$slope" -v b="$after" 'BEGIN { printf "%.1f", b ? a / b : 0 }')" x
    done
  done

  # The bar is 40 of the text's 28, 28, 40, 31, 22, which is three words for each sample and four for the pixel. Equation
  # 10 reads a position and no normal of a sample, two words: 27.5, near the 28.
  # Table 1 of the same text counts 32-bit words. Its buffers: a position of two words, a normal of one.
  sed -e 's/^title:.*/&\ndepth_bytes: {value: 8, confirmed: "a position of two words"}\nnormal_bytes: {value: 4, confirmed: "a normal of one word"}/' \
    configs/profiles/generic.yaml >"$folder/text.yaml"
  sweep words "$wall" 640x360 '{name: alchemy, params: {blur: 0}}' "time: false, cache: $folder/text.yaml"
  words=$(curve words text obscurance '(.bytes_asked + .bytes_written) / 4 / (.width * .height)' | awk '{ printf "%.1f", $2 }')
  row "shapes: Alchemy, words a pixel of 12 samples" "$words" words ">=" 39
  row "shapes: Alchemy, words a pixel of 12 samples" "$words" words "<=" 41

  # Does this machine's processor feel the misses of its own caches? Twelve radii, measured in turn, five times.
  radii='0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8, 1.2, 1.6, 2.4, 3.2'
  sweep own '{name: atrium, view: nave}' 1280x720 "{name: alchemy, params: {blur: 0, radius: [$radii]}}" 'time: false, cache: llvmpipe'
  for i in 1 2 3 4 5; do
    sweep "own-$i" '{name: atrium, view: nave}' 1280x720 "{name: alchemy, params: {blur: 0, radius: [$radii]}}" 'seconds: 1, precision: 1%'
  done
  curve own llvmpipe obscurance "$level" >"$folder/misses"
  for r in ${radii//,/}; do
    cat "$folder"/own-[1-5]/journal.jsonl | jq ".params.radius as \$r | select((\$r - $r) * (\$r - $r) < 1e-8) | .time.cpu_ms" | sort -g | sed -n 3p
  done | paste -d' ' <(cut -d' ' -f2 "$folder/misses") - >"$folder/both"
  ranks() { awk '{ print $'"$1"' , NR }' "$folder/both" | sort -g | awk '{ print $2, NR }' | sort -n | cut -d' ' -f2; }
  pearson() { line -1e9 1e9 | awk '{ r = sqrt($1); printf "%.2f", $2 < 0 ? -r : r }'; }
  row "shapes: llvmpipe, misses and time over 12 radii, Pearson" "$(pearson <"$folder/both")" "" ">=" 0.75
  row "shapes: the same, Spearman" "$(paste -d' ' <(ranks 1) <(ranks 2) | pearson)" ""

  # 4K x 64 samples fits in strips, and says before what it takes.
  start=$(date +%s.%N)
  build/release/aobudget cache --technique alchemy --scene plane --view top --size 3840x2160 -p samples=64 -p blur=0 --profile generic \
    --json "$folder/large.json" >/dev/null 2>"$folder/foretold"
  row "shapes: 4K x 64 samples, fetches a pixel" "$(jq '.cache.generic.frame | .fetches / (.width * .height) | floor' "$folder/large.json")" "" ">=" 64
  row "shapes: its time" "$(awk -v a="$start" -v b="$(date +%s.%N)" 'BEGIN { printf "%.0f", b - a }')" s
  row "shapes: foretold (from the trace on)" "$(sed -n 's/.*about \([0-9.e+]*\) s.*/\1/p' "$folder/foretold")" s
fi
