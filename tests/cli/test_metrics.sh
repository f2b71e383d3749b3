#!/usr/bin/env bash
# docs/design.md has every metric of store/metric.c with its sentence, in that order, and no other.
source "$(dirname "$0")/lib.sh"
design=$(realpath "$(dirname "$0")/../../docs/design.md")
"$AOBUDGET_BUILD/metric_table" >"$folder/table"
sed -n '/^| metric | title | better | is |$/,/^$/p' "$design" | sed '1,2d;/^$/d' >"$folder/docs"
check "there are metrics" test "$(wc -l <"$folder/table")" -ge 10
check "the table in docs/design.md is that of $AOBUDGET_BUILD/metric_table" diff "$folder/table" "$folder/docs"
finish
