#!/usr/bin/env bash
# `nightly`, from the first night to an alarm. Two modules are on the null backend, where a pass takes the same time each time
# it runs, so that costs are known to the last digit; those whose images matter are on Vulkan, in a config that times nothing.
source "$(dirname "$0")/lib.sh"
modules=$AOBUDGET_BUILD/tests/modules
cd "$folder"
mkdir modules
install_old() {
  cp "$modules/passes10.so" modules/slow.so
  cp "$modules/passes10.so" modules/same.so
  printf same >>modules/same.so # another build that does the same
  cp "$modules/loop16.so" modules/moved.so
  cp "$modules/loop100.so" modules/still.so
}
cat >costs.yaml <<'EOC'
name: costs
scenes: [{name: corner, views: [front, far]}]
resolutions: [96x54]
backends: ["null"]
techniques:
  - {name: passes, module: modules/slow.so}
  - {name: passes, module: modules/same.so}
measure: {seconds: 0.2}
target: {radius: 1}
reference: {spp: 32}
EOC
cat >images.yaml <<'EOC'
name: images
scenes: [{name: corner, views: [front]}]
resolutions: [96x54]
backends: [vulkan]
techniques:
  - {name: loop, module: modules/moved.so}
  - {name: loop, module: modules/still.so}
measure: {time: false}
target: {radius: 1}
reference: {spp: 32}
EOC
# night NAME WANTED CONFIG ARGUMENTS...: the exit code, and nothing of a crash; the document is NAME.json.
night() {
  local name=$1 wanted=$2 config=$3 got=0
  shift 3
  "$program" nightly "$config" --history nights.db --json "$name.json" "$@" >"$name.out" 2>"$name.err" || got=$?
  if [ "$got" -ne "$wanted" ] || grep -q Sanitizer "$name.err"; then
    echo "FAILED: night $name: expected code $wanted and got $got"
    sed 's/^/  | /' "$name.out" "$name.err"
    failures=$((failures + 1))
  fi
}
lines_of() { sqlite3 nights.db "$1"; }

# --- Costs
install_old
night costs1 0 costs.yaml
check "the first night has first cases only" jq -e '.first == 4 and .worse == 0 and .suspects == 0 and .watched == 0' costs1.json
night costs2 0 costs.yaml
check "the second has nothing to tell" jq -e '.line == "nothing changed" and .watched == 4 and .suspects == 0 and .cases == []' costs2.json
cp "$modules/passes11.so" modules/slow.so
night costs3 1 costs.yaml --markdown costs3.md
check "a module that is 10 % slower is named, beside its old build, to the digit" jq -e '.worse == 2 and .suspects == 2 and
  ([.cases[] | select(.verdict == "slower" and .outcome == "worse" and (.case | test("^corner/(front|far) .*passes")))
    | .beside, .low, .high, .after / .before | . > 1.0999 and . < 1.1001] | length == 8 and all)' costs3.json
check "and the one that is not is not" jq -e '[.cases[].case] | length == 2 and all(test("same.so") | not)' costs3.json
check "the sentence names the share and the night" jq -e --arg date "$(jq -r .date costs3.json | cut -c1-10)" \
  'all(.cases[]; .said | startswith("10.0 % dearer since \($date); beside the old build "))' costs3.json
check "the screen names it" grep -q 'slow.so' costs3.out
check "the Markdown names it" grep -q 'slow.so' costs3.md
check "the night has a page and a trend" test -s "$(jq -r .folder costs3.json)/index.html" -a -s results/nightly/costs/trend/index.html
night costs4 0 costs.yaml
check "the alarm is given once" jq -e '.suspects == 0' costs4.json
cp "$modules/passes10.so" modules/slow.so
night costs5 0 costs.yaml
check "what is cheaper again is told, and is no regression" jq -e '.worse == 0 and ([.cases[] | .verdict == "faster" and .beside < 0.9092 and .beside > 0.909] | length == 2 and all)' costs5.json

# --- Images
night images1 0 images.yaml
night images2 0 images.yaml
cp "$modules/loop_moved.so" modules/moved.so
cp "$modules/loop_again.so" modules/still.so
night images3 1 images.yaml
check "an image that changes is named with its map, and its error is larger" jq -e '.suspects == 1 and .worse == 1 and (.cases | length) == 1
  and (.cases[0] | .verdict == "moved" and .outcome == "worse" and (.said | test("^the image changed; RMSE .*worse")) and (.map | test("^beside/1/maps/")))' images3.json
map=$(jq -r '.folder + "/" + .cases[0].map' images3.json)
check "the map is an image, a picture and a file for ParaView" test -s "$map.exr" -a -s "$map.png" -a -s "$map.vti"
check "the page shows it" grep -qF "$(jq -r '.cases[0].map' images3.json).png" "$(jq -r .folder images3.json)/index.html"
night images4 0 images.yaml
check "the next night has nothing to tell" jq -e '.line == "nothing changed"' images4.json

# --- A case that does not run any more
cp "$AOBUDGET_BUILD/tests/modules/crash_exit.so" modules/crash.so
cat >broken.yaml <<'EOC'
name: broken
scenes: [{name: corner}]
resolutions: [64x36]
backends: [vulkan]
techniques: [{name: loop, module: modules/moved.so}]
measure: {time: false}
reference: {spp: 32}
EOC
night broken1 0 broken.yaml
finish
