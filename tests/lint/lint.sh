#!/usr/bin/env bash
# What a reviewer would otherwise have to watch: layers, sizes, shader bodies, unfinished marks, commit subjects, formatting.
cd "$(dirname "$0")/../.."
bad=0
complain() { echo "lint: $1"; bad=1; }

bash tests/lint/layers.sh || bad=1
bash tests/lint/sizes.sh || bad=1

while read -r hit; do
  complain "$hit: a shader body never says #version, layout or binding"
done < <(grep -rnE '^\s*(#version|layout\s*\()' shaders)

while read -r hit; do
  complain "$hit: unfinished"
done < <(git grep -nIE '\b(TODO|FIXME|XXX|HACK)\b' -- '*.c' '*.h' '*.cpp' '*.glsl' '*.md' '*.yaml' '*.js' '*.css')

while read -r hit; do
  complain "$hit: only base/output.c writes standard output, base/error.c and the progress standard error"
done < <(grep -rnE '\b(v?printf|puts|putchar) *\(|\b(stdout|stderr)\b' harness reports/page reports/trend techniques --include='*.c' |
  grep -vE '^harness/(base/(output|error|memory)|run/progress)\.c:|^[^:]+:[0-9]+: *(/\*|\*)' | cut -d: -f1,2)

# A section that nobody sources prints no row, and so no SHORT either.
while read -r file; do
  grep -qx "source $file" tests/bench/bench.sh || complain "$file: tests/bench/bench.sh does not source it"
done < <(grep -lE '^# Sourced by bench\.sh' tests/bench/*.sh)

# Subjects since the rule was made; a tree without that history has none to look at.
first=fd870c5a
while read -r subject; do
  complain "the commit subject '${subject:0:60}...' has ${#subject} characters: 72 at most, the rest is for the body"
done < <(git log --format=%s "$first..HEAD" 2>/dev/null | grep -E '^.{73,}')

while read -r file; do
  complain "$file: run ./dev format"
done < <(git ls-files '*.c' '*.h' '*.cpp' '*.hpp' | xargs clang-format --dry-run 2>&1 | sed -nE 's/^([^:]+):.*warning.*/\1/p' | sort -u)
[ $bad -eq 0 ] && echo "lint: clean"
exit $bad
