# Sourced by the command-line tests: $1 is the program. Each check says what it expected.
: "${AOBUDGET_BUILD:?the folder of the build}"
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export AOBUDGET_LOCK=$folder/measure.lock # tests run beside each other, and none of them is about a time
failures=0

# expect CODE 'TEXT' COMMAND...: exit code, exactly one line on standard error that holds TEXT, nothing of a crash.
expect() {
  local code=$1 text=$2 got=0
  shift 2
  "$@" >"$folder/.stdout" 2>"$folder/.stderr" </dev/null || got=$?
  if [ "$got" -ne "$code" ] || ! grep -qF -- "$text" "$folder/.stderr" || [ "$(wc -l <"$folder/.stderr")" -ne 1 ]; then
    echo "FAILED: $*"
    echo "  expected code $code and one line with '$text'; got code $got and:"
    sed 's/^/  | /' "$folder/.stderr"
    failures=$((failures + 1))
  fi
}

# check 'WHAT' COMMAND...: the command must succeed.
check() {
  local what=$1
  shift
  if ! "$@" >"$folder/.stdout" 2>&1; then
    echo "FAILED: $what: $*"
    sed 's/^/  | /' "$folder/.stdout"
    failures=$((failures + 1))
  fi
}

finish() {
  [ "$failures" -eq 0 ] && echo "all checks passed"
  exit $((failures > 0))
}
