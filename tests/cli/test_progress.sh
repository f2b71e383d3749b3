#!/usr/bin/env bash
# What a person sees at a terminal while a run goes on: what it does now, what is done, no line wider than the terminal; and
# nothing of it where standard error is no terminal, or with --quiet.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
cat >config.yaml <<END
name: progress
scenes: [{name: corner}, {name: plane}]
resolutions: [32x18]
backends: ["null"]
techniques: [{name: none}, {name: gtao, sweep: [{param: radius, values: [0.25, 0.5]}]}]
measure: {time: false, images: false}
reference: {spp: 2}
END
shown() { # COLUMNS FLAGS...: the lines of a terminal so wide
  local columns=$1
  shift
  script -qec "stty cols $columns; '$program' run config.yaml --fresh $*" /dev/null | tr '\r' '\n' | sed 's/\x1b\[K//g' | grep '^\['
}
shown 200 >wide
check "the first line says what is waited for" test "$(head -1 wide)" = "[0/6] tracing: corner/front none"
check "then what is measured" test "$(sed -n 2p wide)" = "[0/6] compiling and measuring: corner/front none"
check "each case is named by what tells it apart" grep -qxE '\[3/6\] [0-9]+:[0-9]{2} left  corner/front gtao radius=0.5' wide
check "each case once" test "$(grep -cE '^\[[1-6]/6\] [0-9]+:[0-9]{2} left  (corner|plane)/front' wide)" -eq 6
check "the page comes last" test "$(tail -1 wide | sed 's/[0-9]*:[0-9]* left/T left/')" = "[6/6] T left  drawing the page"
shown 30 >narrow
check "no line is wider than the terminal" test "$(awk '{ if (length($0) > m) m = length($0) } END { print m }' narrow)" -le 29
check "nor cut where it need not be" test "$(awk '{ if (length($0) > m) m = length($0) } END { print m }' narrow)" -eq 29
check "nothing if --quiet" test -z "$(shown 80 --quiet)"
expect 0 "6 cases: 6 ok" "$program" run config.yaml --fresh # standard error is a file: one line, the summary

# With a budget what fits best so far stands under it, and goes with it.
printf 'title: a frame\nsource: made up\nframe: 1000\n' >frame.yaml
sed 's/time: false/time: true, seconds: 0.05/; s/^name: .*/&\nbudget: .\/frame.yaml/' config.yaml >budget.yaml
below() { # COLUMNS: all that the terminal gets, escapes as they are
  script -qec "stty cols $1; '$program' run budget.yaml --fresh" /dev/null | tr -d '\r'
}
below 200 >under
check "it is cleared with all lines below" grep -qF $'\e[J[1/6] ' under
check "nothing fits before the first case does" grep -qxF "1000 ms: nothing fits yet, against the truth within 0.25 scene units" under
check "then a case of the scene and view" grep -qE "^1000 ms: error [0-9.]+, [0-9.]+ \([0-9.]+ \.\. [0-9.]+\) ms: plane/front gtao radius=0.25, against the truth within 0.25 scene units$" under
check "the cursor goes back to the end of the line above" grep -qE $'\e\\[2A\e\\[[0-9]+C' under
below 40 >slim
check "no line below is wider either" test "$(grep '^1000 ms' slim | sed $'s/\e.*//' | awk '{ if (length($0) > m) m = length($0) } END { print m }')" -le 39
check "what stood there last is what the finished run answers" test "$(grep -oE 'error [0-9.]+, .* ms: plane/front gtao radius=0.25, against the truth within 0.5' under | tail -1 | grep -oE 'error [0-9.]+')" = \
  "error $("$program" budget results/progress --scene plane --target 0.5 --json - | jq -r '.questions[0].accurate.error' | xargs printf '%.4f')"
check "the page has it" grep -q '<section id=budget><h2>Budget <small>a frame</small>' results/progress/report/index.html
# The page is of the budget that the run has now, also where nothing is measured anew.
sed -i 's/a frame/another frame/' frame.yaml
"$program" run budget.yaml --quiet
check "a new budget is drawn" grep -q '<section id=budget><h2>Budget <small>another frame</small>' results/progress/report/index.html
touch -d '2001-01-01' results/progress/journal.jsonl
cp -p results/progress/report/index.html before.html
"$program" run budget.yaml --quiet
check "the same one is not" test results/progress/report/index.html -ot before.html -o ! results/progress/report/index.html -nt before.html
# What no case can have is said before the first one is measured.
printf 'device: nosuch\n' | cat frame.yaml - >device.yaml
sed 's/frame.yaml/device.yaml/' budget.yaml >ask.yaml
expect 0 "ask.yaml:2:9: the budget is of 'nosuch', and no time will be modelled on that" "$program" plan ask.yaml --quiet
printf 'resolution: 9x9\n' | cat frame.yaml - >size.yaml
sed 's/frame.yaml/size.yaml/' budget.yaml >ask.yaml
expect 0 "ask.yaml:2:9: the budget is of 9x9, and no case has that size" "$program" plan ask.yaml --quiet
check "nor is anything where all can be had" test -z "$("$program" plan budget.yaml --quiet 2>&1 >/dev/null)"
sed 's/frame.yaml/nosuch.yaml/' budget.yaml >lost.yaml
expect 2 "lost.yaml:2:9: ./nosuch.yaml: cannot open" "$program" plan lost.yaml
finish
