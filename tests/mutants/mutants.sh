#!/usr/bin/env bash
# mutants.sh [NAME...]: plants each fault of tests/mutants/*.patch, or the named ones, into a copy of the tree, and runs the
# test that must find it. `./dev mutants` calls this. Exit code: 0 all were killed, 1 not all, 2 they cannot be tried.
#
# The copy holds what git knows, uncommitted changes included; it stays in build/mutants, so that the next call builds only
# what has changed since. The tree itself is only read.
set -uo pipefail
cd "$(dirname "$0")/../.."
copy=$PWD/build/mutants
build=$copy/build/release
log=$PWD/build/log/mutants.log
export GIT_CEILING_DIRECTORIES=$PWD/build # for git apply the copy is no part of this repository

give_up() { echo "mutants: $1" >&2; exit 2; }

field() { sed -n "s/^$1: //p" "$2" | head -n 1; }

choose_patches() { # NAME...
  local name
  patches=()
  for name in "$@"; do
    name=tests/mutants/$(basename "$name" .patch).patch
    [ -f "$name" ] || give_up "there is no $name"
    patches+=("$name")
  done
  [ $# -gt 0 ] || patches=(tests/mutants/*.patch)
  [ -f "${patches[0]}" ] || give_up "there is no patch in tests/mutants"
}

# Files are compared by content: a newer file of the same content is not built again, an older one of another content is.
copy_tree() {
  local file
  mkdir -p "$copy"
  git ls-files -z --cached --others --exclude-standard >"$copy.list" || give_up "git cannot list the files of $PWD"
  while IFS= read -r -d '' file; do
    [ -f "$file" ] || continue
    cmp -s "$file" "$copy/$file" && continue
    mkdir -p "$(dirname "$copy/$file")" && cp "$file" "$copy/$file" && touch "$copy/$file"
  done <"$copy.list"
  (cd "$copy" && find . -path ./build -prune -o -type f -printf '%P\0') | sort -z >"$copy.there"
  sort -z "$copy.list" | comm -z -13 - "$copy.there" | (cd "$copy" && xargs -0r rm -f --)
  rm -f "$copy.list" "$copy.there"
}

configure() {
  (cd "$copy" && cmake --preset release) >"$log" 2>&1 || give_up "the copy cannot be configured: see $log"
}

# What is built for a test: the program with its modules, and the test itself where that is a program.
build_for() { # TEST...
  local targets=(command_line) test
  for test in "$@"; do
    targets+=("$(awk -v t="$test" '$1 == t && $2 != "bash" { print $2 }' "$build/tests.txt")")
  done
  (cd "$copy" && cmake --build --preset release --target $(printf '%s\n' "${targets[@]}" | sort -u) -- --quiet) >"$log" 2>&1
}

# What an earlier program traced into the cache must not serve this one.
passes() { # TEST
  rm -rf "$build/cache"
  ctest --test-dir "$build" -R "^$1\$" --no-tests=error --output-on-failure >"$log" 2>&1
}

patch() { (cd "$copy" && git apply "$@") >"$log" 2>&1; } # [-R] FILE

try() { # PATCH TEST: prints the verdict
  patch "$PWD/$1" || { echo "does not apply"; return; }
  if ! build_for "$2"; then
    echo "does not build"
  elif passes "$2"; then
    echo SURVIVED
  elif grep -FA 1 FAILED "$log" | grep -qF -- "$(field Says "$1")"; then # some tests say what they expected a line below
    echo killed
  else
    echo "not said" # it failed, but not where the patch says
  fi
  [ -f "$log" ] && cp "$log" "${log%.log}-$(basename "$1" .patch).log"
  patch -R "$PWD/$1" || give_up "cannot take $1 back in $copy"
}

choose_patches "$@"
mkdir -p build/log
start=$SECONDS
copy_tree
configure
tests=$(for p in "${patches[@]}"; do field Test "$p"; done | sort -u)
echo "mutants: building $copy" >&2
build_for $tests || give_up "the tree does not build: see $log"
declare -A sound
for test in $tests; do
  passes "$test" && sound[$test]=yes
done

killed=0
printf '%-34s %-36s %-14s %s\n' mutant test verdict seconds
for p in "${patches[@]}"; do
  test=$(field Test "$p") before=$SECONDS
  verdict="fails without" # the test, so it proves nothing
  [ "${sound[$test]:-}" ] && verdict=$(try "$p" "$test")
  [ "$verdict" = killed ] && killed=$((killed + 1))
  printf '%-34s %-36s %-14s %s\n' "$(basename "$p" .patch)" "$test" "$verdict" "$((SECONDS - before))"
done
echo "mutants: $killed of ${#patches[@]} killed in $((SECONDS - start)) s"
[ "$killed" -eq ${#patches[@]} ]
