#!/usr/bin/env bash
# dev.d/defaults.sh RUN: the page of a run of configs/defaults.yaml, as Markdown. A cell is the bias to the technique's own
# definition; a case that is not ok has its status there, and its reason below.
set -euo pipefail
journal=$1/journal.jsonl
cases=$(jq .cases "$1/run.json")
[ "$(jq -s length "$journal")" -eq "$cases" ] || { echo "defaults.sh: $journal lacks some of $cases cases" >&2; exit 1; }
jq -rs '
  def unique_in_order: reduce .[] as $x ([]; if index([$x]) then . else . + [$x] end);
  def cell: if . == null then "–" elif .status != "ok" then "**" + .status + "**"
            elif (.error.claim_bias | type) != "number" then "ok"
            else .error.claim_bias * 1000 | round | if . == 0 then 0 else . / 1000 end | tostring end;
  [.[].technique] as $all | ($all | unique_in_order) as $techniques |
  (map(.scene + "/" + .view) | unique_in_order) as $places |
  (map({key: (.scene + "/" + .view + " " + .technique), value: .}) | from_entries) as $case |
  "# Every technique at its defaults\n",
  "Written by `./dev docs` from `configs/defaults.yaml`: \($places | length) views of the listed scenes at " +
  "\(.[0].width)x\(.[0].height), \([.[].spp] | unique | map(tostring) | join(" or ")) rays a pixel. What is changed by hand is lost.\n",
  "A number is the mean of the image minus the ray-traced visibility of the technique\u0027s *own* definition: negative is " +
  "darker than it claims. `none` claims nothing. [techniques.md](techniques.md) says what each departs from by design; a " +
  "bias of `alchemy` and `crytek_ssao` is largely of their estimators, which take a disc or a sphere for directions.\n",
  "\(map(select(.status == "ok")) | length) of \(length) cases are ok.\n",
  "| view | " + ($techniques | map("`" + . + "`") | join(" | ")) + " |",
  "|---|" + ($techniques | map("---|") | join("")),
  ($places[] as $p | "| `\($p)` | " + ($techniques | map($case[$p + " " + .] | cell) | join(" | ")) + " |"),
  (map(select(.status != "ok")) | if length > 0 then "", "Not ok:", "",
    (.[] | "- `\(.scene)/\(.view)` `\(.technique)`: \(.status): \(.reason)") else empty end)
' "$journal"
