#!/usr/bin/env bash
# sizes.sh [ROOT]: no file of more than 400 lines, no function of more than 40, in tests neither. Tables do not count: a
# function is what a line that begins with "{" opens, as .clang-format lays it.
cd "${1:-$(dirname "$0")/../..}"
find include harness reports techniques shaders tests cmake examples -name '*.[ch]' -o -name '*.[ch]pp' -o -name '*.glsl' |
  sort | xargs awk '
    function complain(text) { print "lint: " text; bad = 1 }
    function end_file() {
      if (lines > 400) complain(last " has " lines " lines: split it by noun")
    }
    FNR == 1 { if (last != "") end_file(); last = FILENAME; open = 0 }
    { lines = FNR }
    /^\{$/ { open = FNR }
    /^\}/ && open {
      if ($0 == "}" && FNR - open - 1 > 40)
        complain(FILENAME ":" open ": a function of " FNR - open - 1 " lines: split it")
      open = 0
    }
    END { end_file(); exit bad }'
