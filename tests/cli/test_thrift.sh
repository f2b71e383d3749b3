#!/usr/bin/env bash
# Thrift: who asks for it has passes that find what nothing can occlude, the share that was left out in the record, and the same image.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
config() { # TECHNIQUES OPTIONS
  cat <<YAML
name: thrift
scenes: [{name: scattered_rocks, view: down}]
resolutions: [160x90]
backends: [gl-egl]
options: {$2}
techniques: [$1]
measure: {seconds: 0.02, error: false}
YAML
}
config '{name: gtao, params: {radius: 0.5}}, {name: hbao}, {name: ray_march}, {name: alchemy},
  {name: volumetric_obscurance}, {name: starcraft2_ssao}, {name: crytek_ssao, params: {hemisphere: on}}' 'thrift: [off, on]' >thrift.yaml
config '{name: crytek_ssao}, {name: ao_volumes}, {name: none}, {name: starcraft2_ssao, params: {epsilon: 0}}' 'thrift: on' >none.yaml
config '{name: gtao, params: {radius: 0.5}}' '' >plain.yaml
check "a run of seven that leave something out" "$program" run thrift.yaml --out thrift --quiet
"$program" run none.yaml --out none --quiet >/dev/null 2>&1
check "a run of those that leave nothing out" test $? -eq 2
check "a run without the option" "$program" run plain.yaml --out plain --quiet
# of TECHNIQUE THRIFT FILTER
of() { jq -s "map(select(.technique == \"$1\" and .options.thrift == \"$2\"))[0] | $3" thrift/journal.jsonl; }
check "off it is in no key" test "$(jq .key plain/journal.jsonl)" = "$(of gtao off .key)"
check "nor in a series" test "$(jq .series plain/journal.jsonl)" = "$(of gtao off .series)"
check "on it is in both" test "$(of gtao on '[.key, .series] | sort')" != "$(of gtao off '[.key, .series] | sort')"
check "its passes come first" test "$(of gtao on '[.time.passes[].name] | join(" ")')" = '"clearance_tiles clearance_groups clearance horizon blur_x1 blur_y1"'
check "off there are none, and nothing is said to be left out" test "$(of gtao off '[(.time.passes | length), has("left_out")]' | jq -c .)" = "[3,false]"
image() { echo "thrift/$(of "$1" "$2" .image | tr -d '"')"; }
while read -r technique least most; do
  check "$technique leaves much of a plain out" jq -e ".left_out > $least and .left_out < 1" <(of $technique on .)
  rmse=$("$AOBUDGET_BUILD/image_rmse" "$(image $technique on)" technique.AO "$(image $technique off)" technique.AO)
  check "$technique draws the same image, to the last bit of a half float" awk "BEGIN { exit !($rmse <= $most) }"
done <<'TECHNIQUES'
gtao 0.5 0
hbao 0.5 0
ray_march 0.5 0
alchemy 0.5 0
volumetric_obscurance 0.2 0.0005
starcraft2_ssao 0.5 0
crytek_ssao 0.1 0
TECHNIQUES
# says TECHNIQUE REASON
says() { check "$1 says that it leaves nothing out" test "$(jq -r "select(.technique == \"$1\") | .reason" none/journal.jsonl)" = "$1 leaves nothing out$2: leave the option thrift off for it"; }
says crytek_ssao ", because an open plane has no one value without hemisphere = on"
says ao_volumes ", because triangles darken what they are near to, and no depth image shows them all"
says none ""
says starcraft2_ssao ", because the rounding of depths darkens open planes where epsilon is below a millionth of the radius"
# Two textures of 20 x 12 x 16 bytes, two of 5 x 3 x 16, and one of 20 x 12.
check "its bytes" test $(($(of gtao on .memory_bytes) - $(of gtao off .memory_bytes))) = $((20 * 12 * 32 + 5 * 3 * 32 + 20 * 12))
finish
