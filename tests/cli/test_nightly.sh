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
# sql FILE STATEMENTS: what the last one finds, a row a line, with | between columns.
sql() {
  python3 - "$@" <<'EOP'
import sqlite3, sys
with sqlite3.connect(sys.argv[1]) as database:
    for statement in sys.argv[2].split(";"):
        rows = database.execute(statement).fetchall()
for row in rows:
    print(*row, sep="|")
EOP
}

# --- Costs
install_old
night costs1 0 costs.yaml
check "the first night has first cases only" jq -e '.first == 4 and .worse == 0 and .suspects == 0 and .watched == 0
  and .line == "nothing to compare with; 4 for the first time"' costs1.json
night costs2 0 costs.yaml
check "the second has nothing to tell" jq -e '.line == "nothing changed" and .watched == 4 and .suspects == 0 and .cases == []' costs2.json
cp "$modules/passes11.so" modules/slow.so
night costs3 1 costs.yaml --markdown costs3.md
check "a module that is 10 % slower is named, beside its old build, to the digit" jq -e '.worse == 2 and .suspects == 2 and
  ([.cases[] | select(.verdict == "slower" and .outcome == "worse" and (.case | test("^corner/(front|far) .*passes")))
    | .beside, .low, .high, .after / .before | . > 1.0999 and . < 1.1001] | length == 8 and all)' costs3.json
check "and the one that is not is not" jq -e '[.cases[].case] | length == 2 and all(test("same.so") | not)' costs3.json
check "the sentence names the share and the night" jq -e --arg date "$(jq -r .date costs3.json | cut -c1-10)" \
  'all(.cases[].said; startswith("10.0 % dearer since \($date), 10.0 % dearer beside the old build; memory "))' costs3.json
check "the screen names it" grep -q 'slow.so' costs3.out
check "the Markdown names it" grep -q 'slow.so' costs3.md
check "and has no link, as none would lead anywhere" sh -c '! grep -q "](" costs3.md'
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

cp "$modules/loop16.so" modules/moved.so
night images5 0 images.yaml
check "an image that is nearer to the truth is told, and is no regression" jq -e '.worse == 0 and (.cases[0] | .verdict == "moved" and .outcome == "good")' images5.json
sql nights.db "UPDATE point SET verdict = 'none', said = '' WHERE night = (SELECT max(id) FROM night);
  UPDATE night SET summary = '{\"line\": \"stopped\"}' WHERE id = (SELECT max(id) FROM night)"
night images6 0 images.yaml
check "nothing is compared with a night that was not judged" jq -e '.cases | length == 1 and .[0].verdict == "moved"' images6.json

# --- A case that does not run any more
cat >broken.yaml <<EOC
name: broken
scenes: [{name: corner}]
resolutions: [64x36]
backends: ["null"]
techniques: [{name: mortal, module: $modules/mortal.so}]
measure: {seconds: 0.1}
reference: {spp: 32}
EOC
night broken1 0 broken.yaml
printf xxxxxxxxxxxxxxxx >fates
MORTAL=$folder/fates night broken2 1 broken.yaml
check "it is worse, and its cause is told" jq -e '.worse == 1 and (.cases[0] | .verdict == "broken" and (.said | startswith("failed now, and it ran before: ")))' broken2.json
printf xxxxxxxxxxxxxxxx >fates
MORTAL=$folder/fates night broken3 3 broken.yaml
check "the next night it is no news, but is told" jq -e '.line == "1 failing" and .worse == 0 and .open == 1 and (.cases[0].said | startswith("failed, as before: "))' broken3.json
night broken4 0 broken.yaml
check "when it runs again nothing is worse" jq -e '.worse == 0 and .line == "nothing changed"' broken4.json

# --- A run that was made elsewhere. Its journal is what the night is of, so costs can be planted in it: all are 10 when they are
# measured.
install_old
run() { # NAME FOLDER
  sed "s/name: costs/name: $1/" costs.yaml >"$1.yaml"
  "$program" run "$1.yaml" --out "$2" --quiet
}
plant() { # FROM TO FACTOR: the costs of slow.so
  cp -r "$1" "$2"
  jq -c --argjson by "$3" 'if .module == "modules/slow.so" then .time |= (.ratio_to_ref *= $by | .ci_low *= $by | .ci_high *= $by) else . end' \
    "$1/journal.jsonl" >"$2/journal.jsonl"
}
run shifted shifted
run planted first
plant shifted shifted1 0.8
plant shifted shifted2 0.8
plant first second 0.8
plant first third 0.8
night shifted1 0 shifted1
night shifted2 0 shifted2
night planted1 0 second
night planted2 0 third
night planted3 0 first
check "a shift of the same build is laid to the machine" jq -e '.worse == 0 and .suspects == 2 and ([.cases[] | .verdict == "machine"
  and .beside == null and (.said | test("^25.0 % dearer since .*, and the technique.s build is the same"))] | length == 2 and all)' planted3.json
expect 2 "first is the night of" "$program" nightly first --history nights.db
printf new >>modules/slow.so # the same code in other bytes
run shifted shifted3
night shifted3 0 shifted3
check "and so is one that the old build has too" jq -e '.worse == 0 and .suspects == 2 and ([.cases[] | .verdict == "machine"
  and .beside == 1 and (.said | test("^25.0 % dearer since .*, and the old build beside it is too"))] | length == 2 and all)' shifted3.json
run planted fourth
plant fourth fifth 1.44
night planted5 0 fifth
check "what is not there when it is measured again is an outlier" jq -e '.worse == 0 and ([.cases[] | .verdict == "outlier" and .beside == 1
  and (.said | test("^44.0 % dearer since .*, and not when it was measured again"))] | length == 2 and all)' planted5.json
sql nights.db 'DELETE FROM module'
printf newer >>modules/slow.so
run planted sixth
plant sixth seventh 2
night planted7 3 seventh
check "without the old build it stays open, and the cause is told" jq -e '.open == 2 and (.cases[0].said | test("not measured again: .*give the old build with --old$"))' planted7.json
check "the screen says so" grep -q 'could not be decided' planted7.out
mkdir builds && cp "$modules/passes10.so" builds/slow.so
plant sixth eighth 2
night planted8 0 eighth --old builds
check "--old has it" jq -e '.open == 0 and .suspects == 2 and ([.cases[].beside == 1] | all)' planted8.json

check "--old that is the build itself is none" sh -c 'mkdir own && cp modules/slow.so own'
cp own/slow.so modules/slow.so && printf own >>modules/slow.so && cp modules/slow.so own/
run planted tenth
plant tenth ninth 4
night planted9 3 ninth --old own
check "and is said to be" jq -e '.open == 2 and (.cases[0].said | test("own/slow.so is the build that the night measured, and no older one$"))' planted9.json
expect 2 "is the night of" "$program" nightly ./eighth/ --history nights.db

# --- A step that is dated late: the nights before it are of the new build already, and it is to blame all the same.
install_old
cp "$modules/passes10.so" modules/late.so
printf late >>modules/late.so
sed 's/name: costs/name: late/; s/slow.so/late.so/' costs.yaml >late.yaml
"$program" run late.yaml --out before --quiet
late() { # FROM FOLDER FACTOR WANTED
  cp -r "$1" "$2"
  jq -c --argjson to "$3" 'if .module == "modules/late.so" then .time |= (.ratio_to_ref = 10 * $to | .ci_low = 9.99 * $to | .ci_high = 10.01 * $to) else . end' \
    "$1/journal.jsonl" >"$2/journal.jsonl"
  night "$2" "$4" "$2"
}
i=0
for by in 1 1.004 .997 1.006 .995 1.003 .999 1.005 .996; do
  i=$((i + 1))
  late before "late$i" "$by" 0
done
cp "$modules/passes11.so" modules/late.so
printf late >>modules/late.so
"$program" run late.yaml --out after --quiet
late after late10 1.012 0
late after late11 1.035 1
check "the build of the level before is set beside it" jq -e '.worse == 2 and all(.cases[]; .verdict == "slower" and .beside > 1.0999)' late11.json

# --- What a run lacks, image and cost together, and a trend page that cannot be written
cp "$modules/loop_again.so" modules/still.so
"$program" run images.yaml --out whole --quiet
look() { # FOLDER FILTER OF JQ
  cp -r whole "$1"
  jq -c "$2" whole/journal.jsonl >"$1/journal.jsonl"
}
look cut 'select(.module != "modules/moved.so")'
look other 'if .module == "modules/moved.so" then .image_digest = "00000000000000000000000000000001" | .error.rmse = 0.9 | .errors[0].rmse = 0.9 else . end'
night lacks1 3 cut
check "what a run lacks is said" jq -e '.missing == 1 and .gone == 1 and (.line | endswith("; 1 of 2 cases not measured; 1 of the night before not in this one"))' lacks1.json
rm -rf results/nightly/images/trend && touch results/nightly/images/trend
night lacks2 1 other
check "an image of the same build is laid to the program, and is worse all the same" jq -e '[.cases[] | select(.outcome == "worse" and .verdict == "moved")
  | .said | test("^the image changed; RMSE .*worse.*so the program changed it$")] == [true]' lacks2.json
cp "$modules/loop_moved.so" modules/moved.so
"$program" run images.yaml --out drawn --quiet
cp modules/moved.so drawn.so && cp "$modules/loop16.so" modules/moved.so
digest() { jq -r '.techniques[] | select(.module == "modules/moved.so") | .digest' "$1/run.json"; }
sed -i "s/$(digest drawn)/$(digest whole)/" drawn/run.json
night lacks3 0 whole
night lacks4 1 drawn
check "its images are compared as they are stored, with the map" jq -e '.cases[0] | .verdict == "moved" and (.map | test("^images/1/maps/"))
  and (.said | test("^the image changed; RMSE .*worse.*so the program changed it"))' lacks4.json
check "the trend is a warning" grep -q 'warning: the trend page: ' lacks2.err
rm results/nightly/images/trend

# --- Killed in the middle
sed 's/name: costs/name: killed/; s/seconds: 0.2/seconds: 2/; s/views: \[front, far\]/views: [front]/; s/96x54/96x54, 64x36, 32x18, 16x9/' costs.yaml >killed.yaml
setsid "$program" nightly killed.yaml --history killed.db --quiet >/dev/null 2>&1 &
victim=$!
journal=results/nightly/killed/none
for ((i = 0; i < 600; i++)); do
  journal=$(echo results/nightly/killed/*/journal.jsonl)
  [ -s "$journal" ] && [ "$(wc -l <"$journal")" -ge 2 ] && break
  sleep 0.1
done
kill -9 -- -$victim
wait $victim 2>/dev/null || true
cp "$journal" before.jsonl
before=$(wc -l <before.jsonl)
got=0
"$program" nightly killed.yaml --history killed.db --quiet --json killed.json || got=$?
check "a night that was killed is gone on with" test "$got" -eq 0 -a "$(jq .night killed.json)" -eq 1
check "and no case of it is measured again" cmp -n "$(stat -c %s before.jsonl)" before.jsonl "$journal"
check "it had begun and not ended" test "$before" -ge 2 -a "$before" -lt 8
check "the history has every case of it" test "$(sql killed.db 'SELECT count(*), min(whole) FROM point JOIN night ON night.id = night')" = '8|1'

# --- Two calls at once, and a module that is built again meanwhile
sed 's/name: killed/name: twice/; s/seconds: 1/seconds: 3/' killed.yaml >twice.yaml
start() { # waits until a case of the night is measured
  "$program" nightly twice.yaml --history twice.db --quiet >/dev/null 2>"$1.err" &
  first=$!
  for ((i = 0; i < 600; i++)); do
    cat results/nightly/twice/*/journal.jsonl 2>/dev/null | grep -q . && [ "$(cat results/nightly/twice/*/journal.jsonl | wc -l)" -ge "$2" ] && break
    sleep 0.1
  done
}
start twice1 1
expect 2 "another call of nightly has this night" "$program" nightly twice.yaml --history twice.db
got=0 && wait $first || got=$?
check "the first one ends well" test "$got" -eq 0
start twice2 9
printf again >>modules/slow.so
got=0 && wait $first || got=$?
check "a module that was built meanwhile ends the night" test "$got" -eq 2
check "with a line" grep -q 'was built again while the night of' twice2.err
got=0 && "$program" nightly twice.yaml --history twice.db --quiet --json twice3.json 2>twice3.err || got=$?
check "the next night is judged against the one that was judged" test "$got" -eq 0 -a "$(jq .night twice3.json)" -eq 3 -a "$(jq .watched twice3.json)" -eq 8
check "and the other is said to be unjudged" grep -q 'it ends unjudged' twice3.err

# --- Bad input
expect 2 "--history F.db is missing" "$program" nightly costs.yaml
expect 2 "missing.yaml" "$program" nightly missing.yaml --history nights.db
expect 2 "--old nowhere: not found" "$program" nightly costs.yaml --history nights.db --old nowhere
expect 2 "costs.yaml" "$program" nightly costs.yaml --history costs.yaml
expect 2 "--precision" "$program" nightly costs.yaml --history nights.db --precision 3
expect 2 "--seconds: 'x'" "$program" nightly costs.yaml --history nights.db --seconds x
expect 2 "run.json" "$program" nightly builds --history nights.db
finish
