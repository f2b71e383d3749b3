#!/usr/bin/env bash
# A view that shows no surface has no figures: it is said in one line, and other views go on.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
shot=("$program" shot --technique gtao --backend null --scene plane --size 48x27)
up=(--eye 0,2,4 --target 0,20,4.1)
said="no pixel of the view shows a surface"
expect 2 "$said" "${shot[@]}" "${up[@]}" --reference-spp 16
expect 2 "$said" "${shot[@]}" "${up[@]}" --reference-spp 16
expect 2 "$said" "${shot[@]}" "${up[@]}" --reference-spp 0 --json record.json
check "the record says so" grep -q '"status": "failed"' record.json
check "and has no figure" bash -c '! grep -q rmse record.json'
# What only the guard band shows does not count.
below=(--eye 0,2,4 --target 0,1.95,-2 --fov 20 --shift 0,2)
expect 2 "$said" "${shot[@]}" "${below[@]}" -p guard_band=64 --reference-spp 16
check "one row of a floor is a view" "${shot[@]}" --eye 0,2,4 --target 0,2.5,-2 --fov 20 --reference-spp 16

cat >config.yaml <<END
name: empty
scenes:
  - {name: plane, eye: [0, 2, 4], target: [0, 20, 4.1]}
  - {name: plane, view: front}
resolutions: [48x27]
backends: [null]
techniques: [{name: none}, {name: gtao, params: {slices: [1, 2]}}]
measure: {seconds: 0.05}
reference: {spp: 16}
END
expect 3 "6 cases: 3 ok, 0 unsupported, 0 invalid, 3 failed" "$program" run config.yaml --out out
check "each case of the view has the reason" test "$(grep -c "\"reason\":\"[^\"]*$said" out/journal.jsonl)" -eq 3
check "no figure is no number" bash -c '! grep -q -i nan out/report/cases.csv'
finish
