#!/usr/bin/env bash
# The split of an error in a record: its parts make up the whole, and say of a frame what a capture of it says.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
cat >config.yaml <<END
name: split
scenes: [{name: atrium}, {name: corner}]
resolutions: [96x54]
backends: [gl-egl]
techniques:
  - {name: none}
  - {name: gtao, params: {blur: 0}, sweep: [{param: radius, values: [0.5, 1]}]}
  - {name: alchemy}
measure: {time: false}
reference: {spp: 64}
END
check "a run" "$program" run config.yaml --out out --quiet
for thickness in 0 0.25 inf; do
  sed "s/spp: 64/spp: 64, thickness: $thickness/" config.yaml >with.yaml
  check "thickness $thickness" "$program" run with.yaml --out "with-$thickness" --quiet
done
sed 's/spp: 64/spp: 64, thickness: -1/' config.yaml >bad.yaml
expect 2 "-1 is outside 0 .. inf" "$program" plan bad.yaml

# number FILE LINE PATH: of a journal's record.
number() { sed -n "$2p" "$1" | jq ".$3"; }
awk_check() { check "$1" awk "BEGIN { exit !($2) }"; }
for run in out with-0 with-0.25 with-inf; do
  for line in 2 3 4 6 7 8; do
    whole=$(number $run/journal.jsonl $line error.rmse)
    d=$(number $run/journal.jsonl $line error.definition_rmse)
    m=$(number $run/journal.jsonl $line error.missing_rmse)
    e=$(number $run/journal.jsonl $line error.estimator_rmse)
    dm=$(number $run/journal.jsonl $line error.covariance.definition_missing)
    de=$(number $run/journal.jsonl $line error.covariance.definition_estimator)
    me=$(number $run/journal.jsonl $line error.covariance.missing_estimator)
    awk_check "$run, line $line: the parts are the whole" \
      "($whole^2 - ($d^2 + $m^2 + $e^2 + 2 * ($dm + $de + $me)))^2 <= (0.01 * $whole^2)^2"
  done
  # more radius, same view: the truth's definition is the truth itself
  awk_check "$run: gtao claims the truth" "$(number $run/journal.jsonl 2 error.definition_rmse) == 0"
  awk_check "$run: alchemy does not" "$(number $run/journal.jsonl 4 error.definition_rmse) > 0.01"
done
check "none claims nothing" grep -q '"estimator_rmse":null' out/journal.jsonl

# The bound ends with the guard band, so one run's bands must not share it: each says what a run of its own says.
cat >band.yaml <<END
name: band
scenes: [{name: corner}]
resolutions: [96x54]
backends: [gl-egl]
options: {guard_band: [0, 32]}
techniques: [{name: gtao, params: {radius: 1, blur: 0}}]
measure: {time: false}
reference: {spp: 32}
END
sed 's/\[0, 32\]/32/' band.yaml >alone.yaml
check "two bands" env AOBUDGET_CACHE="$folder/cache-both" "$program" run band.yaml --out both --quiet
check "the wider alone" env AOBUDGET_CACHE="$folder/cache-alone" "$program" run alone.yaml --out alone --quiet
for part in missing_rmse estimator_rmse; do
  awk_check "$part of a guard band does not depend on the run's others" \
    "$(number both/journal.jsonl 2 error.$part) == $(number alone/journal.jsonl 1 error.$part)"
done
awk_check "less is missing with a guard band" \
  "$(number both/journal.jsonl 2 error.missing_rmse) < $(number both/journal.jsonl 1 error.missing_rmse)"

# What draws the scene's triangles is not bound to the screen: nothing is missing, and falloff 1 has its own truth.
check "volumes" "$program" shot --technique ao_volumes --scene corner --size 160x90 --backend gl-egl --reference-spp 128 \
  -p radius=1 -p falloff=1 -p divisor=1 --json volumes.json
awk_check "nothing is missing to volumes" "$(jq .error.missing_rmse volumes.json) == 0"
awk_check "their taper is traced" "$(jq .error.estimator_rmse volumes.json) < 0.005 && $(jq .error.definition_rmse volumes.json) > 0.01"
check "by the triangles' distance" test "$(jq -r .definition.distance volumes.json)" = triangle

# The same frame as a capture: its only reference is the bound, so its whole error is the frame's estimator error.
shot=("$program" shot --technique gtao --backend gl-egl --reference-spp 64 -p blur=0)
check "a frame" "${shot[@]}" --scene atrium --size 160x90 --out F.exr --json frame.json
check "its capture" "${shot[@]}" --scene capture:F.exr --json capture.json
estimator=$(jq .error.estimator_rmse frame.json)
whole=$(jq .error.rmse capture.json)
awk_check "a capture's error $whole is the frame's estimator error $estimator" "($whole - $estimator)^2 < 1e-12"
awk_check "and nothing of it is missing" "$(jq .error.missing_rmse capture.json) == 0"
finish
