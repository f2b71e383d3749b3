#!/usr/bin/env bash
# `compare`: two builds of a module and two runs, with verdicts that do not depend on the machine. On the null backend a
# pass takes the same time each time it runs, so costs are known to the last digit. On Vulkan times are real; there a
# difference counts from 25 %, and what is compared is either the same code, which is not off by as much in five
# processes, or twice the work.
source "$(dirname "$0")/lib.sh"
modules=$AOBUDGET_BUILD/tests/modules
cd "$folder"
config() { # NAME BACKEND TECHNIQUE
  cat >"$1.yaml" <<EOC
name: $1
scenes: [{name: corner, views: [front, far]}]
resolutions: [96x54]
backends: ["$2"]
techniques: [{name: $3}]
measure: {seconds: 0.3}
target: {radius: 1}
reference: {spp: 32}
EOC
}
# code WANTED COMMAND...: the exit code, and nothing of a crash
code() {
  local wanted=$1 got=0
  shift
  "$@" >.out 2>.err || got=$?
  if [ "$got" -ne "$wanted" ] || grep -q Sanitizer .err; then
    echo "FAILED: $*: expected code $wanted and got $got"
    sed 's/^/  | /' .out .err
    failures=$((failures + 1))
  fi
}

# --- Builds, by a clock that is exact
config null null passes
code 1 "$program" compare "$modules/passes10.so" "$modules/passes11.so" --config null.yaml --out slower --json slower.json
check "a module that is 10 % slower is SLOWER, to the digit" jq -e '(.cases | length) == 2 and all(.cases[];
  .verdict == "SLOWER" and .paired and .processes >= 5 and .outcome == "worse"
  and ([.interval.ratio, .interval.low, .interval.high] | all(. > 1.0999999 and . < 1.1000001)))' slower.json
check "the table says so" grep -q '^SLOWER *1.100 \[1.100, 1.100\] .* corner/far passes null 96x54: ' .out
check "and counts" grep -q '^2 cases: 2 SLOWER; without a partner: 0 of A, 0 of B$' .out
code 0 "$program" compare "$modules/passes11.so" "$modules/passes10.so" --config null.yaml --out faster --json faster.json
check "and the other way FASTER" jq -e 'all(.cases[]; .verdict == "FASTER")' faster.json
code 0 "$program" compare "$modules/passes11.so" "$modules/passes10.so" --config null.yaml --precision 12% --out same --json same.json
check "or SAME, where a difference counts from 12 %" jq -e '.precision == 0.12 and all(.cases[]; .verdict == "SAME")' same.json
cp "$modules/passes10.so" copy.so
code 0 "$program" compare "$modules/passes10.so" copy.so --out copy --json copy.json
check "a copy is the same" jq -e '.identical' copy.json

# --- Builds, by a real clock
config real vulkan loop
sed -i 's/, far\]/]/' real.yaml
code 1 "$program" compare "$modules/loop100.so" "$modules/loop200.so" --config real.yaml --precision 25% --seconds 2 \
  --out double --json double.json
check "twice the work is SLOWER" jq -e 'all(.cases[]; .verdict == "SLOWER" and .interval.ratio > 1.25)' double.json
"$program" compare "$modules/loop100.so" "$modules/loop_again.so" --config real.yaml --precision 25% --seconds 2 \
  --out again --json again.json --quiet || [ $? -eq 3 ]
check "the same code is SAME or AMBIGUOUS" jq -e 'all(.cases[]; .verdict == "SAME" or .verdict == "AMBIGUOUS")' again.json
mkdir -p moved/maps && touch moved/maps/{0007-old-front-loop,2024-site,mine}.png moved/mine.png
printf 'maps/0007-old-front-loop\nmine\nmaps/../mine\n' >moved/maps/files.txt
code 1 "$program" compare "$modules/loop16.so" "$modules/loop_moved.so" --config real.yaml --precision 25% --seconds 1 \
  --out moved --json moved.json
check "another image is MOVED, by what it was darkened" jq -e 'all(.cases[]; .verdict == "MOVED" and .image.moved
  and .image.max > 0.0499 and .image.max < 0.0501 and .image.share == 1 and .error != "unknown")' moved.json
check "with its map" test -s "moved/$(jq -r '.cases[0].image.map' moved.json).png"
check "and none of an earlier comparison, but a user's own" test "$(cd moved/maps && ls | grep -v spheres | grep -v corner | tr '\n' ' ')" = "2024-site.png files.txt mine.png plane.svg "
check "nor is what others wrote into its list followed" test -e moved/mine.png
check "for ParaView too" test -s "moved/$(jq -r '.cases[0].image.map' moved.json).vti"
check "and its place on the plane of cost and error, darker at about the cost" jq -e 'all(.cases[]; .interval.ratio as $r |
  .plane.a[0] > 0 and (.plane.b[0] / .plane.a[0] / $r - 1 | fabs) < 1e-6 and .plane.a[1] < .rmse_a and .plane.b[1] != .plane.a[1])' moved.json
check "drawn" grep -q '<svg' moved/maps/plane.svg
check "which the table names" grep -qx 'cost and error of what moved, from A to B: moved/maps/plane.svg' .out
check "the line has both errors" grep -q 'MOVED .*the image changed; RMSE 0\.[0-9]* -> 0\.[0-9]* (' .out
check "and the map" grep -q 'map moved/maps/.*\.png' .out

# --- Two runs
run() { # NAME MODULE
  sed "s/^name: .*/name: $1/; s#techniques: .*#techniques: [{name: passes, module: $2}, {name: none}]#" null.yaml >"$1.yaml"
  "$program" run "$1.yaml" --out "$1" --quiet
}
run old "$modules/passes10.so"
run new "$modules/passes11.so"
run old_again "$modules/passes10.so"
code 1 "$program" compare old new --json runs.json
check "the module of the new run is SLOWER, the rest SAME" jq -e '(.cases | length) == 4 and all(.cases[];
  .verdict == (if (.case | contains("passes")) then "SLOWER" else "SAME" end) and (.paired | not))' runs.json
code 0 "$program" compare old old_again --json twice.json
check "a run twice is SAME" jq -e 'all(.cases[]; .verdict == "SAME" and .key_a == .key_b)' twice.json

# Stored figures are what is compared: the machine is slower by a fifth, so the old module is as well.
slow() { jq -c '.time.ratio_to_ref *= 1.2 | .time.ci_low *= 1.2 | .time.ci_high *= 1.2 | del(.time.rounds_file)' \
  "$1/journal.jsonl" >"$2/journal.jsonl"; }
cp -r old_again machine
slow old_again machine
code 3 "$program" compare old machine --json machine.json
check "an old module that is slower as well: the machine" jq -e 'all(.cases[]; .verdict == "SLOWER"
  and (.blame | contains("the machine is to blame")) and .outcome == "open")' machine.json
sed 's/spp: 32/spp: 64/; s/^name: .*/name: rays/' old.yaml >rays.yaml
"$program" run rays.yaml --out rays --quiet
cp -r rays rays_slow
slow rays rays_slow
code 3 "$program" compare old rays_slow --json rays.json
check "the same builds beside other truths: the machine too" jq -e 'all(.cases[]; .key_a != .key_b and .verdict == "SLOWER"
  and (.blame | contains("the machine is to blame")))' rays.json
cp -r new both
jq -c 'if .technique == "none" then .time.ratio_to_ref *= 1.1 | .time.ci_low *= 1.1 | .time.ci_high *= 1.1 else . end
  | del(.time.rounds_file)' new/journal.jsonl >both/journal.jsonl
code 3 "$program" compare old both --json both.json
check "a new module beside it is excused" jq -e 'all(.cases[]; .verdict == "SLOWER" and .outcome == "open") and
  any(.cases[]; .blame | contains("not the module"))' both.json
cp -r old_again other
jq -c '.fingerprint.driver = "another"' old_again/journal.jsonl >other/journal.jsonl
code 3 "$program" compare old other --json other.json
check "another driver is INVALID" jq -e 'all(.cases[]; .verdict == "INVALID" and (.reason | contains("driver")))' other.json
cp -r old_again lying
jq -c '.time.clock_reason = "it lies"' old_again/journal.jsonl >lying/journal.jsonl
for sides in "lying old_again A" "old_again lying B"; do
  read -r a b side <<<"$sides"
  code 3 "$program" compare $a $b --json lying.json
  check "a clock of $side that failed its test is INVALID" jq -e --arg why "the clock of $side's device cannot be trusted: it lies" \
    'all(.cases[]; .verdict == "INVALID" and (.reason | contains($why)))' lying.json
done
cp -r new partial
head -n 3 new/journal.jsonl >partial/journal.jsonl
code 1 "$program" compare old partial
check "what has no partner is named" grep -q '^only in A: corner/' .out
check "and what a run lacks of its plan" grep -qx 'aobudget: warning: partial: its journal has 3 of 4 cases; start the run again to measure the rest' .err
cp -r old_again cut
head -n 3 old_again/journal.jsonl >cut/journal.jsonl
code 3 "$program" compare old cut
# What filters left out is not missing. What one of them let through is, whichever came last.
filtered() { "$program" run old.yaml --out some --quiet "$@"; }
filtered --filter none
cp -r some others
code 0 "$program" compare some others
filtered --filter corner/far
code 0 "$program" compare some others
check "what the other run left out is named" grep -q '^only in A: corner/far passes' .out
tail -n 2 some/journal.jsonl >others/journal.jsonl
cp some/run.json others/
code 3 "$program" compare some others
check "a case of the first filter that is missing is told" grep -qx 'aobudget: warning: others: its journal has 2 of 3 cases; start the run again to measure the rest' .err
filtered
filtered --filter none
sed -i 1d some/journal.jsonl
code 3 "$program" compare some old
check "and without a filter it is any" grep -qx 'aobudget: warning: some: its journal has 3 of 4 cases; start the run again to measure the rest' .err

# --- Runs of other truths: what their noise adds to an error is no difference, and the same build is still the same
truths() { # NAME MODULE SPP
  sed "s/^name: .*/name: $1/; s#techniques: .*#techniques: [{name: loop, module: $2}]#; s/spp: 32/spp: $3/; s/^measure: .*/measure: {time: false}/" real.yaml >"$1.yaml"
  "$program" run "$1.yaml" --out "$1" --quiet
}
truths coarse "$modules/loop16.so" 8
truths fine "$modules/loop_moved.so" 1024
truths fine_old "$modules/loop16.so" 1024
error() { jq -s ".[0].error.$2" "$1/journal.jsonl"; }
"$program" compare coarse fine_old --json truths.json --quiet || true
check "rays of the truth move no image" jq -e 'all(.cases[]; .verdict != "MOVED" and .key_a != .key_b)' truths.json
cp -r coarse fewer # as if a bit of its image were another
jq -c '.image_digest = "0" | del(.image)' coarse/journal.jsonl >fewer/journal.jsonl
"$program" compare fewer fine_old --json fewer.json >.out || true
check "the noise is not taken for an error" jq -e 'all(.cases[]; .verdict == "MOVED" and .error == "equal"
  and .rmse_a - .rmse_b > 0.001 and .reference_se_a > 3 * .reference_se_b)' fewer.json
check "and the line says so" grep -q 'RMSE 0\.[0-9]* -> 0\.[0-9]*, without the noise of the truths 0\.[0-9]* -> 0\.[0-9]* (equal)' .out
"$program" compare coarse fine --json moved.json --quiet || true
check "a change of the image is seen through it" jq -e --argjson a "$(error fine_old rmse)" --argjson b "$(error fine rmse)" \
  'all(.cases[]; .verdict == "MOVED" and .error == (if $b > $a then "more" else "less" end))' moved.json

# --- A run and a new build: the old one is measured again beside it
sed 's#techniques: .*#techniques: [{name: passes}]#' null.yaml >stored.yaml
code 1 "$program" compare old "$modules/passes11.so" --config stored.yaml --out now --json now.json
check "the new build is SLOWER in the same blocks" jq -e '(.cases | length) == 2 and all(.cases[]; .verdict == "SLOWER" and .paired)' now.json
check "and the old one is what it was" jq -e '(.then_and_now.cases | length) == 2 and all(.then_and_now.cases[]; .verdict == "SAME")' now.json
code 1 "$program" compare machine "$modules/passes11.so" --config stored.yaml --out now --json now.json
check "or the machine is named" jq -e 'all(.then_and_now.cases[]; .verdict == "FASTER" and (.blame | contains("machine")))' now.json

# --- A run's own cases: as its config has them, which is kept in its folder, wherever that lay and whatever else it held
mkdir -p far/sub
cp "$modules/passes10.so" far/sub/old.so
printf 'v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 3 2\nf 1 4 3\n' | tee far/one.obj >far/two.obj
mkdir halls
cp far/one.obj halls/hall.obj
export AOBUDGET_SCENES=$PWD/halls
cat >far/own.yaml <<EOC
name: own
scenes: [{name: corner}, {name: hall, eye: [0, 1.5, 3], target: [0, 0, 0]}, {file: one.obj, eye: [0, 1, 3], target: [0, 0, 0]}, {file: two.obj, eye: [0, 1, 2], target: [0, 0, 0]}]
resolutions: [64x36]
backends: ["null"]
options: {guard_band: 8}
techniques: [{name: passes, module: sub/old.so}, {name: gtao, sweep: [{param: radius, values: [0.5, 0.7]}]}]
measure: {time: false, images: false}
reference: {spp: 8, thickness: 0.3}
EOC
check "a run" "$program" run far/own.yaml --out own --quiet
check "keeps its config" cmp own/run.config.yaml far/own.yaml
check "and where that lay" test "$(jq -r .config own/run.json)" = "$PWD/far/own.yaml"
code 1 "$program" compare own "$modules/passes11.so" --out again --json own.json
check "each of its cases is SLOWER, of the same keys, targets and options" jq -e --slurpfile stored own/journal.jsonl '
  ([$stored[] | select(.technique == "passes").key] | sort) == ([.cases[].key_a] | sort) and (.cases | length) == 4 and
  all(.cases[]; .verdict == "SLOWER" and .paired)' own.json
check "with the run's targets, which another technique's radii are" jq -es 'all(.[]; [.errors[].target.radius] | length == 2)' again/journal.jsonl
check "nothing else is measured" jq -es 'length == 8 and all(.[]; .technique == "passes")' again/journal.jsonl
rm far/one.obj halls/hall.obj
sed -i 's/v 1 0 1/v 1.5 0 1/' far/two.obj
code 1 "$program" compare own "$modules/passes11.so" --out again --json own.json --quiet
check "a scene that is gone: one line" grep -qx "aobudget: warning: one.obj is not there any more, as seen from $PWD/far/own.yaml: 1 case of it cannot be measured again" .err
check "one of the user's folder" grep -qx "aobudget: warning: hall is not there any more, as seen in AOBUDGET_SCENES, $PWD/halls: 1 case of it cannot be measured again" .err
check "one that changed: a line a case" grep -q '^aobudget: warning: two.obj/camera passes null 64x36 is not measured again: the scene' .err
check "the rest is measured" jq -e '(.cases | length) == 1 and all(.cases[]; .case | startswith("corner/"))' own.json
check "and what is not has no partner then" jq -e '.then_and_now.only_a | length == 3' own.json
cp "$modules/passes10.so" rebuilt.so
echo >>rebuilt.so # another file of the same code
rmdir halls
code 3 "$program" compare own rebuilt.so --out again --json own.json --quiet
check "where the rest is the same, it was done in part" jq -e '(.cases | length) == 1 and all(.cases[]; .verdict == "SAME")' own.json
check "a folder that is gone" grep -qx "aobudget: warning: hall: AOBUDGET_SCENES: cannot read the folder $PWD/halls: No such file or directory: 1 case of it cannot be measured again" .err
unset AOBUDGET_SCENES
sed '/^scenes/s/{name: corner}, //' far/own.yaml >far/gone.yaml
cp far/two.obj far/one.obj
sed -i '/^scenes/s/{name: hall[^}]*}, //' far/gone.yaml
check "a run of scenes" "$program" run far/gone.yaml --out gone --quiet
rm far/one.obj far/two.obj
expect 2 "far/gone.yaml: no scene of it is there any more" bash -c '"$@" 2>&1 | grep -v warning >&2; exit ${PIPESTATUS[0]}' - \
  "$program" compare gone "$modules/passes11.so" --out again --quiet
# A module of the command line stood in for its techniques.
sed 's/, module: sub.old.so//; s/, {name: hall.*}\]/]/' far/own.yaml >given.yaml
check "a run with --module" "$program" run given.yaml --module "$modules/passes10.so" --out given --quiet
code 1 "$program" compare given "$modules/passes11.so" --out again --json given.json
check "is measured again with it" jq -e '(.cases | length) == 1 and all(.cases[]; .verdict == "SLOWER")' given.json
echo '# changed' >>given/run.config.yaml
expect 2 "given/run.config.yaml is not the config that the run was measured with: name the cases with --config FILE" \
  "$program" compare given "$modules/passes11.so" --out again
rm given/run.config.yaml
expect 2 "given has no copy of its config, run.config.yaml: name the cases with --config FILE" "$program" compare given "$modules/passes11.so" --out again
mv far/sub/old.so far/sub/gone.so
expect 2 "the module of own: $PWD/far/sub/old.so: cannot open" "$program" compare own "$modules/passes11.so" --out again
cp "$modules/loop16.so" far/sub/old.so
expect 2 "far/sub/old.so is not the build that own was measured with" "$program" compare own "$modules/passes11.so" --out again

# --- What is refused
expect 2 "nothing.so: not found" "$program" compare nothing.so "$modules/loop16.so"
expect 2 "no technique of $modules/loop16.so that came from a module" "$program" compare old "$modules/loop16.so"
expect 2 "name the old one, the run, first" "$program" compare "$modules/loop16.so" old
expect 2 "are of modules" "$program" compare old new --seconds 3
expect 2 "no technique of one name" "$program" compare "$modules/loop16.so" "$modules/passes10.so"
expect 2 "a technique 'gtao'" "$program" compare "$modules/loop16.so" "$modules/loop17.so" --technique gtao
expect 2 "no entry of techniques" "$program" compare "$modules/loop16.so" "$modules/loop17.so" --config null.yaml --out refused --quiet
expect 2 "'3' is no precision" "$program" compare old new --precision 3
expect 2 "--seconds: 'x'" "$program" compare old new --seconds x
expect 2 "usage: aobudget compare A B" "$program" compare old
finish
