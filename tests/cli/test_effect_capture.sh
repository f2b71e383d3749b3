#!/usr/bin/env bash
# effects of a capture: what its materials and the light tell, beside frames that are drawn one by one; and what its file does not say.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
row() { jq -c ".effects[] | select(.name == \"$2\") | $3" "$1.json"; }
by() { test "$(row "$1" "$2" .by)" = "\"$3\""; }
expect_code() { # CODE WHAT COMMAND...
  local code=$1 what=$2 got=0
  shift 2
  "$@" >out 2>err </dev/null || got=$?
  check "$what: code $code" test "$got" = "$code"
}
shot=("$program" shot --backend gl-egl --size 64x36 --reference-spp 0)
"${shot[@]}" --technique none --scene gallery --view ball --out frame.exr >/dev/null
capture=("$program" effects capture:frame.exr --backend gl-egl --light sky --radius 0.5)
expect_code 0 "all materials are there" "${capture[@]}" --tolerance 0.01 --json full.json --out full.yaml
check "a capture has no frames before it" test "$(jq -c '.effects[] | select(.name == "temporal") | [.by, .called]' full.json)" = '["no data",false]'
check "the head line says against what" grep -q '^capture:frame.exr/capture, 64x36, gl-egl, light sky, radius 0.5: the lit image in its own materials, against its own of full size with visibility + multi_bounce + directional + specular, which no truth has judged$' out
check "so does the document" test "$(jq -c '[.reference, .reference_effects, .materials, .spp]' full.json)" = '["own",["visibility","multi_bounce","directional","specular"],true,0]'
check "every set is looked at" test "$(jq '.sets | length' full.json)" = 25
check "all but half size together is what it is compared with" test "$(jq -c '.least | [.rmse == 0, .effects]' full.json)" = '[true,["visibility","multi_bounce","directional","specular"]]'
for effect in visibility multi_bounce bent_normal directional specular half_size; do check "$effect is measured" by full $effect measured; done
check "an effect is called for if the image without it differs by more" jq -e \
  'all(.effects[]; .name == "half_size" or (.called | not) or .otherwise.rmse > .chosen.rmse) and .chosen.rmse <= 0.01 and .chosen.within' full.json

# Each difference beside that of the images which the device composes, and the light of the full one.
draw() { # FILE.exr FLAGS...
  "$program" shot --backend gl-egl --scene capture:frame.exr --light sky --reference-spp 0 -p lit=on "${@:2}" --out "$1" >/dev/null
}
draw whole.exr --technique gtao -p radius=0.5 -p visibility_rgb=on -p irradiance=on -p specular=on
off() { # FILE.exr: its difference from whole.exr, relative to that
  local c square=0 light=0 one
  for c in R G B; do
    one=$("$AOBUDGET_BUILD/image_rmse" "$1" "technique.lit.$c" whole.exr "technique.lit.$c")
    square=$(awk "BEGIN { print $square + $one * $one }")
    light=$(awk "BEGIN { print $light + $("$AOBUDGET_BUILD/image_moments" whole.exr "technique.lit.$c" | cut -d' ' -f2) }")
  done
  awk "BEGIN { print sqrt($square / $light) }"
}
is_off() { # SET FLAGS...
  draw one.exr "${@:2}"
  local told drawn
  told=$(jq --arg set "$1" '.sets[] | select((.effects | join("+")) == $set) | .rmse' full.json)
  drawn=$(off one.exr)
  check "$1 differs by $told, drawn by $drawn" awk "BEGIN { exit !(($told - $drawn)^2 < 3e-4^2 && $drawn > 0.005) }"
}
gtao=(--technique gtao -p radius=0.5)
is_off "" --technique none
is_off visibility "${gtao[@]}"
is_off visibility+multi_bounce+bent_normal "${gtao[@]}" -p visibility_rgb=on -p bent_normal=on
is_off visibility+multi_bounce+directional+specular+half_size "${gtao[@]}" -p visibility_rgb=on -p irradiance=on -p specular=on -p divisor=2
check "its config runs" "$program" run full.yaml --out full --quiet
options='.options as $o | [["multi_bounce","visibility_rgb"],["bent_normal","bent_normal"],["directional","irradiance"],["specular","specular"]] | map(select($o[.[1]] == "on") | .[0])'
check "with the lit image of the set taken" test "$(jq -c "[.options.lit, ($options)]" full/journal.jsonl)" = \
  "$(jq -c '["on", .chosen.effects - ["visibility", "half_size"]]' full.json)"

# Rules, from the materials of the file.
"${shot[@]}" --technique none --scene matte_dark_room --out dark.exr >/dev/null
"${shot[@]}" --technique none --scene matte_white_room --out white.exr >/dev/null
expect_code 0 "a dark room" "$program" effects capture:dark.exr --backend gl-egl --json dark.json
expect_code 0 "a white room" "$program" effects capture:white.exr --backend gl-egl --json white.json
check "between dark walls nothing bounces" by dark multi_bounce rule
check "between white ones it does" test "$(row white multi_bounce '[.by, .most > 0.05]')" = '["measured",true]'
check "matt walls mirror nothing" by white specular rule
check "even light has no direction" by white directional rule

# Without a channel what depends on it is not known: names of the same length hide it.
hide() { LC_ALL=C sed "s/$1/$2/g" "$3" >"$4"; }
hide albedo albeda frame.exr rough.exr
hide roughness roughnesz frame.exr colour.exr
expect_code 3 "no base colour" "$program" effects capture:rough.exr --backend gl-egl --light sky --json rough.json --page page
check "bounces are not known" by rough multi_bounce "no data"
check "specular is" test "$(row rough specular .by)" != '"no data"'
check "it is compared in one base colour" grep -q 'the lit image in its roughness and one base colour, against' out
check "the page says against what" grep -q '<dt>compared</dt><dd>the lit image in its roughness and one base colour, against its own of full size with visibility' page/index.html
check "and of no rays" test "$(grep -c 'rays a pixel' page/index.html)" = 0
check "nothing on it is off" test "$(grep -c '<th>off by\|, off by' page/index.html)" = 0
expect_code 3 "no roughness" "$program" effects capture:colour.exr --backend gl-egl --light sky --json colour.json --out colour.yaml
check "specular is not known" test "$(row colour specular '[.by, .sentence]')" = '["no data","not known: the file has no roughness, and how wide a surface mirrors depends on it"]'
check "bounces are" test "$(row colour multi_bounce .by)" = '"measured"'
check "its config runs without a lit image" "$program" run colour.yaml --out colour --quiet
check "as such" jq -e '.options.lit == "off"' colour/journal.jsonl
expect_code 3 "no material is read" "${capture[@]}" --materials none --json none.json --out none.yaml
check "as it says" grep -q 'the lit image in one white material, against its own of full size with visibility + directional, which' out
check "both are not known" test "$(row none multi_bounce .by)$(row none specular .by)" = '"no data""no data"'
check "light needs no material" by none directional measured
check "the config reads none either" grep -q 'materials: none' none.yaml

# A warning comes once, though the file is read for every measurement.
hide metalness metalnesz frame.exr plastic.exr
"$program" effects capture:plastic.exr --backend gl-egl --light sky --quiet >/dev/null 2>err
check "what is missing is told once" test "$(grep -c 'it has no metalness' err) $(wc -l <err)" = "1 1"
finish
