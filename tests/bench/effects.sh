# Sourced by bench.sh: the plan of effects beside the exhaustive measurement, at full size. The rules were made on the first eight views, and
# the last four were never looked at; then two sequences of 8 frames. AOBUDGET_BENCH_VIEWS chooses some of them, as
# "gallery/hall cornell/front passing_box/front/8".
plan_views="gallery/hall matte_white_room/room matte_dark_room/room coloured_walls/blue window_room/room open_sky/level rocks/low
  thicket/edge atrium/nave machine/front bunny/front cornell_box/front passing_box/front/8 passing_box/far/8"

# plan_config NAME SCENE VIEW HISTORY OPTIONS [TECHNIQUES]: sets of one view; of a sequence of $plan_frames, and where that is none, with a
# history as the last of so many frames.
plan_config() {
  local motion= frames=${plan_frames:-$4}
  [ "$frames" = 0 ] || motion=", motion: {frames: $frames}"
  cat <<EOF
name: $1
scenes: [{name: $2, view: $3$motion}]
resolutions: [${plan_size:-640x360}]
backends: [vulkan]
options: {lit: [on], visibility_rgb: [off, on], specular: [off, on], $5}
techniques:
  - {name: gtao, params: {history: $4}, sweep: [{param: divisor, values: [1, 2]}]}
${6:-}
measure: {images: false}
reference: {spp: 128}
EOF
}

# spent FILE COMMAND...: the command's exit code; FILE gets its processor and wall seconds.
spent() {
  local file=$1 code=0 TIMEFORMAT='%U %S %R'
  shift
  { time "$@" >"$file.log" 2>&1 || code=$?; } 2>"$file"
  awk '{ printf "%.1f %.1f\n", $1 + $2, $3 }' <(tail -1 "$file") >"$file.s" && mv "$file.s" "$file"
  return $code
}

# The 49 sets as "SET COST ERROR FLICKER", the noise of the truth taken out of the error; a picture has no flicker, so 0.
plan_sets() { # FOLDER...
  cat "${@/%//journal.jsonl}" | jq -r --arg sequence "${plan_frames:-}" 'select(.status == "ok") | .options as $o | .error as $e
    | [(if .technique == "none" then "nothing" else
        (["visibility"] + (if $o.visibility_rgb == "on" then ["multi_bounce"] else [] end)
         + (if $o.bent_normal == "on" then ["bent_normal"] else [] end) + (if $o.irradiance == "on" then ["directional"] else [] end)
         + (if $o.specular == "on" then ["specular"] else [] end) + (if .params.history == 16 then ["temporal"] else [] end) + (if .params.divisor == 2 then ["half_size"] else [] end)) | join("+") end),
       .time.ratio_to_ref, ([$e.lit_rmse * $e.lit_rmse - $e.lit_se * $e.lit_se, 0] | max | sqrt), (if $sequence == "" then 0 else .sequence.flicker end)] | @tsv'
}

# The cheapest within .02 of the least error and of the least flicker, as "SET COST LOSS ERROR LEAST".
plan_best() {
  awk 'NR == FNR { e = NR == 1 || $3 < e ? $3 : e; f = NR == 1 || $4 < f ? $4 : f; next }
    { loss = $3 - e > $4 - f ? $3 - e : $4 - f } loss <= .02 && (!set || $2 < cost) { set = $1; cost = $2; lost = loss; error = $3 }
    END { print set, cost, lost, error, e }' "$1" "$1"
}
# loss_of FILE SET
loss_of() {
  awk -v set="$2" 'NR == FNR { e = NR == 1 || $3 < e ? $3 : e; f = NR == 1 || $4 < f ? $4 : f; next }
    $1 == set { print ($3 - e > $4 - f ? $3 - e : $4 - f) }' "$1" "$1"
}

plan_view() { # SCENE VIEW [FRAMES]
  local at=$folder/plan-$1-$2${3:-} cache=$AOBUDGET_CACHE part plan_frames=${3:-}
  mkdir -p "$at"
  export AOBUDGET_CACHE=$at/cache
  spent "$at/plan-s" build/release/aobudget effects "$1" --view "$2" --size "${plan_size:-640x360}" ${3:+--frames "$3"} --json "$at/plan.json"
  export AOBUDGET_CACHE=$at/cache-all
  # The composite of a view takes bent normals or irradiance; `none` gives no effects, so its run ends with 3.
  plan_config bends "$1" "$2" 0 'bent_normal: [off, on]' '  - {name: none}' >"$at/bends.yaml"
  plan_config lights "$1" "$2" 0 'irradiance: [on]' >"$at/lights.yaml"
  plan_config mean-bends "$1" "$2" 16 'bent_normal: [off, on]' >"$at/mean-bends.yaml"
  plan_config mean-lights "$1" "$2" 16 'irradiance: [on]' >"$at/mean-lights.yaml"
  for part in bends lights mean-bends mean-lights; do
    spent "$at/$part-s" build/release/aobudget run "$at/$part.yaml" --out "$at/$part" --quiet || [ $? -eq 3 ]
  done
  export AOBUDGET_CACHE=$cache
  plan_sets "$at/bends" "$at/lights" "$at/mean-bends" "$at/mean-lights" >"$at/sets"
  read -r best best_cost _ best_error least < <(plan_best "$at/sets")
  set=$(jq -r '.chosen.effects | if length == 0 then "nothing" else join("+") end' "$at/plan.json")
  read -r _ cost error _ < <(grep "^$set	" "$at/sets")
  row "effects_plan: $1/$2: sets measured" "$(wc -l <"$at/sets")" "" ">=" 49
  printf '  plan: %s\n  best: %s\n' "$set" "$best"
  row "effects_plan: $1/$2: cost, plan / best" "$(awk -v a="$cost" -v b="$best_cost" 'BEGIN { printf "%.3f", a / b }')" ratio "<=" 1.05
  row "effects_plan: $1/$2: error, plan and best and least" "$(awk -v a="$error" -v b="$best_error" -v c="$least" 'BEGIN { printf "%.4f %.4f %.4f", a, b, c }')" ""
  row "effects_plan: $1/$2: plan's error or flicker above the least" "$(loss_of "$at/sets" "$set" | awk '{ printf "%.4f", $1 }')" "" "<=" 0.02
  row "effects_plan: $1/$2: error of a set, plan - exhaustive" "$(jq -r '.sets[] | [(.effects | if length == 0 then "nothing" else join("+") end), .rmse] | @tsv' "$at/plan.json" |
    awk 'NR == FNR { e[$1] = $3; next } { d = $2 - e[$1]; d = d < 0 ? -d : d; most = d > most ? d : most } END { printf "%.4f", most }' "$at/sets" -)" "at most" "<=" 0.005
  read -r plan_cpu plan_wall <"$at/plan-s"
  all=$(cat "$at/bends-s" "$at/lights-s" "$at/mean-bends-s" "$at/mean-lights-s" | awk '{ c += $1; w += $2 } END { print c, w }')
  row "effects_plan: $1/$2: its share, processor time" "$(awk -v p="$plan_cpu" -v a="${all% *}" 'BEGIN { printf "%.1f", 100 * p / a }')" "% of $(printf %.0f "${all% *}") s" "<=" 10
  row "effects_plan: $1/$2: its share, wall time" "$(awk -v p="$plan_wall" -v a="${all#* }" 'BEGIN { printf "%.1f", 100 * p / a }')" "% of $(printf %.0f "${all#* }") s" "<=" 10
}

if wanted effects_plan; then
  for view in ${AOBUDGET_BENCH_VIEWS:-$plan_views}; do
    # shellcheck disable=SC2086 # three words
    plan_view ${view//\// }
  done
fi
