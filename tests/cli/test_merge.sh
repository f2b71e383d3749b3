#!/usr/bin/env bash
# `merge`: the folders of a run's parts become one folder, which every command takes as that of an ordinary run.
source "$(dirname "$0")/lib.sh"
cd "$folder"
cat >sweep.yaml <<'YAML'
name: sweep
scenes: [{name: corner, views: [front, far]}, {name: plane, view: front}]
resolutions: [64x36]
backends: [vulkan, "null"]
measure: {time: false}
reference: {spp: 2}
techniques:
  - {name: none}
  - {name: gtao, sweep: [{param: slices, values: [1, 2, 3]}, {param: radius, values: [0.5, 1]}]}
YAML
"$program" run sweep.yaml --out whole --quiet
for i in 1 2 3; do "$program" run sweep.yaml --shard $i/3 --out part-$i --quiet; done
files() { (cd "$1" && find . -type f ! -path './report/*' ! -name run.json | sort | xargs sha256sum); }
seal() { AOBUDGET_LOCK= "$AOBUDGET_BUILD/seal_copies" "$@"; }

# Three parts are the whole.
check "three parts" "$program" merge part-3 part-1 part-2 --out all --json all.json
check "are the whole, in the plan's order" cmp all/journal.jsonl whole/journal.jsonl
check "with all its files, and no more" diff <(files whole) <(files all)
check "the document says so" jq -e '.name == "sweep" and .folders == ["part-3", "part-1", "part-2"] and .cases == 42 and .planned == 42
  and .dropped == 0 and .missing == 0 and .conflicts == [] and .lost == [] and .apart == []
  and .out == [{"folder": "all", "folders": .folders, "cases": 42, "missing": 0, "files": .out[0].files}] and .out[0].files > 42' all.json
check "two lines tell a person" diff <("$program" merge part-3 part-1 part-2 --out all 2>&1) <(echo "aobudget: all: 42 cases of 3 folders")
check "and none if it is to be quiet" test -z "$("$program" merge part-3 part-1 part-2 --out all --quiet 2>&1)"
check "run.json is that of the whole" diff <(jq -S 'del(.date, .seconds, .merged, .asked)' all/run.json) <(jq -S 'del(.date, .seconds)' whole/run.json)
check "all of it was asked for" jq -e '.asked == .keys' all/run.json
check "it knows from where" jq -e --arg here "$PWD" '.merged == ["part-3", "part-1", "part-2"] | not' all/run.json
check "namely by paths from the root" jq -e --arg here "$PWD" '.merged == [$here + "/part-3", $here + "/part-1", $here + "/part-2"]' all/run.json
cp all/journal.jsonl first
check "a report of it is complete" "$program" report all --quiet
"$program" compare whole all --json compared.json --quiet
check "compare finds a partner for each case" jq -e '.cases | length == 42' compared.json
check "made again, it is" "$program" merge part-3 part-1 part-2 --out all --quiet
check "the same to the byte" cmp first all/journal.jsonl
: >all/journal.jsonl
rm -f all/images/*.exr
check "one that was interrupted is made again" "$program" merge part-3 part-1 part-2 --out all/ --quiet
check "and whole" diff <(files whole) <(files all)
check "a run goes on in it" "$program" run sweep.yaml --out all --quiet --json run.json
check "and measures nothing" jq -e '.cases == 42 and .status.ok == 42 and .seconds.measured == 0 and .seconds.images == 0' run.json
check "so its journal stays" cmp first all/journal.jsonl
expect 2 "all holds a run: choose another --out" "$program" merge part-3 part-1 part-2 --out all

# What is missing, and what a run of the merged folder does then.
missing=$(wc -l <part-2/journal.jsonl)
expect 3 "$missing of 42 cases of the plan are in none of the folders" "$program" merge part-1 part-3 --out two --quiet
check "they were not asked for" test "$(jq '.asked | length' two/run.json)" -eq $((42 - missing))
check "the others have the plan's order" diff <(jq -r .key whole/journal.jsonl | grep -Ff <(jq -r .key part-1/journal.jsonl part-3/journal.jsonl)) <(jq -r .key two/journal.jsonl)
expect 2 "two was merged from $PWD/part-3 as well, which is not given" "$program" merge part-1 part-2 --out two
check "a merge of more takes its place" "$program" merge part-1 part-2 part-3 --out two --quiet
check "with all" cmp two/journal.jsonl whole/journal.jsonl
"$program" merge part-1 part-3 --out open --quiet 2>told
check "a run measures the rest" "$program" run sweep.yaml --out open --quiet
check "and no more" diff <(jq -cS . open/journal.jsonl | sort) <(jq -cS . whole/journal.jsonl | sort)
mkdir none && cp part-1/run.json part-1/run.config.yaml none
expect 3 "42 of 42 cases of the plan are in none of the folders" "$program" merge none --out nothing --quiet

# A key that is there twice.
key=$(jq -r .key part-1/journal.jsonl | sed -n 2p)
cp -r part-1 twin
check "a folder twice" "$program" merge part-1 twin part-2 part-3 --out twice --json twice.json --quiet
check "is dropped once" jq -e --argjson own "$(wc -l <part-1/journal.jsonl)" '.dropped == $own and .conflicts == [] and .cases == 42' twice.json
check "which a line counts" grep -q "^aobudget: $(wc -l <part-1/journal.jsonl) records were dropped" <("$program" merge part-1 twin part-2 part-3 --out twice 2>&1)
sed "s/\(\"key\":\"$key\".*\"status\":\)\"ok\"/\1\"failed\"/" part-1/journal.jsonl >twin/journal.jsonl
check "one failed" grep -q '"status":"failed"' twin/journal.jsonl
check "a failed case" "$program" merge twin part-1 part-2 part-3 --out better --quiet
check "gives way to a good one" cmp better/journal.jsonl whole/journal.jsonl
check "also where it comes later" "$program" merge part-1 twin part-2 part-3 --out better --quiet
check "so that the good one stands" cmp better/journal.jsonl whole/journal.jsonl
sed "s/\(\"key\":\"$key\".*\"status\":\)\"ok\"/\1\"invalid\"/" part-1/journal.jsonl >twin/journal.jsonl
cp -r part-1 failed && sed 's/"status":"ok"/"status":"failed"/' part-1/journal.jsonl >failed/journal.jsonl
"$program" merge failed twin part-2 part-3 --out invalid --quiet
check "an invalid one is better than a failed one" test "$(jq -r "select(.key == \"$key\").status" invalid/journal.jsonl)" = invalid
sed "s/\(\"key\":\"$key\".*\"image_digest\":\)\"[0-9a-f]*\"/\1\"00\"/" part-1/journal.jsonl >twin/journal.jsonl
name="$(jq -r "select(.key == \"$key\") | .scene + \"/\" + .view + \" \" + .technique" part-1/journal.jsonl)"
expect 3 "$name" "$program" merge part-1 twin part-2 part-3 --out other --quiet --json other.json
check "both folders are named" grep -q "has another image_digest in twin than in part-1, which stands (case $key)" .stderr
check "in the document too" jq -e --arg key "$key" '.conflicts | length == 1 and .[0].key == $key and .[0].folders == ["part-1", "twin"] and .[0].differs == "image_digest"' other.json
check "the first stands" cmp other/journal.jsonl whole/journal.jsonl
check "the other is kept, with its folder" diff <(jq -cS . other/conflicts.jsonl) <(jq -cS --arg folder "$PWD/twin" --arg key "$key" 'select(.key == $key) | {$folder, record: .}' twin/journal.jsonl)
check "as it stood" grep -qF "$(grep "\"key\":\"$key\"" twin/journal.jsonl)" other/conflicts.jsonl
check "the warning says where" grep -q "the other is kept in other/conflicts.jsonl" .stderr
check "and the document" jq -e '.conflicts[0].kept == "other/conflicts.jsonl"' other.json
cp -r part-1 third && sed "s/\(\"key\":\"$key\".*\"image_digest\":\)\"[0-9a-f]*\"/\1\"11\"/" part-1/journal.jsonl >third/journal.jsonl
"$program" merge part-1 twin part-2 third --out others --quiet 2>told
check "each that lost is kept" test "$(jq -c '[.folder, .record.image_digest]' others/conflicts.jsonl)" = "$(printf '["%s","%s"]\n' "$PWD/twin" 00 "$PWD/third" 11)"
cp twin/journal.jsonl changed
cp part-1/journal.jsonl twin
check "a merge without a conflict" "$program" merge part-1 twin part-2 part-3 --out other --quiet
check "has no such file" test ! -e other/conflicts.jsonl
cp changed twin/journal.jsonl
expect 3 "has another image_digest in part-1 than in twin" "$program" merge twin part-1 part-2 part-3 --out other --quiet
check "whichever it is" test "$(jq -r "select(.key == \"$key\").image_digest" other/journal.jsonl)" = 00
sed "s/\(\"key\":\"$key\".*\"rmse\":\)[0-9.]*/\17/" part-1/journal.jsonl >twin/journal.jsonl
expect 3 "has another error" "$program" merge part-1 twin part-2 part-3 --out other --quiet
sed 's/"status":"ok"/"memory":7,&/' part-1/journal.jsonl >twin/journal.jsonl
check "what is no result may differ" "$program" merge part-1 twin part-2 part-3 --out other --quiet

# Files that are lost, damaged or not the same.
image=$(jq -r .image part-1/journal.jsonl | head -1)
rm -rf twin && cp -r part-1 twin && rm "twin/$image"
expect 3 "twin/$image: cannot read: No such file or directory" "$program" merge twin part-2 part-3 --out lost --quiet --json lost.json
check "the record stays" cmp lost/journal.jsonl whole/journal.jsonl
check "one that agrees and was dropped" "$program" merge twin part-1 part-2 part-3 --out spare --quiet --json spare.json
check "lends what the first lost" diff <(files whole) <(files spare)
check "and nothing is told of it" jq -e --argjson own "$(wc -l <part-1/journal.jsonl)" '.lost == [] and .apart == [] and .dropped == $own' spare.json
check "the document names it" jq -e --arg file "$image" '.lost | length == 1 and .[0].file == $file and .[0].folder == "twin"' lost.json
cp -r part-1/images twin && printf x | dd of="twin/$image" bs=1 seek=900 conv=notrunc 2>/dev/null
expect 3 "twin/$image: it is damaged" "$program" merge twin part-2 part-3 --out lost --quiet
check "a run measures it again" "$program" run sweep.yaml --out lost --quiet
check "so that it is there" cmp "lost/$image" "whole/$image"
truths=($(cd part-2 && ls truths/*.exr))
rm -rf twin && cp -r part-1 twin && rm -f twin/truths/*.exr
check "a truth that another folder has is taken from there" "$program" merge twin part-2 part-3 --out lost2 --quiet
check "so nothing lacks" diff <(files whole) <(files lost2)
rm -rf twin && cp -r part-1 twin
shared=$(comm -12 <(cd part-1 && ls truths) <(cd part-2 && ls truths) | head -1)
other=$(cd part-1 && ls truths | grep -v "$shared" | head -1)
check "a tool seals" seal "part-1/truths/$other" twin/truths <<<"${shared%.exr}"
expect 3 "truths/$shared has other bytes in twin than in part-2, and is kept as truths/" "$program" merge part-2 twin part-3 --out apart --quiet --json apart.json
became=$(jq -r '.apart[0].becomes' apart.json)
check "it has a name of its own" test -s "apart/$became" -a "$became" != "truths/$shared"
check "its seal is right" test "$("$AOBUDGET_BUILD/print_layers" "apart/$became" | md5sum)" = "$("$AOBUDGET_BUILD/print_layers" "part-1/truths/$other" | md5sum)"
check "the first keeps the name" cmp "apart/truths/$shared" "part-2/truths/$shared"
check "the records of that folder name it" diff <(jq -r "select(.errors[]?.truth == \"truths/$shared\").key" part-1/journal.jsonl | sort -u) <(jq -r "select(.errors[]?.truth == \"$became\").key" apart/journal.jsonl | sort -u)
check "and those of others the first" diff <(jq -r "select(.errors[]?.truth == \"truths/$shared\").key" part-2/journal.jsonl part-3/journal.jsonl | sort -u) <(jq -r "select(.errors[]?.truth == \"truths/$shared\").key" apart/journal.jsonl | sort -u)
check "a run takes it as it is" "$program" run sweep.yaml --out apart --quiet
sed 's|"image":"images/|"image":"../images/|' part-1/journal.jsonl >twin/journal.jsonl
"$program" merge twin part-2 part-3 --out evil --quiet 2>told
check "a name that leads elsewhere" test $? -eq 3 -a "$(grep -c "which is no file of a run" told)" -ge 10
check "writes nothing there" test ! -e images

# Devices are never mixed; one that could not be opened conflicts with none.
change() { rm -rf "$2" && cp -r "$1" "$2" && jq "$3" "$1/run.json" >"$2/run.json"; }
change part-2 foreign '.devices.vulkan.driver = "another"'
change part-3 shut '.devices.vulkan = null'
"$program" merge part-1 foreign shut --out devices --json devices.json --quiet 2>told
check "two devices are two folders" test $? -eq 3
check "with one note" grep -q "^aobudget: devices-2: merged from foreign, on another device (vulkan: llvmpipe.*another.*; in devices it is llvmpipe" told
check "which the document names" jq -ce '[.out[] | [.folder, .folders]] == [["devices", ["part-1", "shut"]], ["devices-2", ["foreign"]]] and .missing == 0' devices.json
check "the first has its own" test "$(jq -r .devices.vulkan.driver devices/run.json)" = "$(jq -r .devices.vulkan.driver whole/run.json)"
check "as has the second" test "$(jq -r .devices.vulkan.driver devices-2/run.json)" = another
check "with its cases" diff <(jq -r .key devices-2/journal.jsonl | sort) <(jq -r .key part-2/journal.jsonl | sort)
check "which it asked for" test "$(jq '.asked | length' devices-2/run.json)" -eq "$(wc -l <part-2/journal.jsonl)"
"$program" merge shut part-1 part-2 --out opened --quiet
check "what one folder could not open, another could" test "$(jq -c .devices opened/run.json)" = "$(jq -c .devices whole/run.json)"
mkdir keep-2 && echo '{"key":"a"}' >keep-2/journal.jsonl
expect 2 "keep-2 holds a run" "$program" merge part-1 foreign --out keep
check "nothing is written then" test ! -e keep
touch file-2 part-file
expect 2 "file-2: it is not a folder" "$program" merge part-1 foreign --out file
check "nor where the second is no folder" test ! -e file
expect 2 "part-file: it is not a folder" "$program" merge part-1 part-2 --out part-file/of/it
ln -s nowhere link-2
expect 2 "link-2: cannot create the folder: No such file or directory" "$program" merge part-1 foreign --out link
mkdir sub-2 && touch sub-2/truths
expect 2 "sub-2/truths: it is not a folder" "$program" merge part-1 foreign --out sub
mkdir busy-2
exec 9>>busy-2/journal.jsonl
flock 9
expect 2 "busy-2/journal.jsonl: a run is writing here; wait for it" "$program" merge part-1 foreign --out busy
exec 9>&-
check "nor by any of these" test ! -e link -a ! -e sub -a ! -e busy
mkdir -p odd-2/run.json
expect 2 "odd is merged, but not odd-2: " "$program" merge part-1 foreign --out odd

# What cannot be merged.
change part-2 config '.config_hash = "00"'
change part-2 build '.build = "11"'
expect 2 "part-1 and config hold runs of two configs (config_hash $(jq -r .config_hash part-1/run.json) and 00)" "$program" merge part-1 config --out bad
expect 2 "part-1 and build hold runs of two builds of this program (build $(jq -r .build part-1/run.json) and 11)" "$program" merge part-1 build --out bad
expect 2 "part-1 and ./part-1 are one folder: give it once" "$program" merge part-1 part-2 ./part-1 --out bad
expect 2 "sweep.yaml: it has no run.json" "$program" merge part-1 sweep.yaml --out bad
expect 2 "missing: there is no such folder" "$program" merge part-1 missing --out bad
rm -rf twin && cp -r part-1 twin && rm twin/run.json
expect 2 "twin: it has no run.json, so it is no folder of a run" "$program" merge part-2 twin --out bad
head -c 100 part-1/run.json >twin/run.json
expect 2 "twin/run.json: it is damaged" "$program" merge part-2 twin --out bad
expect 2 "part-2 is one of the folders that are merged: choose another --out" "$program" merge part-1 part-2 --out part-2
expect 2 "whole holds a run: choose another --out" "$program" merge part-1 part-2 --out whole
expect 2 "merge: --out DIR is missing" "$program" merge part-1 part-2
expect 2 "usage: aobudget merge DIR... --out DIR" "$program" merge --out bad
expect 2 "sweep.yaml" "$program" merge part-1 part-2 --out sweep.yaml
exec 9>>part-2/journal.jsonl
flock 9
expect 2 "part-2/journal.jsonl: a run is writing here; wait for it" "$program" merge part-1 part-2 --out bad
exec 9>&-
check "nothing was written" test ! -e bad
check "and every part is as it was" "$program" merge part-1 part-2 part-3 --out again --quiet
check "to the byte" cmp again/journal.jsonl whole/journal.jsonl

# A disk that is full leaves no run, and the call is made again.
expect 2 "cannot write: File too large" bash -c "ulimit -f 20; '$program' merge part-1 part-2 part-3 --out full"
check "no run is there" test ! -s full/journal.jsonl
check "so it is made again" "$program" merge part-1 part-2 part-3 --out full --quiet
check "and whole" cmp full/journal.jsonl whole/journal.jsonl

# Raw rounds of timed parts come along, as does what a merge has made.
sed 's/time: false/seconds: 0.05, images: false/; s/, "null"//; s/1, 2, 3/1/' sweep.yaml >timed.yaml
for i in 1 2; do "$program" run timed.yaml --shard $i/2 --out timed-$i --quiet; done
check "timed parts" "$program" merge timed-1 timed-2 --out timed --quiet
check "have rounds" test "$(ls timed/rounds | wc -l)" -ge 2
check "all of them" diff <(cd timed/rounds && sha256sum *) <(sha256sum timed-?/rounds/* | sed 's|timed-./rounds/||' | sort -k 2)
check "a merge of a merge" "$program" merge timed timed-1 --out timed-again --quiet
check "is the same" cmp timed/journal.jsonl timed-again/journal.jsonl
check "a run has nothing to time" "$program" run timed.yaml --out timed --quiet --json timed.json
check "so it times nothing" jq -e '.cases == 9 and .status.ok == 9 and .seconds.measured == 0' timed.json
check "budget takes it" "$program" budget timed --ms 1000

# A module that was built anew between two parts is another technique.
cp "$AOBUDGET_BUILD/tests/modules/loop16.so" mine.so
sed 's/^scenes:.*/scenes: [{name: corner}, {name: plane}]/; s/vulkan, //; /^techniques:/q' sweep.yaml >module.yaml
echo '  - {name: loop, module: mine.so}' >>module.yaml
for i in 1 2; do "$program" run module.yaml --shard $i/2 --out built-$i --quiet; done
check "parts of one build" "$program" merge built-1 built-2 --out built --quiet
printf x >>mine.so
"$program" run module.yaml --shard 2/2 --out rebuilt --quiet
digest() { jq -r '.techniques[0].digest' "$1/run.json"; }
expect 2 "built-1 and rebuilt hold runs of two builds of technique 'loop' of mine.so (digest $(digest built-1) and $(digest rebuilt))" "$program" merge built-1 rebuilt --out mixed
jq 'del(.techniques)' built-1/run.json >none/run.json
rm -f none/journal.jsonl
expect 2 "built-2 and rebuilt hold runs of two builds" "$program" merge none built-2 rebuilt --out mixed
check "nothing is written then" test ! -e mixed

# A journal that was cut within a line lacks that case; one with a line of rubbish says so.
rm -rf twin && cp -r part-1 twin
head -c -10 part-1/journal.jsonl >twin/journal.jsonl
expect 3 "1 of 42 cases of the plan are in none of the folders" "$program" merge twin part-2 part-3 --out cut --quiet
check "the others are there" test "$(wc -l <cut/journal.jsonl)" -eq 41
{ head -1 part-1/journal.jsonl; echo '{"key":'; tail -n +2 part-1/journal.jsonl; } >twin/journal.jsonl
check "rubbish" "$program" merge twin part-2 part-3 --out rubbish --quiet
"$program" merge twin part-2 part-3 --out rubbish --quiet 2>told
check "is told" grep -q "twin/journal.jsonl: line 2 of .* is damaged and passed over" told
check "and left behind" cmp rubbish/journal.jsonl whole/journal.jsonl
finish
