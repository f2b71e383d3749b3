#!/usr/bin/env bash
# Bounces, specular occlusion and irradiance: who asks for one gets it drawn and scored against its own truth, who does not pays
# nothing; what lights a scene; and what cannot be had is said.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
config() { # OPTIONS SCENE
  cat <<YAML
name: effects
scenes: [{name: ${2:-coloured_walls}}]
resolutions: [64x36]
backends: [gl-egl]
options: {$1}
techniques: [{name: gtao, params: {radius: 0.5}}]
measure: {seconds: 0.02}
reference: {spp: 32}
YAML
}
config "" >plain.yaml
config "visibility_rgb: [off, on], specular: [off, on], irradiance: [off, on]" >all.yaml
check "a run without" "$program" run plain.yaml --out plain --quiet
check "a run of all eight" "$program" run all.yaml --out all --quiet
# of RGB SPECULAR IRRADIANCE FILTER
of() { jq -s "map(select(.options | .visibility_rgb == \"$1\" and .specular == \"$2\" and .irradiance == \"$3\"))[0] | $4" all/journal.jsonl; }
passes() { jq -r 'select(.technique == "gtao") | .time.passes[].name' <<<"$1" | tr '\n' ' '; }
check "what is off is in no key" test "$(jq .key plain/journal.jsonl)" = "$(of off off off .key)"
check "nor in a series" test "$(jq .series plain/journal.jsonl)" = "$(of off off off .series)"
check "each is another case" test "$(jq -r .key all/journal.jsonl | sort -u | wc -l)" -eq 8
names() { of "$1" "$2" "$3" '[.time.passes[].name] | join(" ")'; }
check "none: the passes of visibility alone" test "$(names off off off)" = '"horizon blur_x1 blur_y1"'
check "bounces: one pass more" test "$(names on off off)" = '"horizon blur_x1 blur_y1 bounces"'
check "specular: one pass, over bent normals" test "$(names off on off)" = '"horizon bent_blur_x1 bent_blur_y1 specular"'
check "irradiance likewise" test "$(names off off on)" = '"horizon bent_blur_x1 bent_blur_y1 irradiance"'
check "all of them" test "$(names on on on)" = '"horizon bent_blur_x1 bent_blur_y1 bounces irradiance specular"'
# Texels of r16f have 2 bytes, of rgba16f 8; three textures of visibility, then bent normals, 64 x 36 each. The table of lobes has
# 104 x 36 x 16 texels of 2 bytes.
bytes() { echo $((64 * 36 * $1 + ${2:-0})); }
check "no byte for what is off" test "$(of off off off .memory_bytes)" = "$(bytes 6)"
check "bounces: a texture" test "$(of on off off .memory_bytes)" = "$(bytes 14)"
check "irradiance: bent normals and a texture" test "$(of off off on .memory_bytes)" = "$(bytes 32)"
check "specular: a table too" test "$(of off on off .memory_bytes)" = "$(bytes 26 $((104 * 36 * 16 * 2)))"
check "outputs" test "$(of on off on '.outputs | join(" ")')" = '"visibility visibility_rgb irradiance"'
image() { echo "all/$(of "$1" "$2" "$3" .image | tr -d '"')"; }
same() { test "$("$AOBUDGET_BUILD/image_rmse" "$1" "$3" "$2" "$3")" = 0; }
for on in "on off off" "off on off" "off off on" "on on on"; do
  check "$on: the same visibility to the bit" same "$(image $on)" "$(image off off off)" technique.AO
done
check "a bounce is the same beside others" same "$(image on on on)" "$(image on off off)" technique.visibility_rgb.G
check "so is specular" same "$(image on on on)" "$(image off on off)" technique.specular
check "and irradiance" same "$(image on on on)" "$(image off off on)" technique.irradiance.B
check "bounces gain between white walls" jq -e '.error | .bounce_band < 0.65 * .bounce_plain and .bounce_model < 0.35 * .bounce_plain and .bounce_se < 0.02' \
  <("$program" shot --technique gtao --scene matte_white_room --size 64x36 --backend gl-egl --reference-spp 64 -p radius=0.5 -p visibility_rgb=on --json -)
check "uniform light gains nothing from directions" test "$(of off off on '.error | (.irradiance_band - .irradiance_plain | fabs) < 1e-3')" = true
check "no figure of what is off" test "$(of off off off '.error | [has("bounce_rmse"), has("specular_rmse"), has("irradiance_rmse")] | any')" = false

# The truth by the light: its own, a listed one, a probe. Only what depends on the light has it in its key.
shot=("$program" shot --technique gtao --scene window_room --size 64x36 --backend gl-egl --reference-spp 32 -p radius=0.5)
key() { "${shot[@]}" "$@" --json - 2>key.err | jq -r .key; }
own=$(key -p irradiance=on)
check "its own light, by name" test "$(key -p irradiance=on --light window)" = "$own"
check "the record names it" test "$("${shot[@]}" -p irradiance=on --json - | jq -r .light.name) $("${shot[@]}" --json - | jq -r .light)" = "window null"
check "another light is another case" test "$(key -p irradiance=on --light sky)" != "$own"
check "not of visibility" test "$(key --light sky)" = "$(key)"
check "nor of specular" test "$(key -p specular=on --light sky)" = "$(key -p specular=on)"
check "directions gain in the room with the window" jq -e '.error | .irradiance_band < 0.95 * .irradiance_plain and .irradiance_se < 0.1' <("${shot[@]}" -p irradiance=on --json -)
check "a cap gains over visibility as specular" jq -e '.error | .specular_band < 0.75 * .specular_plain and .specular_se < 0.1' \
  <("$program" shot --technique gtao --scene gallery --size 96x54 --backend gl-egl --reference-spp 64 -p radius=0.5 -p specular=on --json -)
probe_key() { "${shot[@]}" -p irradiance=on --light changed.exr --json - 2>key.err | jq -r .key; }

config "irradiance: [on]" >lights.yaml
sed -i 's/{name: coloured_walls}/{name: corner, light: sky}, {name: corner, light: window}, {name: corner, light: .\/white.exr}/' lights.yaml
"$AOBUDGET_BUILD/probe_file" white.exr 8 1
check "three lights" "$program" run lights.yaml --out lights --quiet 2>/dev/null
lights() { grep -o "light=[a-z./]*" "$1" | LC_ALL=C sort -u | tr '\n' ' '; }
"$program" plan lights.yaml >told 2>/dev/null
check "the plan tells them apart" test "$(lights told)" = "light=./white.exr light=sky light=window "
check "so does the page" test "$(lights lights/report/index.html)" = "light=./white.exr light=sky light=window "

# Probes: 8 x 4 texels of 1 are uniform light.
probe() { "$AOBUDGET_BUILD/probe_file" "$@"; }
probe white.exr 8 1
probe bad.exr 8 nan
probe dark.exr 8 -1
probe changed.exr 8 1
first=$(probe_key)
probe changed.exr 8 3
check "a probe that changed is another case" test "$(probe_key)" != "$first"
probe sun.exr 8 1e9
expect 2 "sun.exr: no light probe: its mean radiance is" "${shot[@]}" -p irradiance=on --light sun.exr
# A parameter of an output that is not wanted makes no case.
config "irradiance: [off]" >ways.yaml
sed -i 's/params: {radius: 0.5}/params: {radius: 0.5}, sweep: [{param: irradiance_by, values: [moments, zonal]}]/' ways.yaml
check "one case of two ways to what is off" test "$("$program" plan ways.yaml --json - | jq '.cases | length')" = 1
sed -i 's/irradiance: .off./irradiance: [on]/' ways.yaml
check "two where it is on" test "$("$program" plan ways.yaml --json - | jq '.cases | length')" = 2
sky=("$program" shot --technique gtao --scene corner --size 32x18 --backend gl-egl --reference-spp 16 -p irradiance=on)
check "a probe lights" "${sky[@]}" --light white.exr --out lit.exr
check "and one in another folder" "${sky[@]}" --light ./white.exr
expect_note() { grep -q "white.exr: nine coefficients hold 100 % of the light's energy" note; }
"${sky[@]}" --light white.exr >/dev/null 2>note
check "what it loses is noted" expect_note
expect 2 "bad.exr: no light probe: R is nan at column 2, row 0" "${sky[@]}" --light bad.exr
expect 2 "dark.exr: no light probe: R is -1 at column 2, row 0" "${sky[@]}" --light dark.exr
expect 2 "none.exr" "${sky[@]}" --light none.exr
expect 2 "unknown light 'moon'; there are uniform, sky, window, and probes: FILE.exr" "${sky[@]}" --light moon
config "irradiance: [on]" >lit.yaml
sed -i 's/{name: coloured_walls}/{name: corner, light: bad.exr}/' lit.yaml
expect 2 "lit.yaml:2:10: " "$program" run lit.yaml --out lit --quiet

# Who gives none says so; a capture has only the materials of its file; an odd material is noted.
expect 2 "unsupported: hbao gives no visibility_rgb: leave the option visibility_rgb off for it" "$program" shot --technique hbao --scene corner --size 32x18 --backend gl-egl -p visibility_rgb=on
for output in visibility_rgb specular irradiance; do
  expect 2 "unsupported: gtao gives no $output" "$program" shot --technique gtao --scene corner --size 32x18 --backend gl-egl -p weighting=uniform -p $output=on
done
expect 2 "specular needs the roughness of the surfaces" "$program" shot --technique gtao --scene capture:lit.exr --fov 60 --backend gl-egl -p specular=on
printf 'mtllib odd.mtl\nv -1 0 -1\nv 1 0 -1\nv 0 0 1\nusemtl odd\nf 1 3 2\n' >odd.obj
printf 'newmtl odd\nKd 3 0.5 0\nPr -1\n' >odd.mtl
"$program" shot --technique gtao --scene odd.obj --eye 0,2,3 --target 0,0,0 --size 32x18 --backend gl-egl -p visibility_rgb=on --reference-spp 16 >/dev/null 2>odd.err
check "a material out of bounds is noted" grep -q "odd.obj: a material's base colour, roughness or metalness is not within 0..1" odd.err
finish
