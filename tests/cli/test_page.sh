#!/usr/bin/env bash
# The page carries its style and script as they stand in the tree, and its cases as a file beside it.
source "$(dirname "$0")/lib.sh"
root=$(realpath "$(dirname "$0")/../../reports/page")
cd "$folder"
mkdir run
echo '{"name": "early", "cases": 1}' >run/run.json
: >run/journal.jsonl
"$program" report run --quiet
sed -n '/^<style>$/,/^<\/style>/p' run/report/index.html | sed '1d;$d' >style.css
sed -n '/<script>$/,/^<\/script>/p' run/report/index.html | sed '1d;$d' >script.js
check "the style sheet" cmp style.css "$root/style.css"
check "the script" cmp script.js "$root/script.js"
check "the names of the columns" grep -q '^key,series,.*,rmse,.*,missing_estimator' run/report/cases.csv
finish
