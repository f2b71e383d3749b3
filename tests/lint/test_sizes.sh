#!/usr/bin/env bash
# A file of 401 lines and a function of 41 are found, by their names; one of 400, one of 40 and a long table are not.
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder"/{include,harness,reports,techniques,shaders,tests,cmake,examples}
failures=0
lines() { for ((i = 0; i < $1; i++)); do echo "$2"; done; }
try() { # WHAT EXPECTED: the lines that sizes.sh prints, or nothing
  local said
  said=$(bash "$here/sizes.sh" "$folder") && [ -n "$2" ] && said="passed: $said"
  [ "$said" = "$2" ] || { echo "FAILED: $1: expected '$2', got '$said'"; failures=$((failures + 1)); }
  rm -f "$folder"/*/planted.*
}
lines 400 '/* */' >"$folder/harness/planted.c"
try "a file of 400 lines" ""
lines 401 '/* */' >"$folder/harness/planted.c"
try "a file of 401 lines" "lint: harness/planted.c has 401 lines: split it by noun"
lines 401 '/* */' >"$folder/shaders/planted.glsl"
try "a shader of 401 lines" "lint: shaders/planted.glsl has 401 lines: split it by noun"
lines 400 '/* */' >"$folder/tests/planted.c"
try "a test of 400 lines" ""
lines 401 '/* */' >"$folder/tests/planted.c"
try "a test of 401 lines" "lint: tests/planted.c has 401 lines: split it by noun"
{ echo 'void f(void)'; echo '{'; lines 40 '    g();'; echo '}'; } >"$folder/reports/planted.c"
try "a function of 40 lines" ""
{ echo 'void f(void)'; echo '{'; lines 41 '    g();'; echo '}'; } >"$folder/reports/planted.cpp"
try "a function of 41 lines" "lint: reports/planted.cpp:2: a function of 41 lines: split it"
{ echo 'static void test(void **state)'; echo '{'; lines 40 '    g();'; echo '}'; } >"$folder/tests/planted.c"
try "a test function of 40 lines" ""
{ echo 'static void test(void **state)'; echo '{'; lines 41 '    g();'; echo '}'; } >"$folder/tests/planted.c"
try "a test function of 41 lines" "lint: tests/planted.c:2: a function of 41 lines: split it"
{ echo 'static const int table[] = {'; lines 60 '    1,'; echo '};'; } >"$folder/techniques/planted.c"
try "a table of 60 lines" ""
[ $failures -eq 0 ] && echo "all sizes are held"
exit $((failures > 0))
