#!/usr/bin/env bash
# check.sh ROOT TESTS: whether the mutants of a tree can be tried: each patch applies, says its fault, a test that TESTS
# lists, and what that test says when it fails; each room of the harness and of the reports, and each technique, has one.
# One line a finding; exit code 1 if there is one.
tests=$(realpath "$2")
cd "$1"
bad=0
complain() { echo "mutants: $1"; bad=1; }
field() { sed -n "s/^$1: //p" "$2" | head -n 1; }
export GIT_CEILING_DIRECTORIES=$PWD/..

for patch in tests/mutants/*.patch; do
  git apply --check "$patch" 2>/dev/null || complain "$patch does not apply: change it with the code"
  [ -n "$(field Fault "$patch")" ] || complain "$patch has no line 'Fault: ' that says what it plants"
  grep -qxF -- "$(field Test "$patch")" "$tests" || complain "$patch: there is no test '$(field Test "$patch")'"
  says=$(field Says "$patch")
  [ -n "$says" ] && grep -rqF --exclude-dir=mutants -- "$says" tests ||
    complain "$patch: no test says '$says'"
done

# planted FOLDER...: a patch changes a file that lies in one of them, and in no folder below.
planted() {
  local folder
  for folder in "$@"; do
    grep -lqE "^\+\+\+ b/$folder/[^/]*$" tests/mutants/*.patch && return
  done
  complain "$1 has no mutant"
}
for room in harness/*/ harness/gpu/*/ reports/*/; do
  planted "${room%/}"
done
for technique in techniques/*/; do
  name=$(basename "$technique")
  planted "techniques/$name" "shaders/$name"
done
exit $bad
