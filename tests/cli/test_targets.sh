#!/usr/bin/env bash
# One question a chart: a case is scored against every target, whatever its own radius. Its error against a target is the
# RMSE of its image against that target's truth, computed here from the EXR files by another program.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
cat >two.yaml <<END
name: two
scenes: [{name: corner}]
resolutions: [96x54]
backends: [gl-egl]
target: [{radius: 1}, {radius: 0.5, weighting: uniform}]
techniques:
  - {name: gtao, params: {blur: 0}, sweep: [{param: radius, values: [0.25, 0.5, 1]}]}
  - name: none
measure: {time: false}
reference: {spp: 32}
END
check "two targets" "$program" run two.yaml --out two --quiet
value() { jq -r "select(.technique == \"gtao\" and .params.radius == $1) | $2" two/journal.jsonl; }
near() { check "$1: $2 is $3" awk "BEGIN { exit !(($2 - $3) ^ 2 <= 1e-12) }"; }
for radius in 0.25 0.5 1; do
  image=two/$(value $radius .image)
  for t in 0 1; do
    truth=two/$(value $radius ".errors[$t].truth")
    near "gtao of radius $radius against target $t" "$(value $radius ".errors[$t].rmse")" \
      "$("$AOBUDGET_BUILD/image_rmse" "$image" technique.AO "$truth" AO)"
  done
done
check "the targets are the config's, in its order" test "$(value 0.25 '[.errors[].target] | tojson')" = \
  '[{"radius":1,"weighting":"cosine"},{"radius":0.5,"weighting":"uniform"}]'
near "a radius that is no target is against the first" "$(value 0.25 .error.rmse)" "$(value 0.25 .errors[0].rmse)"
near "a radius that is one is against it" "$(value 0.5 .error.rmse)" "$(value 0.5 .errors[1].rmse)"
near "what has no radius is against the first" "$(jq 'select(.technique == "none").error.rmse' two/journal.jsonl)" \
  "$(jq 'select(.technique == "none").errors[0].rmse' two/journal.jsonl)"
# The image file's own reference is that of `error`.
image=two/$(value 0.5 .image)
near "the reference in the image" "$("$AOBUDGET_BUILD/image_rmse" "$image" technique.AO "$image" reference.AO)" \
  "$(value 0.5 .error.rmse)"
check "less radius asks for less: the question decides the error" awk \
  "BEGIN { exit !($(value 0.25 .errors[0].rmse) > 2 * $(value 1 .errors[0].rmse)) }"

# Without `target` every radius of the sweep is one, and a case's own is its error.
grep -v '^target' two.yaml >every.yaml
check "no target named" "$program" run every.yaml --out every --quiet
check "every radius is a target" test "$(jq -c '[.errors[].target.radius]' every/journal.jsonl | sort -u)" = '[0.25,0.5,1]'
check "each case's error is against its own radius" test \
  "$(jq -c 'select(.technique == "gtao") | [.params.radius, .error.target.radius]' every/journal.jsonl | jq -s 'map(select(.[0] != .[1])) | length')" = 0
near "the same question has the same answer" \
  "$(jq 'select(.technique == "gtao" and .params.radius == 0.25) | .errors[] | select(.target.radius == 1) | .rmse' every/journal.jsonl)" \
  "$(value 0.25 .errors[0].rmse)"

# Two cameras are two views by name, so that no chart joins them and a filter picks one.
sed 's/^scenes.*/scenes: [{name: corner, eye: [0, 2, 4], target: [0, 0.8, 0]}, {name: corner, eye: [1, 2, 4], target: [0, 0.8, 0]}]/' \
  two.yaml >cameras.yaml
check "two cameras" "$program" run cameras.yaml --out cameras --quiet --filter radius=0.5
check "have a name each" test "$(jq -r .view cameras/journal.jsonl | sort | tr '\n' ' ')" = "camera camera-2 "
check "and a section each" test "$(grep -c '<section id=s[0-9]' cameras/report/index.html)" -eq 2
check "one of them" "$program" run cameras.yaml --out second --quiet --filter "camera-2 gtao radius=0.5"
check "by its name" test "$(wc -l <second/journal.jsonl)" -eq 1

# A capture's truth is the screen-space bound's, and its errors are against it.
"$program" shot --technique none --scene spheres --size 96x54 --backend gl-egl --reference-spp 0 --out F.exr --quiet
cat >capture.yaml <<END
name: capture
scenes: [{capture: F.exr}]
backends: [gl-egl]
target: [{radius: 1}, {radius: inf, weighting: uniform}]
techniques: [{name: gtao, params: {radius: 0.5, blur: 0}}]
measure: {time: false}
reference: {spp: 32}
END
check "a capture" "$program" run capture.yaml --out capture --quiet
for t in 0 1; do
  near "the capture against target $t" "$(jq ".errors[$t].rmse" capture/journal.jsonl)" \
    "$("$AOBUDGET_BUILD/image_rmse" "capture/$(jq -r .image capture/journal.jsonl)" technique.AO \
      "capture/$(jq -r ".errors[$t].truth" capture/journal.jsonl)" AO)"
done

# A damaged file of the cache is never kept as a truth.
for file in "$AOBUDGET_CACHE"/visibility-*.exr; do head -c 200 "$file" >short && cp short "$file"; done
check "with a damaged cache" "$program" run two.yaml --out damaged --quiet --filter radius=1
check "nothing else is measured" diff <(jq '.errors' damaged/journal.jsonl) <(jq 'select(.params.radius == 1).errors' two/journal.jsonl)
near "the truth is whole" "$(jq -s '.[-1].errors[1].rmse' damaged/journal.jsonl)" \
  "$("$AOBUDGET_BUILD/image_rmse" "damaged/$(jq -rs '.[-1].image' damaged/journal.jsonl)" technique.AO \
    "damaged/$(jq -rs '.[-1].errors[1].truth' damaged/journal.jsonl)" AO)"
expect 2 "the radius 1e+39 is beyond the largest float" "$program" shot --technique none --scene plane --backend null --target-radius 1e39

# The old words are refused, with the new one named.
sed 's/^target.*//; s/spp: 32/spp: 32, radius: 1/' two.yaml >old.yaml
expect 2 "old.yaml:10:" "$program" plan old.yaml
expect 2 "target" "$program" plan old.yaml
expect 2 "is now --target-radius" "$program" shot --technique none --scene plane --backend null --reference-radius 1
check "a shot's targets" "$program" shot --technique gtao --scene corner --size 48x27 --backend gl-egl --reference-spp 16 \
  --target-radius 2,0.5 --target-weighting uniform --json shot.json
check "are those" test "$(jq -c '[.errors[].target]' shot.json)" = \
  '[{"radius":2,"weighting":"uniform"},{"radius":0.5,"weighting":"uniform"}]'
finish
