#!/usr/bin/env bash
# What the program says: a standard output that cannot be written is never missed, and no control character of an input is
# sent to a terminal, wherever the input is quoted.
source "$(dirname "$0")/lib.sh"
cd "$folder"
control=$AOBUDGET_BUILD/tests/modules/control.so
export AOBUDGET_CACHE=$folder/cache
cat >config.yaml <<END
name: output
scenes: [{name: plane}]
resolutions: [32x18]
backends: ["null"]
techniques: [{name: none}]
measure: {time: false, images: false}
reference: {spp: 2}
END
check "a run" "$program" run config.yaml --out out --quiet

full() { # COMMAND...: with a standard output on a full device: code 2, one line with the cause, nothing else
  local got=0
  "$@" >/dev/full 2>.stderr </dev/null || got=$?
  if [ "$got" -ne 2 ] || [ "$(cat .stderr)" != "aobudget: error: standard output: cannot write: No space left on device" ]; then
    echo "FAILED: $* >/dev/full: code $got and:"
    sed 's/^/  | /' .stderr
    failures=$((failures + 1))
  fi
}
shot=("$program" shot --technique none --scene plane --backend null --size 8x8 --reference-spp 0)
full "$program"
full "$program" --help
full "$program" --version
for what in techniques scenes lights backends; do
  full "$program" list $what
  full "$program" list $what --json -
done
for command in list plan run shot report papers doctor; do full "$program" $command --help; done
full "$program" plan config.yaml
full "$program" plan config.yaml --json -
full "$program" run config.yaml --out out --quiet --json -
full "${shot[@]}"
full "${shot[@]}" --json -
full "$program" report out --quiet --json -
full "$program" papers --filter words --out papers
full "$program" papers --filter words --out papers --quiet --json -
full "$program" doctor --json -
VK_ICD_FILENAMES=/nonexistent.json VK_DRIVER_FILES=/nonexistent.json full "$program" doctor
check "what says nothing there needs no standard output" bash -c "'$program' run config.yaml --out out >&-"
expect 2 "unknown command 'rum'" bash -c "'$program' rum >/dev/full" # the first failure is the one that is told

# The bytes that a terminal obeys: all control characters but the line break, also those that UTF-8 writes with two bytes.
hold_no_control() { ! LC_ALL=C grep -qP '[\x00-\x09\x0b-\x1f\x7f]|\xc2[\x80-\x9f]' "$@"; }
clean() { # CODE 'TEXT' COMMAND...: what it prints is free of them, and holds TEXT
  local code=$1 text=$2 got=0
  shift 2
  "$@" >.said 2>&1 </dev/null || got=$?
  if [ "$got" -ne "$code" ] || ! hold_no_control .said || ! grep -qiF -- "$text" .said; then
    echo "FAILED: $*"
    echo "  expected code $code and '$text' without control characters; got code $got and:"
    cat -v .said | head -20 | sed 's/^/  | /'
    failures=$((failures + 1))
  fi
}
esc=$'\033[2J' c1=$'\302\233m'
printf "%s" "a$esc" >escape && printf "%s" "$c1" >two-bytes
check "the check itself" bash -c "! $(declare -f hold_no_control); ! hold_no_control escape && ! hold_no_control two-bytes"
clean 2 "unknown command 'x\\u001b[2J'" "$program" "x$esc"
clean 2 "unknown flag --\\u009bm" "$program" run "--$c1"
clean 2 "unknown scene 's\\u001b[2J'" "${shot[@]/plane/s$esc}"
clean 2 "'1\\u001b[2J' is not a number" "${shot[@]/none/gtao}" -p "radius=1$esc"
sed 's/name: none/name: "no\\e[2Jne"/' config.yaml >named.yaml
clean 2 "unknown technique 'no\\u001b[2Jne'" "$program" plan named.yaml
sed 's/^measure/"me\\e[2Jasure"/' config.yaml >keys.yaml
clean 2 "unknown key 'me\\u001b[2Jasure'" "$program" plan keys.yaml
printf 'v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n' >"m$esc.obj"
cp "m$esc.obj" "m$c1.obj"
sed 's/scenes: .*/scenes: [{file: "m\\e[2J.obj"}, {name: plane}]/' config.yaml >files.yaml
clean 0 'm\u001b[2J.obj/framed none' "$program" plan files.yaml
clean 0 'm\u001b[2J.obj' "$program" plan files.yaml --json -
clean 2 "rubbish" "$program" shot --technique none --backend null --scene "capture:rubbish$esc.exr"
echo rubbish >"broken$esc.obj"
clean 2 'broken\u001b[2J.obj' "$program" shot --technique none --backend null --size 8x8 --scene "broken$esc.obj"
AOBUDGET_SCENES=$folder clean 0 'm\u009bm.obj' "$program" list scenes
AOBUDGET_SCENES=$folder clean 0 'm\u009bm.obj' "$program" list scenes --json -
check "the JSON is the same text" test "$(AOBUDGET_SCENES=$folder "$program" list scenes --json - | jq -r '.own[] | .name' | grep -c $'^m\302\233m$')" -eq 1
clean 0 'Clears\u001b[2J the screen' "$program" list techniques --module "$control"
check "a sentence of two lines is one" grep -q 'One line and.u001b\]0;title.u0007 more\.' .said
clean 0 'a\u001b[2J' "$program" list techniques --module "$control" --json -
clean 2 "shader 'dim\u001b[2J'" "${shot[@]/none/control}" --module "$control"
sed "s/name: none/name: control/; s/scenes: .*/scenes: [{file: \"m\\\\e[2J.obj\"}]/" config.yaml >control.yaml
clean 2 "nothing could run" "$program" run control.yaml --out control --module "$control"
script -qec "stty cols 200; '$program' run files.yaml --out files" /dev/null | sed 's/\x1b\[K//g; s/\r//g' >.said
check "nor does the progress hold any" hold_no_control .said
check "which names the mesh" grep -qF 'm\u001b[2J.obj/framed' .said
finish
