# Sourced by bench.sh: what each technique's samples and sizes cost, and where its error comes from.
techniques() { build/release/aobudget list techniques --json - | jq -r "$1"; }

# entry NAME PARAMS SWEEP: of a config's techniques.
entry() { echo "  - {name: $1, params: {$2}, sweep: [$3]}"; }

# has NAME PARAM
has() { techniques ".techniques[] | select(.name == \"$1\") | .params[].name" | grep -qx "$2"; }

config() { # NAME SCENES SIZE MEASURE REFERENCE; techniques on standard input
  printf 'name: %s\nscenes: [%s]\nresolutions: [%s]\nbackends: [vulkan]\ntechniques:\n' "$1" "$2" "$3"
  cat
  printf 'measure: {images: false, %s}\nreference: {%s}\n' "$4" "$5"
}

# Points are cheap; a direction or slice is many taps.
counts() { [ "$1" = samples ] && echo "[16, 32, 64, 128]" || echo "[8, 16, 24, 32]"; }

if wanted linear; then
  while read -r name axis; do
    entry "$name" "$(has "$name" blur && echo 'blur: 0')" "{param: $axis, values: $(counts "$axis")}"
  done < <(techniques '.techniques[] | select(.sampling) | "\(.name) \(.sampling)"') |
    config linear '{name: atrium}' 320x180 'error: false, seconds: 2' 'spp: 2' >"$folder/linear.yaml"
  build/release/aobudget run "$folder/linear.yaml" --out "$folder/linear" --quiet
  while read -r name axis; do
    # R² of the straight line through (samples, cost in fixed passes)
    row "linear: $name by $axis $(counts "$axis" | tr -d '[] '), R2" "$(jq -r "select(.technique == \"$name\" and .status == \"ok\") |
      \"\\(.params.$axis) \\(.time.ratio_to_ref)\"" "$folder/linear/journal.jsonl" |
      awk '{ n++; x += $1; y += $2; xx += $1 * $1; yy += $2 * $2; xy += $1 * $2 }
           END { c = n * xy - x * y; print (n == 4) ? sprintf("%.4f", c * c / ((n * xx - x * x) * (n * yy - y * y))) : 0 }')" \
      "" ">=" 0.98
  done < <(techniques '.techniques[] | select(.sampling) | "\(.name) \(.sampling)"')
fi

if wanted divided; then
  for name in $(techniques '.techniques[].name'); do
    has "$name" divisor && entry "$name" "" "{param: divisor, values: [1, 2]}"
  done | config divided '{name: atrium}' 480x270 'seconds: 2' 'spp: 128' >"$folder/divided.yaml"
  build/release/aobudget run "$folder/divided.yaml" --out "$folder/divided" --quiet
  for name in $(techniques '.techniques[].name'); do
    has "$name" divisor || continue
    figure() { jq "select(.technique == \"$name\" and .params.divisor == $1) | $2" "$folder/divided/journal.jsonl"; }
    row "divided: $name half / full, cost" "$(awk -v a="$(figure 2 .time.ratio_to_ref)" -v b="$(figure 1 .time.ratio_to_ref)" 'BEGIN { printf "%.3f", a / b }')" ratio
    row "divided: $name RMSE full, half" "$(figure 1 .error.rmse) $(figure 2 .error.rmse)" ""
  done
fi

# SCENE-NAME SCENE RADIUS: shares of the mean squared error, and gtao's estimator error by samples.
split_scene() {
  {
    for name in $(techniques '.techniques[] | select(.params[].name == "radius") | .name'); do
      [ "$name" = gtao ] || entry "$name" "radius: $3" ""
    done
    echo "  - {name: gtao, params: {radius: $3, slices: 3, steps: 6}}"
    echo "  - {name: gtao, params: {radius: $3, slices: 9, steps: 24}}"
  } | sed 's/, sweep: \[\]//' | config split "$2" 480x270 'time: false' 'spp: 256' >"$folder/split.yaml"
  sed -i 's/^measure/options: {guard_band: 64}\nmeasure/' "$folder/split.yaml"
  build/release/aobudget run "$folder/split.yaml" --out "$folder/split-$1" --quiet || [ $? -eq 3 ]
  jq -r 'select(.status != "ok") | "split: '"$1"', \(.technique): \(.status): \(.reason)"' "$folder/split-$1/journal.jsonl"
  jq -r 'select(.status == "ok") | "\(.technique)\(if .params.slices then " \(.params.slices)x\(.params.steps)" else "" end):
    \(.error.rmse) \(.error.definition_rmse) \(.error.missing_rmse) \(.error.estimator_rmse)"' "$folder/split-$1/journal.jsonl" |
    paste - - | while read -r line; do
    name=${line%%:*}
    read -r rmse definition missing estimator <<<"${line#*:}"
    row "split: $1, $name: definition missing estimator" "$(awk -v r="$rmse" -v d="$definition" -v m="$missing" -v e="$estimator" \
      'BEGIN { printf "%.2f %.2f %.2f", (d / r) ^ 2, (m / r) ^ 2, (e / r) ^ 2 }')" "of MSE"
  done
  estimator() { jq "select(.technique == \"gtao\" and .params.slices == $1) | .error.estimator_rmse" "$folder/split-$2/journal.jsonl"; }
  row "split: $1, gtao estimator error 9x24 / 3x6" \
    "$(awk -v a="$(estimator 9 "$1")" -v b="$(estimator 3 "$1")" 'BEGIN { printf "%.3f", a / b }')" ratio "<=" 0.999
}

if wanted split; then
  split_scene atrium '{name: atrium}' 0.5
  hall=$(find "${AOBUDGET_SCENES:-none}" -name "sponza-crytek.*" 2>/dev/null | head -1 || true)
  if [ -n "$hall" ]; then # in centimetres
    split_scene hall '{name: sponza-crytek, eye: [-1100, 220, -40], target: [800, 400, -40], fov_deg: 70}' 100
  else
    echo "split: no sponza-crytek in AOBUDGET_SCENES: the hall is skipped"
  fi
fi

# What a bent normal costs beside the visibility, and what filtering both at once saves.
if wanted bent; then
  { entry gtao 'slices: 9, steps: 12' '{param: blur, values: [0, 5]}'; entry hbao '' ''; entry ray_march '' ''; } | sed 's/, sweep: \[\]//' |
    config bent '{name: atrium}' 480x270 'error: false, seconds: 4' 'spp: 2' >"$folder/bent.yaml"
  sed -i 's/^measure/options: {bent_normal: [off, on]}\nmeasure/' "$folder/bent.yaml"
  build/release/aobudget run "$folder/bent.yaml" --out "$folder/bent" --quiet
  of() { jq "select(.technique == \"$1\" and .options.bent_normal == \"$2\" and (.params.blur // 0) == $3) | $4" "$folder/bent/journal.jsonl"; }
  quotient() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.3f", a / b }'; }
  for case in "gtao 0" "gtao 5" "hbao 9" "ray_march 0"; do
    read -r name blur <<<"$case"
    row "bent: $name blur $blur, with / without" "$(quotient "$(of "$name" on "$blur" .time.ratio_to_ref)" "$(of "$name" off "$blur" .time.ratio_to_ref)")" ratio
  done
  blurs='[.time.passes[] | select(.name | test("blur")) | .ratio_to_ref] | add'
  both=$(of gtao on 5 "$blurs") alone=$(of gtao off 5 "$blurs")
  row "bent: gtao, one filter of both / two filters" "$(quotient "$both" "$(awk -v a="$both" -v b="$alone" 'BEGIN { print a + b }')")" ratio "<=" 1
  row "bent: gtao, one filter of both / the visibility's" "$(quotient "$both" "$alone")" ratio
fi

# What each output made of visibility and bent normal costs beside the visibility, and how it stands beside what it is compared
# with: in the rooms with light and polish, at gtao's 9x12.
if wanted effects; then
  entry gtao 'slices: 9, steps: 12' '' | sed 's/, sweep: \[\]//' |
    config effects '{name: gallery}' 480x270 'error: false, seconds: 4' 'spp: 2' >"$folder/effects.yaml"
  sed -i 's/^measure/options: {bent_normal: [off, on], visibility_rgb: [off, on], specular: [off, on], irradiance: [off, on]}\nmeasure/' "$folder/effects.yaml"
  build/release/aobudget run "$folder/effects.yaml" --out "$folder/effects" --quiet
  cost() { jq ".options as \$o | select([\$o.bent_normal, \$o.visibility_rgb, \$o.specular, \$o.irradiance] == $1) | .time.ratio_to_ref" "$folder/effects/journal.jsonl"; }
  plain=$(cost '["off","off","off","off"]') bent=$(cost '["on","off","off","off"]')
  quotient() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.3f", a / b }'; }
  row "effects: gtao 9x12, bounces / visibility" "$(quotient "$(cost '["off","on","off","off"]')" "$plain")" ratio
  row "effects: gtao 9x12, specular / bent normals" "$(quotient "$(cost '["on","off","on","off"]')" "$bent")" ratio
  row "effects: gtao 9x12, irradiance / bent normals" "$(quotient "$(cost '["on","off","off","on"]')" "$bent")" ratio
  row "effects: gtao 9x12, all / visibility" "$(quotient "$(cost '["on","on","on","on"]')" "$plain")" ratio
  # SCENE VIEW RADIUS OPTION FIELD WAY_PARAM WAY
  figure() {
    build/release/aobudget shot --technique gtao --scene "$1" --view "$2" --size 320x180 -p radius="$3" -p slices=9 -p steps=12 \
      -p "$4=on" -p "$6=$7" --json - 2>/dev/null | jq ".error.$5"
  }
  for view in hall ball; do
    row "effects: gallery $view, specular / visibility as specular" \
      "$(quotient "$(figure gallery $view 0.5 specular specular_band specular_by cap)" "$(figure gallery $view 0.5 specular specular_plain specular_by cap)")" ratio "<=" 0.5
  done
  for radius in 0.25 0.5 1; do
    here=$(figure window_room room $radius irradiance irradiance_band irradiance_by moments)
    for way in zonal bent_normal visibility triple_product; do
      row "effects: window_room R=$radius, irradiance / by $way" \
        "$(quotient "$here" "$(figure window_room room $radius irradiance irradiance_band irradiance_by $way)")" ratio "<=" 0.999
    done
  done
fi

# What each effect adds to the lit image and what it costs there: its own passes and the composite's difference.
if wanted lit; then
  { echo '  - name: none'; entry gtao 'radius: 0.5, slices: 9, steps: 12' ''; } | sed 's/, sweep: \[\]//' |
    config lit '{name: gallery}, {name: window_room}' 480x270 'seconds: 4' 'spp: 128' >"$folder/lit.yaml"
  sed -i 's/^measure/options: {lit: [off, on], visibility_rgb: [off, on], specular: [off, on], irradiance: [off, on]}\nmeasure/; s/^reference/target: {radius: 0.5}\nreference/' "$folder/lit.yaml"
  build/release/aobudget run "$folder/lit.yaml" --out "$folder/lit" --quiet || [ $? -eq 3 ] # `none` gives no effects
  quotient() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.3f", a / b }'; }
  # SCENE TECHNIQUE LIT BOUNCES SPECULAR IRRADIANCE FIELD
  of() {
    jq ".options as \$o | select(.scene == \"$1\" and .technique == \"$2\" and .status == \"ok\" and
      [\$o.lit, \$o.visibility_rgb, \$o.specular, \$o.irradiance] == [\"$3\", \"$4\", \"$5\", \"$6\"]) | $7" "$folder/lit/journal.jsonl"
  }
  composite='.time.passes[] | select(.name == "lit_composite") | .ratio_to_ref'
  row "lit: gtao 9x12, visibility with the composite / without" \
    "$(quotient "$(of gallery gtao on off off off .time.ratio_to_ref)" "$(of gallery gtao off off off off .time.ratio_to_ref)")" ratio
  row "lit: gtao 9x12, composite of all outputs / of visibility" \
    "$(quotient "$(of gallery gtao on on on on "$composite")" "$(of gallery gtao on off off off "$composite")")" ratio
  for set in "on off off" "off on off" "off off on" "on off on" "on on on"; do
    read -r bounces specular irradiance <<<"$set"
    price=$(quotient "$(of gallery gtao on "$bounces" "$specular" "$irradiance" .time.ratio_to_ref)" "$(of gallery gtao on off off off .time.ratio_to_ref)")
    row "lit: gtao 9x12, bounces $bounces, specular $specular, irradiance $irradiance / visibility" "$price" ratio
  done
  for scene in gallery window_room; do
    row "lit: $scene, error of none, gtao, gtao with bounces and irradiance" "$(of $scene none on off off off .error.lit_band) \
$(of $scene gtao on off off off .error.lit_band) $(of $scene gtao on on off on .error.lit_band)" ""
    row "lit: $scene, gtao with bounces and irradiance / with visibility" \
      "$(quotient "$(of $scene gtao on on off on .error.lit_band)" "$(of $scene gtao on off off off .error.lit_band)")" ratio "<=" 0.999
  done
fi

# What thrift leaves out, beside what an oracle would that knows the image without thrift: tiles of 8 x 8 whose surfaces are all within
# 1/255 of open (tests/open_tiles.c). And the cost with thrift over that without. The last three look at all that lies in front.
if wanted thrift; then
  { entry gtao 'slices: 3, steps: 8' '{param: radius, values: [0.5, 1]}'
    for name in volumetric_obscurance starcraft2_ssao; do entry $name '' '{param: radius, values: [0.5]}'; done
    entry crytek_ssao 'hemisphere: on' '{param: radius, values: [0.5]}'; } |
    config thrift '{name: scattered_rocks, views: [down, low]}, {name: atrium, views: [nave, aisle]}, {name: thicket, view: edge}, {name: gallery, view: hall}' \
      640x360 'error: false, seconds: 6' 'spp: 2' >"$folder/thrift.yaml"
  sed -i 's/^measure: {images: false, /options: {thrift: [off, on]}\nmeasure: {/' "$folder/thrift.yaml"
  build/release/aobudget run "$folder/thrift.yaml" --out "$folder/thrift" --quiet
  # TECHNIQUE SCENE VIEW RADIUS THRIFT FIELD
  of() { jq -r "select(.technique == \"$1\" and .scene == \"$2\" and .view == \"$3\" and .params.radius == $4 and .options.thrift == \"$5\") | $6" "$folder/thrift/journal.jsonl"; }
  quotient() { awk -v a="$1" -v b="$2" 'BEGIN { if (b > 0) printf "%.3f", a / b; else printf "-" }'; }
  while read -r name scene view radius least; do
    head="thrift: $name $scene $view R=$radius"
    left=$(of $name $scene $view $radius on .left_out)
    oracle=$(build/release/open_tiles "$folder/thrift/$(of $name $scene $view $radius off .image)" technique.AO)
    row "$head, left out" "$left" share ${least:+">=" "$least"}
    row "$head, oracle" "$oracle" share
    row "$head, left out / oracle" "$(quotient "$left" "$oracle")" ratio
    cost=$(quotient "$(of $name $scene $view $radius on .time.ratio_to_ref)" "$(of $name $scene $view $radius off .time.ratio_to_ref)")
    if [ "$name $scene" = "gtao thicket" ]; then
      row "$head, with / without" "$cost" ratio "<=" 1.03
    else
      row "$head, with / without" "$cost" ratio
    fi
  done <<'ROWS'
gtao scattered_rocks down 0.5 0.6
gtao scattered_rocks down 1 0.6
gtao scattered_rocks low 0.5
gtao scattered_rocks low 1
gtao atrium nave 0.5 0.15
gtao atrium nave 1
gtao atrium aisle 0.5 0.15
gtao atrium aisle 1
gtao gallery hall 0.5
gtao gallery hall 1
gtao thicket edge 0.5
gtao thicket edge 1
volumetric_obscurance scattered_rocks down 0.5
volumetric_obscurance scattered_rocks low 0.5
volumetric_obscurance atrium nave 0.5
volumetric_obscurance atrium aisle 0.5
volumetric_obscurance thicket edge 0.5
volumetric_obscurance gallery hall 0.5
starcraft2_ssao scattered_rocks down 0.5
starcraft2_ssao scattered_rocks low 0.5
starcraft2_ssao atrium nave 0.5
starcraft2_ssao atrium aisle 0.5
starcraft2_ssao thicket edge 0.5
starcraft2_ssao gallery hall 0.5
crytek_ssao scattered_rocks down 0.5
crytek_ssao scattered_rocks low 0.5
crytek_ssao atrium nave 0.5
crytek_ssao atrium aisle 0.5
crytek_ssao thicket edge 0.5
crytek_ssao gallery hall 0.5
ROWS
fi

# What the mean over time costs, and how much less it flickers; and whether Alchemy at full size flickers less than HBAO at half size, as
# the text says (McGuire et al. 2011, of its figure 11).
if wanted temporal; then
  { entry gtao '' '{param: history, values: [0, 16]}'; entry alchemy '' ''; entry hbao 'divisor: 2' ''; } | sed 's/, sweep: \[\]//; s/, params: {}//' |
    config temporal '{name: passing_box, view: front, motion: {frames: 16}}, {name: atrium, view: nave, motion: {frames: 16, eye: [0.6, 1.7, 17.75], target: [-0.2, 2.6, -20]}}' \
      640x360 'seconds: 4' 'spp: 128' >"$folder/temporal.yaml"
  build/release/aobudget run "$folder/temporal.yaml" --out "$folder/temporal" --quiet
  quotient() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.3f", a / b }'; }
  # SCENE TECHNIQUE HISTORY FIELD
  of() { jq "select(.scene == \"$1\" and .technique == \"$2\" and (.params.history // 0) == $3) | $4" "$folder/temporal/journal.jsonl"; }
  for scene in passing_box atrium; do
    row "temporal: $scene, cost with / without" "$(quotient "$(of $scene gtao 16 .time.ratio_to_ref)" "$(of $scene gtao 0 .time.ratio_to_ref)")" ratio
    row "temporal: $scene, flicker with / without" "$(quotient "$(of $scene gtao 16 .sequence.flicker)" "$(of $scene gtao 0 .sequence.flicker)")" ratio
    row "temporal: $scene, mean error with / without" "$(quotient "$(of $scene gtao 16 .sequence.error_mean)" "$(of $scene gtao 0 .sequence.error_mean)")" ratio
    row "temporal: $scene, flicker of alchemy / of hbao at half size" "$(quotient "$(of $scene alchemy 0 .sequence.flicker)" "$(of $scene hbao 0 .sequence.flicker)")" ratio "<=" 1
  done
fi
