# Sourced by bench.sh: what a fit leaves of the error in band, on six views of three scenes that it is fitted to and on three scenes that it
# has not seen, of the techniques whose texts leave a strength open; and how long four parameters take; on a machine that others measure on, the
# wall time holds the waiting for them, which the processor time does not. The scenes were chosen before any
# was fitted. AOBUDGET_BENCH_TECHNIQUES chooses some of the techniques.
tune_config() { # NAME TIME
  cat >"$folder/$1.yaml" <<EOC
name: $1
scenes:
  - {name: atrium, views: [column, gallery]}
  - {name: cornell, views: [front, blocks]}
  - {name: machine, views: [train, pipes]}
resolutions: [480x270]
backends: [vulkan]
options: {guard_band: 64}
techniques: [{name: none}]
target: {radius: 0.5}
measure: {time: $2, seconds: 0.5}
reference: {spp: 64}
EOC
}

if wanted tune; then
  tune_config tune_time true
  spent "$folder/tune_time" build/release/aobudget tune alchemy --config "$folder/tune_time.yaml" --params radius,intensity,contrast,bias --quiet
  read -r cpu wall <"$folder/tune_time"
  row "tune: four parameters, six views, cold cache" "$wall" s "<=" 180
  row "tune: of these, processor time" "$cpu" s
  tune_config tune false
  for technique in ${AOBUDGET_BENCH_TECHNIQUES:-alchemy crytek_ssao starcraft2_ssao volumetric_obscurance}; do
    build/release/aobudget tune "$technique" --config "$folder/tune.yaml" --held-out spheres/front,bunny/front,matte_white_room/room \
      --json "$folder/tune.json" --quiet
    left() { jq -r --arg of "$1" --arg side "$2" '.settings[0][$of][$side] | . * 1000 | round / 1000' "$folder/tune.json"; }
    row "tune: $technique, fitted views: error before" "$(left training default)" ""
    row "tune: $technique, fitted views: share left" "$(left training share)" ""
    row "tune: $technique, held out: error before" "$(left held_out default)" ""
    row "tune: $technique, held out: share left" "$(left held_out share)" "" "<=" 0.6
  done
fi
