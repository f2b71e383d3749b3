#!/usr/bin/env bash
# What ./dev fuzz says, with targets of our own that write what libFuzzer writes, and with a cmake, an apt-get and a
# dpkg-query of our own: a copy of ./dev runs whole.
set -u
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tree="$folder/a tree"
mkdir -p "$folder/bin" "$tree/tests/fuzz/corpus/"{calm,wild,mute} "$tree/build/fuzz"
cp -r "$here/../../dev" "$here/../../dev.d" "$tree"
failures=0

fake() { # FILE: the script is on standard input
  { echo '#!/usr/bin/env bash'; cat; } >"$1"
  chmod +x "$1"
}
fake "$folder/bin/dpkg-query" <<'EOS'
shift 2 # -W -f=...
for p in "$@"; do [[ $p == clang ]] || echo "$p install ok installed"; done
EOS
fake "$folder/bin/apt-get" <<<"echo \"\$*\" >>'$folder/apt'"
fake "$folder/bin/id" <<<'echo 0'
fake "$folder/bin/cmake" <<<"echo \"\$*\" >>'$folder/cmake'"
fake "$tree/build/fuzz/calm" <<EOS
printf '%s\n' "\$@" >'$folder/arguments'
echo '#7 NEW cov: 12 ft: 30 corp: 3/9b lim: 4 exec/s: 7 rss: 30Mb'
echo 'stat::number_of_executed_units: 4711'
EOS
fake "$tree/build/fuzz/wild" <<'EOS'
for word in "$@"; do [[ $word == -artifact_prefix=* ]] && echo x >"${word#*=}crash-1"; done
echo '#7 NEW cov: 3 ft: 30 corp: 3/9b lim: 4 exec/s: 7 rss: 30Mb'
echo 'FAILED: all is well'
echo 'SUMMARY: libFuzzer: deadly signal'
echo 'stat::number_of_executed_units: 8'
exit 77
EOS
fake "$tree/build/fuzz/mute" <<<'exit 5'

# says 'WHAT' CODE ARGUMENTS LINE...: what ./dev fuzz ends with, and what it prints on standard output
says() {
  local what=$1 code=$2 got=0 arguments
  read -ra arguments <<<"$3"
  shift 3
  for line in "$@"; do echo "$line"; done >"$folder/expected"
  PATH="$folder/bin:$PATH" bash "$tree/dev" fuzz "${arguments[@]}" >"$folder/said" 2>"$folder/errors" </dev/null || got=$?
  sed -i -E 's/in [0-9]+ s/in N s/; s/ +$//' "$folder/said"
  if [ $got -ne "$code" ] || ! diff "$folder/expected" "$folder/said"; then
    echo "FAILED: $what: exit code $got, expected $code"
    cat "$folder/errors"
    failures=$((failures + 1))
  fi
}
calm='calm          4711 executions in N s, 12 edges: no finding'
says "no finding" 0 "calm 9" "$calm"
for argument in -max_total_time=9 build/fuzz/corpus/calm tests/fuzz/corpus/calm -artifact_prefix=build/fuzz/findings/calm-; do
  grep -qxF -- "$argument" "$folder/arguments" || { echo "FAILED: a target is called with $argument"; failures=$((failures + 1)); }
done
grep -qx -- '--preset fuzz' "$folder/cmake" && grep -qx -- '--build --preset fuzz' "$folder/cmake" ||
  { echo "FAILED: the preset of its own is built"; failures=$((failures + 1)); }
grep -q 'install .* clang$' "$folder/apt" || { echo "FAILED: clang is installed"; failures=$((failures + 1)); }
says "all targets" 1 "" "$calm" \
  'mute               executions in N s,  edges: A FINDING' \
  '  exit code 5 without an input that does it: see build/log/fuzz-mute.log' \
  'wild             8 executions in N s, 3 edges: A FINDING' \
  '  FAILED: all is well' \
  '  SUMMARY: libFuzzer: deadly signal' \
  '  shown again by: build/fuzz/wild build/fuzz/findings/wild-crash-1'
grep -qx -- -max_total_time=60 "$folder/arguments" || { echo "FAILED: a minute each"; failures=$((failures + 1)); }
[ -f "$tree/build/fuzz/findings/wild-crash-1" ] || { echo "FAILED: the input is kept"; failures=$((failures + 1)); }
says "no such target" 2 "nothing"
says "no seconds" 2 "calm 0"

# Only this command needs clang.
rm "$folder/apt"
PATH="$folder/bin:$PATH" bash "$tree/dev" build >/dev/null 2>&1 </dev/null
[ -e "$folder/apt" ] && { echo "FAILED: another command installs clang"; failures=$((failures + 1)); }
[ $failures -eq 0 ] && echo "all checks passed"
exit $((failures > 0))
