#!/usr/bin/env bash
# The list of mutants holds for the tree, and check.sh finds what would let it rot: each is planted into a small tree.
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
cut -d' ' -f1 "${AOBUDGET_BUILD:?the folder of the build}/tests.txt" >"$folder/tests"
bash "$root/tests/mutants/check.sh" "$root" "$folder/tests" || { echo "FAILED: the tree's own mutants"; failures=1; }

small=$folder/small
mkdir -p "$small"/{harness/base,harness/gpu/null,reports/page,techniques/flat,shaders/flat,tests/mutants,tests/base}
echo base/one >"$folder/names"
echo 'void test_one(void);' >"$small/tests/base/test_one.c"
for file in harness/base/a.c harness/gpu/b.c harness/gpu/null/c.c reports/page/d.c shaders/flat/e.glsl; do
  printf 'int before;\nint value = 1;\nint after;\n' >"$small/$file"
  cat >"$small/tests/mutants/$(basename "$file").patch" <<END
Fault: The value is another one.
Test: base/one
Says: test_one

--- a/$file
+++ b/$file
@@ -1,3 +1,3 @@
 int before;
-int value = 1;
+int value = 2;
 int after;
END
done

try() { # WHAT EXPECTED: the one line that check.sh prints, or nothing
  local said
  said=$(bash "$root/tests/mutants/check.sh" "$small" "$folder/names") && [ -n "$2" ] && said="passed: $said"
  [ "$said" = "$2" ] || { echo "FAILED: $1: expected '$2', got '$said'"; failures=$((failures + 1)); }
}
spoil() { # FILE SED EXPECTED
  cp "$small/$1" "$folder/kept"
  sed -i "$2" "$small/$1"
  try "$1 with $2" "$3"
  cp "$folder/kept" "$small/$1"
}
try "a tree with all" ""
spoil harness/base/a.c 's/= 1/= 3/' "mutants: tests/mutants/a.c.patch does not apply: change it with the code"
spoil tests/mutants/a.c.patch '/^Fault/d' "mutants: tests/mutants/a.c.patch has no line 'Fault: ' that says what it plants"
spoil tests/mutants/a.c.patch 's/base.one/base\/two/' "mutants: tests/mutants/a.c.patch: there is no test 'base/two'"
spoil tests/base/test_one.c 's/one/two/' "$(printf 'mutants: tests/mutants/%s.patch: no test says '"'test_one'"'\n' a.c b.c c.c d.c e.glsl)"
for gone in "a.c harness/base" "b.c harness/gpu" "c.c harness/gpu/null" "d.c reports/page" "e.glsl techniques/flat"; do
  read -r name room <<<"$gone"
  mv "$small/tests/mutants/$name.patch" "$folder/kept"
  try "without $name" "mutants: $room has no mutant"
  mv "$folder/kept" "$small/tests/mutants/$name.patch"
done
[ $failures -eq 0 ] && echo "all plants were found"
exit $((failures > 0))
