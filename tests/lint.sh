#!/usr/bin/env bash
# What a reviewer would otherwise have to watch: layers, sizes, shader bodies, formatting.
cd "$(dirname "$0")/.."
bad=0
complain() { echo "lint: $1"; bad=1; }

layer() { # of a path below harness/
  case $1 in
    base/*) echo 0 ;;
    config/* | technique/*) echo 1 ;;
    scene/* | gpu/*) echo 2 ;;
    plan/* | reference/* | store/*) echo 3 ;;
    frame/*) echo 4 ;;
    measure/*) echo 5 ;;
    main.c) echo 8 ;;
    *) echo 7 ;;
  esac
}

while IFS=: read -r file included; do
  from=${file#harness/}
  [ -f "harness/$included" ] || continue
  if [ "$(dirname "$from")" != "$(dirname "$included")" ] && [ "$(layer "$included")" -ge "$(layer "$from")" ]; then
    case "$from $included" in
      gpu/*" gpu/"*) ;;
      *) complain "$file includes $included, which is not below it" ;;
    esac
  fi
done < <(grep -rnoE '^#include "[^"]+"' harness --include='*.[ch]' | sed -E 's/^([^:]+):[0-9]+:#include "([^"]+)"/\1:\2/')

while read -r file; do
  complain "$file: a technique includes include/ and its own texts only"
done < <(grep -rlE '#include "' techniques | xargs -r grep -lE '#include "(base|technique|gpu|frame|scene|reference|store|measure)/')

while read -r hit; do
  complain "$hit: a shader body never says #version, layout or binding"
done < <(grep -rnE '^\s*(#version|layout\s*\()' shaders)

while read -r lines file; do
  limit=400
  [[ $file == tests/* ]] && limit=600 # one body run over every backend stays together
  [ "$file" != total ] && [ "$lines" -gt $limit ] && complain "$file has $lines lines: split it"
done < <(git ls-files '*.c' '*.h' '*.cpp' '*.hpp' '*.glsl' | xargs wc -l)

while read -r hit; do
  complain "$hit: unfinished"
done < <(git grep -nIE '\b(TODO|FIXME|XXX|HACK)\b' -- '*.c' '*.h' '*.cpp' '*.glsl' '*.md' '*.yaml')

while read -r file; do
  complain "$file: run ./dev format"
done < <(git ls-files '*.c' '*.h' '*.cpp' '*.hpp' | xargs clang-format --dry-run 2>&1 | sed -nE 's/^([^:]+):.*warning.*/\1/p' | sort -u)
[ $bad -eq 0 ] && echo "lint: clean"
exit $bad
