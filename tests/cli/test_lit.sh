#!/usr/bin/env bash
# The lit image: who asks for it gets one pass more, a truth of its own and its scores; each effect takes the place of what stands
# in for it, at its price; and what cannot be had is said.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
config() { # OPTIONS
  cat <<YAML
name: lit
scenes: [{name: coloured_walls}]
resolutions: [64x36]
backends: [gl-egl]
options: {$1}
techniques: [{name: gtao, params: {radius: 0.5}}, {name: hbao, params: {radius: 0.5}}, {name: none}]
measure: {seconds: 0.02}
target: {radius: 0.5}
reference: {spp: 64}
YAML
}
config "lit: [off, on], visibility_rgb: [off]" >plain.yaml
check "a run of three techniques" "$program" run plain.yaml --out plain --quiet
# of TECHNIQUE LIT FILTER
of() { jq -s "map(select(.technique == \"$1\" and .options.lit == \"$2\"))[0] | $3" plain/journal.jsonl; }
names='[.time.passes[].name] | join(" ")'
check "off: the passes of visibility" test "$(of gtao off "$names")" = '"horizon blur_x1 blur_y1"'
check "on: the composite behind them" test "$(of gtao on "$names")" = '"horizon blur_x1 blur_y1 lit_composite"'
check "on: behind another's" jq -e '.time.passes[-1].name == "lit_composite"' <(of hbao on .)
# A target of 8 bytes a pixel and a table of 32 x 96 x 8 bytes.
check "its bytes" test $(($(of gtao on .memory_bytes) - $(of gtao off .memory_bytes))) = $((64 * 36 * 8 + 32 * 96 * 8))
check "every technique gives it" test "$(of none on '.outputs | join(" ")')" = '"visibility lit"'
check "it is lit: the record names the light" test "$(of gtao on .light.name) $(of gtao off .light)" = '"uniform" null'
check "it is another case" test "$(of gtao on .key)" != "$(of gtao off .key)"
image() { echo "plain/$(of "$1" "$2" .image | tr -d '"')"; }
same() { test "$("$AOBUDGET_BUILD/image_rmse" "$1" "$3" "$2" "$3")" = 0; }
check "the same visibility to the bit" same "$(image gtao on)" "$(image gtao off)" technique.AO
check "no figure of what is off" test "$(of gtao off '.error | has("lit_rmse")')" = false
check "all compare with one truth" same "$(image gtao on)" "$(image hbao on)" reference.lit.G
check "occlusion brings the image nearer to the truth" test "$(jq -n "$(of gtao on .error.lit_band) < $(of none on .error.lit_band)")" = true
check "what is seen gains too" test "$(jq -n "$(of gtao on .error.lit_flip) < $(of none on .error.lit_flip)")" = true
check "the truth is sharp enough to say so" test "$(of gtao on '.error | .lit_se < 0.1 * .lit_band')" = true

# Between coloured walls bounces are what is missing.
shot=("$program" shot --technique gtao --scene coloured_walls --size 64x36 --backend gl-egl --reference-spp 64 -p radius=0.5)
lit() { "${shot[@]}" "$@" --json - 2>lit.err | jq "$figure"; }
figure=.error.lit_band
check "bounces bring it nearer" test "$(jq -n "$(lit -p lit=on -p visibility_rgb=on) < 0.9 * $(lit -p lit=on)")" = true
figure=.key
check "with bounces it is another case" test "$(lit -p lit=on -p visibility_rgb=on)" != "$(lit -p lit=on)"
check "another light is another case" test "$(lit -p lit=on --light sky)" != "$(lit -p lit=on)"
check "beside the lit image the same visibility after bounces" "${shot[@]}" -p lit=on -p visibility_rgb=on --out both.exr
check "as without it" "${shot[@]}" -p visibility_rgb=on --out one.exr
check "to the bit" same both.exr one.exr technique.visibility_rgb.R

"$program" shot --technique gtao --scene corner --size 32x18 --backend gl-egl --reference-spp 0 --out corner.exr >/dev/null
expect 2 "lit needs the base colour of the surfaces, and the file has no channels albedo.R" "$program" shot --technique gtao --scene capture:corner.exr --fov 60 --backend gl-egl -p lit=on
finish
