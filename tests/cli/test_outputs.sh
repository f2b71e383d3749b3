#!/usr/bin/env bash
# Outputs beside visibility: who asks for a bent normal gets it scored, stored and drawn; who does not pays nothing for it, and
# keeps his keys.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
config() { # OPTIONS
  cat <<YAML
name: outputs
scenes: [{name: corner}]
resolutions: [64x36]
backends: [gl-egl]
options: {guard_band: 8$1}
techniques: [{name: gtao, params: {radius: 1}}, {name: hbao, params: {radius: 1}}, {name: ray_march, params: {radius: 1}},
  {name: crytek_ssao}]
measure: {seconds: 0.02}
reference: {spp: 64}
YAML
}
config "" >plain.yaml
config ", bent_normal: [off, on]" >both.yaml
check "a run without" "$program" run plain.yaml --out plain --quiet
code=0
"$program" run both.yaml --out both --quiet 2>both.err || code=$?
check "a case is unsupported: code $code" test "$code" -eq 3
one() { jq -s "map(select(.technique == \"$1\" and .options.bent_normal == \"$2\"))[0] | $3" both/journal.jsonl; }
check "who has none says so" test "$(one crytek_ssao on .reason)" = '"crytek_ssao gives no bent_normal: leave the option bent_normal off for it"'
check "and is unsupported" test "$(one crytek_ssao on .status)" = '"unsupported"'
check "without the option it is drawn" test "$(one crytek_ssao off .status)" = '"ok"'
check "what is off is in no key" diff <(jq -r .key plain/journal.jsonl | sort) <(jq -r 'select(.options.bent_normal == "off") | .key' both/journal.jsonl | sort)
check "nor in a series" diff <(jq -r .series plain/journal.jsonl | sort) <(jq -r 'select(.options.bent_normal == "off") | .series' both/journal.jsonl | sort)
check "what is on is another case" test "$(jq -r .key both/journal.jsonl | sort -u | wc -l)" -eq 8

for technique in gtao hbao ray_march; do
  check "$technique: outputs" test "$(one $technique on '.outputs | join(" ")') $(one $technique off '.outputs | join(" ")')" = '"visibility bent_normal" "visibility"'
  # A texel of r16f has two bytes, one of rgba16f eight; every target is of one size. The table of hbao has 256 bytes.
  table=$([ $technique = hbao ] && echo 256 || echo 0)
  check "$technique: four times the bytes with it, none of them without" \
    test "$(($(one $technique on .memory_bytes) - table))" = "$((4 * ($(one $technique off .memory_bytes) - table)))"
  check "$technique: the same visibility" test "$("$AOBUDGET_BUILD/image_rmse" "both/$(one $technique on .image | tr -d '"')" technique.AO "both/$(one $technique off .image | tr -d '"')" technique.AO)" = 0
  check "$technique: it is scored" jq -es "map(select(.technique == \"$technique\" and .options.bent_normal == \"on\"))[0].error |
    .bent_band < 0.6 * .bent_band_normal and .bent_band_pixels > 300 and .bent_mean < .bent_band" both/journal.jsonl
  check "$technique: without it nothing is" test "$(one $technique off '.error | has("bent_mean")')" = false
  check "$technique: as many passes" test "$(one $technique on '.time.passes | length')" = "$(one $technique off '.time.passes | length')"
done
check "the page has a picture of each" test "$(grep -o 'figures/[^"]*-bent.png' both/report/index.html | sort -u | wc -l)" -eq 3
for picture in both/report/figures/*-bent.png; do check "$picture is drawn" test -s "$picture"; done
check "none of them without" test "$(grep -c -- '-bent.png' plain/report/index.html)" -eq 0

# Bounces, specular occlusion and irradiance: pictures, a map, and what was laid for them.
sed -e 's/^name: .*/name: light/' -e 's/{name: corner}/{name: gallery}/' -e 's/, {name: hbao.*/]/' -e '/^  {name: crytek/d' \
  -e 's/guard_band: 8/guard_band: 8, specular: [off, on], visibility_rgb: on, irradiance: on/' plain.yaml >light.yaml
check "a run with three more" "$program" run light.yaml --out light --quiet
lit() { jq -s "map(select(.options.specular == \"$1\"))[0] | $2" light/journal.jsonl; }
page=light/report/index.html
for output in bounces specular irradiance; do
  for end in .png -map.png; do
    picture=$(grep -o "figures/[^\"]*-$output$end" $page | sort -u)
    check "one picture of $output$end: '$picture'" test -s "light/report/$picture"
  done
done
for which in off on; do
  gives=$(lit $which '.outputs | join(", ")' | tr -d '"')
  check "specular $which: what it gives, and in how many passes" \
    grep -q "gives $gives in $(lit $which '.time.passes | length') passes: " $page
done
check "specular has a pass of its own" test "$(lit on '.time.passes | length')" -eq $(($(lit off '.time.passes | length') + 1))
check "its pass is on the page" grep -q '^<li>specular: [0-9.]* ms</li>$' $page
for word in '<button>outputs</button>' 'RMSE after bounces in band' 'relative RMSE of specular in band' 'relative RMSE of irradiance in band'; do
  check "a column: $word" grep -q "$word" $page
  check "not without: $word" test "$(grep -c "$word" plain/report/index.html)" -eq 0
done

# In one frame.
expect 2 "unsupported: alchemy gives no bent_normal" "$program" shot --technique alchemy --scene corner --size 32x18 --backend gl-egl -p bent_normal=on
expect 2 "bent_normal" "$program" shot --technique gtao --scene corner --size 32x18 --backend gl-egl -p bent_normal=maybe
"$program" shot --technique gtao --scene corner --size 32x18 --backend gl-egl -p bent_normal=on --reference-spp 16 >shot.txt
check "a shot's line has the angle" grep -q "bent normal in band [0-9.]* degrees" shot.txt
finish
