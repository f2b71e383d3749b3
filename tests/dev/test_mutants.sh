#!/usr/bin/env bash
# What ./dev mutants says of a fault: a tree of one file, with a cmake and a ctest of our own. The file is the "program"; a
# test passes if it holds the word that the test is about.
set -u
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tree="$folder/a tree"
mkdir -p "$folder/bin" "$tree/tests/mutants"
cp "$here/../mutants/mutants.sh" "$tree/tests/mutants"
export ran="$folder/ran" # one line for each build, with what was built
failures=0

fake() { # NAME: the script is on standard input
  { echo '#!/usr/bin/env bash'; cat; } >"$folder/bin/$1"
  chmod +x "$folder/bin/$1"
}
fake cmake <<'EOS'
if [ "$1" = --preset ]; then
  mkdir -p build/release
  printf 'base/apple test_apple_base\ncli/pear bash\n' >build/release/tests.txt
  exit 0
fi
echo "$* with $(tr '\n' ' ' <fruit)" >>"$ran"
! grep -q broken fruit
EOS
fake ctest <<'EOS'
# ctest --test-dir BUILD -R ^NAME$ ...
name=${4#^*/}
name=${name%$}
grep -q "$name" "$2/../../fruit" || { echo "FAILED: no $name is there"; exit 1; }
EOS

plant() { # NAME TEST SAYS OLD NEW
  cat >"$tree/tests/mutants/$1.patch" <<END
Fault: There is a $5.
Test: $2
Says: $3

--- a/fruit
+++ b/fruit
@@ -1,3 +1,3 @@
 begin
-$4
+$5
 end
END
}
printf 'begin\napple pear\nend\n' >"$tree/fruit"
plant killed base/apple "no apple is there" "apple pear" "pear"
plant survived base/apple "no apple is there" "apple pear" "apple"
plant other cli/pear "no plum is there" "apple pear" "apple"
plant stale base/apple "no apple is there" "plum" "pear"
plant spoilt base/apple "no apple is there" "apple pear" "broken"
plant unsound base/plum "no plum is there" "apple pear" "pear"
echo /build >"$tree/.gitignore"
(cd "$tree" && git init -q . && git add -A) || exit 1

# verdicts 'WHAT' CODE 'NAME VERDICT...' [ARGUMENT...]
verdicts() {
  local what=$1 code=$2 expected=$3 got=0 said
  shift 3
  PATH="$folder/bin:$PATH" bash "$tree/tests/mutants/mutants.sh" "$@" >"$folder/said" 2>"$folder/errors" || got=$?
  said=$(sed -E '1d; s/ +[0-9]+$//; s/ (base|cli)\/[a-z]+ +/ /; s/ +/ /g; s/ in [0-9]+ s$//' "$folder/said" | paste -sd';')
  [ $got -eq "$code" ] && [ "$said" = "$expected" ] && return
  echo "FAILED: $what: code $got, expected $code: $said, expected $expected"
  cat "$folder/errors"
  failures=$((failures + 1))
}
verdicts "one that is found" 0 "killed killed;mutants: 1 of 1 killed" killed
verdicts "all kinds" 1 "killed killed;other not said;spoilt does not build;stale does not apply;survived SURVIVED;unsound fails without;mutants: 1 of 6 killed"
verdicts "a file's name will do" 1 "survived SURVIVED;mutants: 0 of 1 killed" tests/mutants/survived.patch
verdicts "no such mutant" 2 "" nothing
if ! (cd "$tree" && git diff --quiet && cmp fruit build/mutants/fruit); then
  echo "FAILED: the tree or its copy is not as it was"
  failures=$((failures + 1))
fi

# The copy follows the tree: what has changed, what is new, what is gone.
printf 'begin\napple pear\nend\nnew\n' >"$tree/fruit"
echo x >"$tree/one file" && verdicts "after a change" 0 "killed killed;mutants: 1 of 1 killed" killed
cmp -s "$tree/fruit" "$tree/build/mutants/fruit" && [ -f "$tree/build/mutants/one file" ] || { echo "FAILED: the copy is stale"; failures=$((failures + 1)); }
rm "$tree/one file" && verdicts "after a removal" 0 "killed killed;mutants: 1 of 1 killed" killed
[ -e "$tree/build/mutants/one file" ] && { echo "FAILED: the copy keeps what is gone"; failures=$((failures + 1)); }
grep -q 'target command_line test_apple_base -- --quiet with begin pear end new' "$ran" ||
  { echo "FAILED: what a test needs is built with the fault"; failures=$((failures + 1)); }
[ $failures -eq 0 ] && echo "all checks passed"
exit $((failures > 0))
