#!/usr/bin/env bash
# Resuming over each status: what has a verdict stands, what failed or had no driver is tried again, and a folder of another
# build, another config or of none is left alone. The journal is written for the purpose: of six cases each has another one.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
cat >config.yaml <<EOF
name: statuses
scenes: [{name: corner}]
resolutions: [16x9]
backends: [null]
techniques: [{name: gtao, sweep: [{param: slices, values: [1, 2, 3, 4, 5, 6]}]}]
measure: {seconds: 0.01, images: false}
reference: {spp: 2}
EOF
check "a run" "$program" run config.yaml --out out --quiet
cp -r out first
slices() { jq -r "select($1) | .params.slices" out/journal.jsonl | sort -n | paste -sd' '; }
check "six cases" test "$(slices true)" = "1 2 3 4 5 6"

# say NUMBER STATUS [FILTER]: the record of a case, with another status; what does not have one has no figures.
say() { jq -c "select(.params.slices == $1) | .status = \"$2\" | .marked = true | ${3:-.}" first/journal.jsonl; }
write() {
  rm -rf out && cp -r first out
  {
    say 1 ok
    say 2 invalid 'del(.errors, .error)'
    say 3 failed 'del(.errors, .error, .time)'
    say 4 unsupported 'del(.errors, .error, .time)'
    say 5 ok 'del(.time)'
    say 6 ok 'del(.errors, .error)'
  } >out/journal.jsonl
}
write
check "it goes on; one case is invalid" test "$("$program" run config.yaml --out out --quiet >/dev/null 2>&1 || echo $?)" = 3
check "what had a verdict stands alone" test "$(jq -s 'group_by(.params.slices) | map(length) | join(" ")' out/journal.jsonl)" = '"1 1 2 2 2 2"'
check "measured again" test "$(slices '.marked | not')" = "3 4 5 6"
check "all of it is ok now" test "$(slices '(.marked | not) and .status == "ok"')" = "3 4 5 6"
cp out/journal.jsonl whole.jsonl
check "nothing is left to do" test "$("$program" run config.yaml --out out --quiet >/dev/null 2>&1 || echo $?)" = 3
check "and nothing was done" cmp out/journal.jsonl whole.jsonl

# The last record of a case counts, be it the worse one.
write
say 1 failed >>out/journal.jsonl
"$program" run config.yaml --out out --quiet >/dev/null 2>&1
check "a failure behind a verdict is tried again" test "$(slices '.marked | not')" = "1 3 4 5 6"

# What is not wanted is not missed.
sed 's/seconds: 0.01/time: false/' config.yaml >untimed.yaml
write
check "a plan without times" "$program" run untimed.yaml --out untimed --quiet
cp untimed/run.json out/run.json
"$program" run untimed.yaml --out out --quiet >/dev/null 2>&1
check "a record without a time stands there" test "$(slices '.marked | not')" = "3 4 6"

# What failed or had no driver is no verdict, though no figure that is wanted is missing.
sed 's/seconds: 0.01/time: false, error: false/' config.yaml >neither.yaml
write
check "a plan without figures" "$program" run neither.yaml --out neither --quiet
jq -s 'map(.key)' neither/journal.jsonl >keys.json
jq -c --slurpfile keys keys.json '.key = $keys[0][.params.slices - 1]' out/journal.jsonl >renamed.jsonl
mv renamed.jsonl out/journal.jsonl
cp neither/run.json out/run.json
"$program" run neither.yaml --out out --quiet >/dev/null 2>&1
check "failures are tried again there" test "$(slices '.marked | not')" = "3 4"

# Another build, another config, no description: nothing is touched.
for spoil in '.build = "0"' 'del(.build)' '.config_hash = "0"' 'del(.config_hash)'; do
  write
  jq "$spoil" first/run.json >out/run.json
  cp out/run.json spoilt.json
  cp out/journal.jsonl whole.jsonl
  case $spoil in *build*) text="a run of another build of this program" ;; *) text="a run of another config" ;; esac
  expect 2 "out holds $text" "$program" run config.yaml --out out --quiet
  check "with $spoil the journal stands" cmp out/journal.jsonl whole.jsonl
  check "with $spoil the description stands" cmp out/run.json spoilt.json
done
check "--fresh discards it" "$program" run config.yaml --out out --fresh --quiet
check "and measures all" test "$(slices '.marked | not')" = "1 2 3 4 5 6"

# A program of other bytes is another build: its own hash is in run.json.
cp "$program" other-program
printf 'x' >>other-program
check "the build is the program's hash" test "$(jq -r .build out/run.json)" != null
expect 2 "out holds a run of another build of this program" ./other-program run config.yaml --out out --quiet
finish
