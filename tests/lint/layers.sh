#!/usr/bin/env bash
# layers.sh [ROOT]: the house's walls. A file includes its own room and rooms of lower layers only; a room that is not in
# the table below is no room. One line a breach; exit code 1 if there is one.
cd "${1:-$(dirname "$0")/../..}"
files=$(find include harness reports techniques -name '*.[ch]' -o -name '*.[ch]pp' | sort)
grep -HnoE '^[[:space:]]*#[[:space:]]*include[[:space:]]*["<][^">]+[">]' $files | awk -v files="$files" '
  BEGIN {
    split("include/aobudget 0  harness/base 0  harness/config 1  harness/technique 1  harness/scene 2  harness/gpu 2  harness/profile 2  harness/budget 2 " \
          "harness/plan 3  harness/reference 3  harness/shader 3  harness/store 3  harness/gbuffer 4  harness/history 4  harness/job 4  harness/frame 5 " \
          "harness/score 5  reports/page 5  harness/timing 6  reports/trend 6  harness/run 7  harness/worker 7  harness/papers 8  harness/compare 8  harness/merge 8  harness/stress 8  harness/effects 8  harness/tune 8 " \
          "harness/nightly 9  harness/command 10  harness 11", words, " ")
    for (i = 1; i in words; i += 2) layer[words[i]] = words[i + 1]
    only["reports/plot"] = "harness/base harness/store" # programs of their own
    only["harness/gpu_check"] = "harness/base harness/technique harness/scene harness/gpu harness/store " \
                                "harness/gbuffer harness/frame harness/timing"
    n = split(files, list, "\n")
    for (i = 1; i <= n; i++) { exists[list[i]] = 1; if (room(list[i]) == "") complain(list[i] " is in no room of the table in tests/lint/layers.sh") }
  }
  function complain(text) { print "lint: " text; bad = 1 }
  function folder(path) { sub(/\/[^\/]*$/, "", path); return path }
  # The room of a file; backends are in rooms within gpu, a technique in its own.
  function room(path, at) {
    at = folder(path)
    if (at ~ /^harness\/gpu\/(vulkan|gl|null)$/) return "harness/gpu"
    if (at ~ /^techniques\/[a-z0-9_]+$/) return at
    return at in layer || at in only ? at : ""
  }
  function target(from, name, i, roots) { # the file of ours that is meant, or ""
    split(folder(from) " include harness . techniques", roots, " ")
    for (i = 1; i in roots; i++) {
      path = roots[i] == "." ? name : roots[i] "/" name
      if (path in exists) return path
    }
    return ""
  }
  function may(from, to, words) {
    if (from == to || to == "include/aobudget") return 1
    if (from ~ /^techniques\//) return 0
    if (from in only) { split(only[from], words, " "); for (i in words) if (words[i] == to) return 1; return 0 }
    return to in layer && layer[to] < layer[from]
  }
  {
    split($0, part, ":")
    from = part[1]
    name = $0
    sub(/^[^:]*:[0-9]+:[[:space:]]*#[[:space:]]*include[[:space:]]*["<]/, "", name)
    sub(/[">]$/, "", name)
    to = target(from, name)
    if (name ~ /\.\./) complain(from ":" part[2] ": includes " name ": write it from the root of the includes")
    if (to != "" && !may(room(from), room(to))) complain(from ":" part[2] ": includes " name ", which is not in a room below it")
    if (to ~ /^harness\/gpu\/(vulkan|gl|null)\// && folder(to) != folder(from)) complain(from ":" part[2] ": includes " name ", which is a backend'"'"'s own")
  }
  END { exit bad }'
