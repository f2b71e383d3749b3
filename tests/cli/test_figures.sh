#!/usr/bin/env bash
# Images, scores and the identities of cases over all techniques are those of the stored table, to 1e-6: a change that
# should not change them is caught here. `test_figures.sh PROGRAM --write` makes the table anew, for a change that should.
source "$(dirname "$0")/lib.sh"
config=$(realpath "$(dirname "$0")/../figures/figures.yaml")
table=${config%.yaml}.tsv
export AOBUDGET_CACHE=$folder/cache
check "the run" "$program" run "$config" --out "$folder/out" --quiet

# A line a figure: technique, number of the case, name, value.
print_figures() {
  local n=0 key line
  while read -r line; do
    n=$((n + 1))
    key=$(jq -r '.technique' <<<"$line")
    jq -r --arg at "$key $n" '
      def row(name; value): "\($at)\t\(name)\t\(value)";
      . as $r | (["rmse", "band_rmse", "border_rmse", "mae", "bias", "p95", "max", "flip", "ssim", "definition_rmse",
                  "missing_rmse", "estimator_rmse", "reference_se"][] | row(.; $r.error[.])),
      (if $r.error.oracle then row("oracle_rmse"; $r.error.oracle.rmse) else empty end),
      row("memory_bytes"; $r.memory_bytes),
      row("identity"; [$r.scene, $r.view, $r.revision, $r.params, $r.options, $r.camera, $r.definition, $r.spp] | tojson)
      ' <<<"$line"
    read -r mean square across down < <("$AOBUDGET_BUILD/image_moments" "$folder/out/$(jq -r .image <<<"$line")" technique.AO)
    printf '%s\t%s\t%s\n' "$key $n" mean "$mean" "$key $n" mean_square "$square" "$key $n" mean_across "$across" \
      "$key $n" mean_down "$down"
  done <"$folder/out/journal.jsonl"
}
print_figures >"$folder/figures.tsv"

# What the drivers' and the tracer's compilers may use decides the last bits.
sets=$(grep -m1 '^flags' /proc/cpuinfo | grep -owE 'avx512f|avx2|fma' | sort -u | tr '\n' ' ')
if [ "${2:-}" = --write ]; then
  { echo "# processor: $sets"; cat "$folder/figures.tsv"; } >"$table"
  exit
fi
bar=1e-6
if ! grep -qxF "# processor: $sets" "$table"; then
  echo "the table is of a processor with other instruction sets than '$sets': compared to 1e-3 only"
  bar=1e-3
fi
check "the table has at least 200 figures" test "$(grep -vc -e '^#' -e identity "$table")" -ge 200
check "every figure is the table's, to $bar" awk -F '\t' -v bar=$bar '
  /^#/ { next }
  NR == FNR { stored[$1 FS $2] = $3; left++; next }
  !(($1 FS $2) in stored) { print "not in the table: " $0; bad = 1; next }
  { left--; was = stored[$1 FS $2]
    number = was ~ /^-?[0-9.e+-]+$/ && $3 ~ /^-?[0-9.e+-]+$/
    if (number ? (was - $3) ^ 2 > bar ^ 2 : was != $3) { print $1, $2 ": was " was ", is " $3; bad = 1 } }
  END { if (left) { print left " figures are gone"; bad = 1 } exit bad }' "$table" "$folder/figures.tsv"
finish
