#!/usr/bin/env bash
# Kinds of evil technique in one sweep with good ones: each costs its own cases only, and is named.
source "$(dirname "$0")/lib.sh"
cd "$folder"
modules=$AOBUDGET_BUILD/tests/modules
ln -s "$modules/evil.so" modules.so
cat >config.yaml <<EOF
name: evil
scenes: [{name: corner}]
resolutions: [96x54]
backends: [gl-egl]
techniques: [{name: gtao}, {name: evil_crash}, {name: evil_loop}, {name: evil_growth}, {name: evil_exit}, {name: evil_graph},
  {name: evil_black}, {name: evil_white}, {name: evil_constant}, {name: evil_nan}, {name: evil_shader}, {name: evil_flood},
  {name: evil_words}, {name: alchemy},
  {name: hbao}, {name: none}]
measure: {seconds: 0.05, images: false}
reference: {spp: 32}
EOF
expect 3 "16 cases: 4 ok, 0 unsupported, 5 invalid, 7 failed" "$program" run config.yaml --out out --module "$modules/evil.so"
named() { # TECHNIQUE STATUS 'REASON'
  check "$1 is $2: $3" grep -qE "\"technique\":\"$1\".*\"status\":\"$2\",\"reason\":\"[^\"]*($3)" out/journal.jsonl
}
for good in gtao alchemy hbao none; do named $good ok ''; done
named evil_crash failed 'crashed|SEGV'
named evil_loop failed 'took longer than 10[.0-9]* s of work'
named evil_growth failed '.'
named evil_exit failed 'without an answer'
named evil_graph invalid 'no texture of this graph'
named evil_black invalid 'draws nothing: 0 in 98 % of the pixels'
named evil_white invalid 'draws nothing: 1 in 98 % of the pixels'
named evil_constant invalid 'draws nothing: 0.69970'
named evil_nan invalid 'must be finite'
named evil_shader failed 'syntax error|unexpected'
named evil_words failed 'error: caf\\\\xe9 \\\\u001b\[1m'
named evil_flood failed 'wrote a line of more than 16 MiB on standard error, and was stopped'
check "no process is left over" test -z "$(pgrep -f "^$program worker")"
# What a module does to its process is done to its neighbours too: to all that share its worker, in this order.
cat >shared.yaml <<EOF
name: shared
scenes: [{name: corner}]
resolutions: [96x54]
backends: [gl-egl]
techniques: [{name: evil_limits}, {name: evil_folder}, {name: evil_shader}, {name: none}, {name: hbao}]
measure: {seconds: 0.05}
reference: {spp: 32}
EOF
mkdir here && cd here
AOBUDGET_CACHE=cache expect 3 "5 cases: 3 ok, 0 unsupported, 0 invalid, 2 failed" \
  "$program" run ../shared.yaml --out out --module "../modules.so"
named evil_limits failed 'Too many open files|nable to open|cannot open'
named evil_shader failed 'syntax error|unexpected'
for good in evil_folder none hbao; do named $good ok ''; done
check "every image is in its place" test "$(jq -rs '.[] | select(.status == "ok") | .image' out/journal.jsonl | xargs -I{} ls out/{} | wc -l)" -eq 3
cd ..
if [ -n "${AOBUDGET_SANITIZED:-}" ]; then
  expect 2 "heap-buffer-overflow" "$program" shot --technique overflow --scene plane --backend null --size 8x8 --module "$modules/overflow.so"
fi
finish
