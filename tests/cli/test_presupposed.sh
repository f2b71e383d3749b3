#!/usr/bin/env bash
# Techniques that draw triangles presuppose closed solids that face outwards, each face once: a mesh that is not so gets
# one warning, and one that is gets none.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache

# box X0 Y0 Z0 X1 Y1 Z1: twelve triangles that face outwards.
corners=0
box() {
  local x y z face
  for x in "$1" "$4"; do for y in "$2" "$5"; do for z in "$3" "$6"; do echo "v $x $y $z"; done; done; done
  for face in "1 2 4" "1 4 3" "5 7 8" "5 8 6" "1 5 6" "1 6 2" "3 4 8" "3 8 7" "1 3 7" "1 7 5" "2 6 8" "2 8 4"; do
    set -- $face
    echo "f $(($1 + corners)) $(($2 + corners)) $(($3 + corners))"
  done
  corners=$((corners + 8))
}
{ box -6 -0.5 -6 6 0 6; box 0 0 0 1 1 1; box -1.5 0 0.3 -0.3 0.5 1.1; } >right.obj
{ cat right.obj; grep '^f' right.obj | head -24; } >doubled.obj
awk '$1 == "f" { print "f", $2, $4, $3; next } { print }' right.obj >inverted.obj
awk '$1 == "f" && ++n > 12 && n <= 24 { print "f", $2, $4, $3; next } { print }' right.obj >inverted_one.obj
{ cat right.obj; echo "v -2 0.6 -1"; echo "v 2 0.6 -1"; echo "v 2 0.6 2"; echo "v -2 0.6 2"; echo "f -1 -2 -3 -4"; } >sheet.obj

shot() { # TECHNIQUE FILE
  "$program" shot --technique "$1" --scene "$2" --eye 2.2,2,3.2 --target .2,.4,.2 --fov 50 --size 96x54 \
    --backend null --reference-spp 0 -p radius=0.8 >/dev/null
}
for file in right.obj corner atrium; do
  shot ao_volumes "$file" 2>err
  check "$file has no warning" test ! -s err
done
expect 0 "warning: doubled.obj/camera: 24 of its 60 triangles repeat another one;" shot ao_volumes doubled.obj
for file in inverted inverted_one sheet; do
  expect 0 "of the directions from what is seen meet backs of triangles" shot ao_volumes "$file.obj"
  shot gtao "$file.obj" 2>err
  check "no warning of a technique that reads the depth" test ! -s err
done

cat >config.yaml <<EOF2
name: run
scenes: [{file: doubled.obj, eye: [2.2, 2, 3.2], target: [0.2, 0.4, 0.2], fov_deg: 50}]
resolutions: [96x54, 48x27]
backends: ["null"]
techniques: [{name: ao_volumes, params: {radius: [0.4, 0.8]}}]
measure: {error: false, images: false, seconds: 0.05}
EOF2
expect 0 "24 of its 60 triangles" "$program" run config.yaml --out run --quiet
finish
