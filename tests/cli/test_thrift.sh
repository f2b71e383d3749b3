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
config '{name: gtao, params: {radius: 0.5}}, {name: hbao}, {name: ray_march}, {name: alchemy}, {name: crytek_ssao}' 'thrift: [off, on]' >thrift.yaml
config '{name: gtao, params: {radius: 0.5}}' '' >plain.yaml
"$program" run thrift.yaml --out thrift --quiet >/dev/null
check "a run of four that leave something out, and one that does not" test $? -eq 3
check "a run without the option" "$program" run plain.yaml --out plain --quiet
# of TECHNIQUE THRIFT FILTER
of() { jq -s "map(select(.technique == \"$1\" and .options.thrift == \"$2\"))[0] | $3" thrift/journal.jsonl; }
check "off it is in no key" test "$(jq .key plain/journal.jsonl)" = "$(of gtao off .key)"
check "nor in a series" test "$(jq .series plain/journal.jsonl)" = "$(of gtao off .series)"
check "on it is in both" test "$(of gtao on '[.key, .series] | sort')" != "$(of gtao off '[.key, .series] | sort')"
check "its passes come first" test "$(of gtao on '[.time.passes[].name] | join(" ")')" = '"clearance_tiles clearance_groups clearance horizon blur_x1 blur_y1"'
check "off there are none, and nothing is said to be left out" test "$(of gtao off '[(.time.passes | length), has("left_out")]' | jq -c .)" = "[3,false]"
image() { echo "thrift/$(of "$1" "$2" .image | tr -d '"')"; }
for technique in gtao hbao ray_march alchemy; do
  check "$technique leaves most of a plain out" jq -e '.left_out > 0.5 and .left_out < 1' <(of $technique on .)
  check "$technique draws the same image" test "$("$AOBUDGET_BUILD/image_rmse" "$(image $technique on)" technique.AO "$(image $technique off)" technique.AO)" = 0
done
check "who leaves nothing out says so" test "$(of crytek_ssao on .reason)" = '"crytek_ssao leaves nothing out: leave the option thrift off for it"'
# Two textures of 20 x 12 x 16 bytes, two of 5 x 3 x 16, and one of 20 x 12.
check "its bytes" test $(($(of gtao on .memory_bytes) - $(of gtao off .memory_bytes))) = $((20 * 12 * 32 + 5 * 3 * 32 + 20 * 12))
finish
