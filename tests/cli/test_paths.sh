#!/usr/bin/env bash
# Paths in a config are seen from the config's folder, those of the command line from the current one. So plan and keys do not
# depend on where a run is started, and it goes on from elsewhere.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
mkdir -p "set up/meshes" elsewhere/meshes
obj() { printf 'v 0 0 0\nv %s 0 0\nv 0 0 1\nf 1 3 2\n' "$1"; } # SIZE
obj 1 >"set up/meshes/one.obj"
obj 2 >"set up/two.obj"
obj 3 >elsewhere/meshes/one.obj # where a path from the current folder would lead: other meshes of the same names
obj 3 >elsewhere/two.obj
check "a frame" "$program" shot --technique none --scene corner --backend null --size 32x18 --reference-spp 0 --out "set up/frame.exr"
cat >"set up/config.yaml" <<END
name: paths
scenes: [{file: meshes/one.obj}, {file: $folder/set up/two.obj}, {file: ../set up/two.obj, eye: [0, 1, 4], target: [0, 0, 0]},
  {capture: frame.exr}, {name: "capture:./frame.exr", fov_deg: 60}]
resolutions: [32x18]
backends: ["null"]
techniques: [{name: none}]
measure: {time: false, images: false}
reference: {spp: 2}
END
plan() { "$program" plan "$@" --json - | jq -c '[.cases[] | {key, scene, view}]'; }
plan "set up/config.yaml" >from-above
(cd "set up" && plan config.yaml) >from-beside
(cd elsewhere && plan "../set up/config.yaml") >from-elsewhere
plan "$folder/set up/config.yaml" >by-root
check "five cases" jq -e 'length == 5' from-above
check "a scene is called as it is written" jq -e '.[0].scene == "meshes/one.obj" and .[3].scene == "capture:frame.exr"' from-above
for other in from-beside from-elsewhere by-root; do check "$other: the same plan" cmp from-above $other; done
check "a path of the root and one of the folder are one mesh: its views differ only" \
  test "$(jq -c '[.[1].view, .[2].view]' from-above)" = '["framed","camera"]'

# A link to a config stands for a config of its own place; a link to its folder leads to the same files.
sed '/^scenes/,/^ /c scenes: [{file: meshes/one.obj}]' "set up/config.yaml" >"set up/alone.yaml"
ln -s "../set up/alone.yaml" elsewhere/link.yaml
cp "set up/alone.yaml" elsewhere/copy.yaml
ln -s "set up" shortcut
for config in "set up/alone" elsewhere/link elsewhere/copy shortcut/alone; do
  plan "$config.yaml" >"plan-$(basename "$(dirname "$config")")-$(basename "$config")"
done
check "one case" jq -e 'length == 1' "plan-elsewhere-link"
check "a link's paths are seen from the link's folder" cmp plan-elsewhere-link plan-elsewhere-copy
check "which has another mesh" test "$(cat plan-elsewhere-link)" != "$(cat "plan-set up-alone")"
check "through a folder's link they are the folder's" cmp plan-shortcut-alone "plan-set up-alone"

code=0
"$program" run "set up/config.yaml" --out out --quiet --filter one.obj || code=$?
check "begun in one folder" test $code -eq 0
(cd elsewhere && "$program" run "../set up/config.yaml" --out ../out 2>../said) || code=$?
check "ended in another" test $code -eq 0
check "all cases are ok" grep -q "5 cases: 5 ok" said
check "each was measured once" test "$(wc -l <out/journal.jsonl)" -eq 5
check "the keys are those of the plan" cmp <(jq -r .key out/journal.jsonl | sort) <(jq -r '.[].key' from-above | sort)
sed 's/one.obj/gone.obj/' "set up/config.yaml" >"set up/gone.yaml"
expect 2 "set up/gone.yaml:2:10: set up/meshes/gone.obj: cannot open" "$program" plan "set up/gone.yaml"
expect 2 "meshes/one.obj: cannot open: No such file" "$program" shot --technique none --backend null --size 8x8 --scene meshes/one.obj
finish
