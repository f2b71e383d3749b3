#!/usr/bin/env bash
# Default lengths are metres: one scene in metres and in another unit gives the same picture at the defaults of every
# technique. What is known of a unit, and what is told where nothing is.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache

box() { # X0 Y0 Z0 X1 Y1 Z1: a solid that faces outwards, in OBJ
  awk -v lo="$1 $2 $3" -v hi="$4 $5 $6" -v s="$scale" 'BEGIN {
    split(lo, a); split(hi, b)
    for (i = 0; i < 8; i++)
      printf "v %.9g %.9g %.9g\n", s * (i % 2 ? b[1] : a[1]), s * (int(i / 2) % 2 ? b[2] : a[2]), s * (i > 3 ? b[3] : a[3])
    print "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3" }'
}
mesh() { # UNITS-A-METRE FILE: two blocks on a slab before a wall
  scale=$1
  { box -2 -0.1 -2 2 0 2; box -2 0 -2 2 2 -1.5; box -0.7 0 -1.2 0 0.9 -0.4; box 0.3 0 -0.9 0.9 0.4 0.2; } >"$2"
}
mesh 1 metres.obj
mesh 1000 millimetres.obj
mesh 1024 binary.obj

config() { # NAME FILE SCALE KEYS
  cat >"$1.yaml" <<END
name: $1
scenes: [{file: $2, eye: [$(awk -v s="$3" 'BEGIN { print 1.5 * s ", " 1.4 * s ", " 2.6 * s }')], target: [0, $(awk -v s="$3" 'BEGIN { print 0.3 * s }'), 0], fov_deg: 50$4}]
resolutions: [160x90]
backends: [gl-egl]
techniques: [$("$program" list techniques --json - | jq -r '[.techniques[] | "{name: \(.name)}"] | join(", ")')]
measure: {time: false}
reference: {spp: 16}
END
  "$program" run "$1.yaml" --out "$1" --quiet 2>"$1.err"
}
ao() { echo "$1/$(jq -r "select(.technique == \"$2\") | .image" "$1/journal.jsonl")"; }
apart() { "$AOBUDGET_BUILD/image_rmse" "$(ao "$1" "$3")" technique.AO "$(ao "$2" "$3")" technique.AO; }
below() { awk -v v="$1" -v bar="$2" 'BEGIN { exit !(v + 0 <= bar) }'; }

check "metres" config metres metres.obj 1 ""
check "millimetres" config millimetres millimetres.obj 1000 ", metres_per_unit: 0.001"
check "2^-10 m" config binary binary.obj 1024 ", metres_per_unit: 0.0009765625"
check "millimetres, not stated" config unstated millimetres.obj 1000 ""
check "every technique is ok" test "$(jq -s 'map(select(.status == "ok")) | length' metres/journal.jsonl)" -eq \
  "$("$program" list techniques --json - | jq '.techniques | length')"
while read -r name; do
  check "$name is the same in millimetres, to 1e-3: $(apart metres millimetres "$name")" \
    below "$(apart metres millimetres "$name")" 1e-3
  check "$name is the same in units of 2^-10 m: $(apart metres binary "$name")" below "$(apart metres binary "$name")" 1e-6
  [ "$name" = none ] || check "$name draws something" \
    below 0.02 "$("$AOBUDGET_BUILD/image_rmse" "$(ao metres "$name")" technique.AO "$(ao metres none)" technique.AO)"
done < <(jq -r .technique metres/journal.jsonl)
check "a default length of half a metre" test "$(jq 'select(.technique == "gtao") | .params.radius' millimetres/journal.jsonl)" = 500
check "and its target" test "$(jq 'select(.technique == "gtao") | .reference_radius' millimetres/journal.jsonl)" = 500
check "told where it is odd" grep -q "millimetres.obj: its unit is taken as a metre, so it is 4e+03 m across" unstated.err
check "once" test "$(grep -c "taken as a metre" unstated.err)" -eq 1
check "not where it is stated" test ! -s millimetres.err
check "not where it is likely" test ! -s metres.err
check "a default is not told apart" grep -qx "gtao" <("$program" plan millimetres.yaml --json - | jq -r '.cases[].technique')
check "defaults have no words" test "$("$program" plan millimetres.yaml | grep -c radius=)" -eq 0

# Listed scenes: their units are known.
radius() { "$program" plan "$1.yaml" --json - | jq '.cases[0].params.radius'; }
for pair in engine:68.5 cornell_box:139 bunny:0.5 horse:0.31 corner:0.5; do
  printf 'name: x\nscenes: [{name: %s}]\nresolutions: [8x8]\nbackends: ["null"]\ntechniques: [{name: gtao}]\n' "${pair%:*}" >x.yaml
  check "$pair" below "$(awk -v a="$(radius x)" -v b="${pair#*:}" 'BEGIN { print (a > b ? a - b : b - a) / b }')" 1e-6
done
printf 'name: x\nscenes: [{name: engine, views: [front, fins]}, {name: corner}]\nresolutions: [8x8]\nbackends: ["null"]\ntechniques: [{name: gtao}, {name: hbao}]\ntarget: {radius: 0.5}\n' >x.yaml
"$program" plan x.yaml >/dev/null 2>x.err
check "a target of another unit than the radius is told" grep -q 'warning: engine: gtao looks 68.5 scene units far' x.err
check "once a scene" test "$(wc -l <x.err)" -eq 1
shot=("$program" shot --technique gtao --backend null --size 16x9 --reference-spp 0 --quiet)
check "by flag" "${shot[@]}" --scene millimetres.obj --metres-per-unit 0.001 --json s.json
check "it counts" test "$(jq .params.radius s.json)" = 500
check "a stated value is in scene units" "${shot[@]}" --scene millimetres.obj --metres-per-unit 0.001 -p radius=3 --json s.json
check "as it stands" test "$(jq .params.radius s.json)" = 3
expect 2 "scene 'corner' is listed, so its unit is known" "${shot[@]}" --scene corner --metres-per-unit 0.001
expect 2 "is not a number within 1e-06 .. 10000" "${shot[@]}" --scene metres.obj --metres-per-unit 0
finish
