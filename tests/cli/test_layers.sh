#!/usr/bin/env bash
# Every layer of the EXR file of a frame, and every figure of its record, against closed forms by a reader of our own
# (tests/check_layers.c): names, signs, axes, rows, and a split of known parts. A technique draws a known image and claims
# a known share of the visibility; straight above the foot of a wall the depth buffer does not know the wall.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
module=$AOBUDGET_BUILD/tests/modules/known.so
layers=$AOBUDGET_BUILD/check_layers
shot=("$program" shot --module "$module" --technique known --scene corner --backend gl-egl --reference-spp 256 -p bent_normal=on)
names="N.X N.Y N.Z Z definition.AO error.AO error.bent reference.AO reference.SE reference.bent.X reference.bent.Y reference.bent.Z"
names+=" screen.AO technique.AO technique.bent.X technique.bent.Y technique.bent.Z"
holds() { # WHAT NAMES ARGUMENTS...
  local what=$1 expected=$2
  shift 2
  check "$what" "$layers" "$@"
  check "$what: the layers" test "$(tail -n 1 .stdout)" = "$expected"
}

check "a perspective view" "${shot[@]}" --eye 1,2,3 --target 0.25,0.5,0 --fov 60 --size 33x21 -p radius=1 -p claim=0.75 \
  --out slanted.exr --json slanted.json
holds "its layers" "$names" slanted.exr slanted.json 1,2,3 0.25,0.5,0 fov:60 1 0.75
check "from above" "${shot[@]}" --eye 0,2,0.35 --target 0,0,0.35 --ortho 0.6 --size 32x18 -p radius=0.5 -p claim=0.8 \
  --out above.exr --json above.json
holds "its layers and its split" "$names" above.exr above.json 0,2,0.35 0,0,0.35 ortho:0.6 0.5 0.8

# A camera that moves, in a run.
cat >moving.yaml <<END
name: moving
scenes:
  - {name: corner, eye: [1, 2, 3], target: [0.25, 0.5, 0], fov_deg: 60,
     previous: {eye: [1.25, 1.875, 3.125], target: [0, 0.625, 0]}}
resolutions: [32x18]
backends: [gl-egl]
options: {bent_normal: on}
techniques: [{name: known, params: {radius: 1, claim: 0.75}}]
measure: {time: false}
reference: {spp: 256}
END
check "a run" "$program" run moving.yaml --module "$module" --out moving --quiet
holds "its layers and velocities" "${names/ Z/ V.X V.Y V.Z Z}" "moving/$(jq -r .image moving/journal.jsonl)" \
  moving/journal.jsonl 1,2,3 0.25,0.5,0 fov:60 1 0.75 1.25,1.875,3.125 0,0.625,0

# Colours of a mesh's materials, and the sky beside it.
cat >floor.mtl <<END
newmtl paint
Kd 0.125 0.5 0.75
END
cat >floor.obj <<END
mtllib floor.mtl
v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
usemtl paint
f 1 4 3 2
END
check "a painted mesh" "$program" shot --technique none --scene floor.obj --eye 0,2,0 --target 0,0,0 --ortho 4 --size 16x16 \
  --backend gl-egl --reference-spp 2 --out paint.exr
cat >expected <<END
0 0 0 inf 0 0 0 0
0 0 1 2 0.125 0.5 0.75 0
END
check "sky and floor" diff expected <("$AOBUDGET_BUILD/print_layers" paint.exr N.X N.Y N.Z Z albedo.R albedo.G albedo.B error.AO)
finish
