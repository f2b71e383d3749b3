#!/usr/bin/env bash
# `calibrate`: where the clock is exact nothing is noise; where it is real every figure is there. How large they are is the
# machine's.
source "$(dirname "$0")/lib.sh"
cd "$folder"
check "an exact clock" "$program" calibrate --backend null --technique none --seconds 3 --out null --json null.json
check "has no noise" jq -e '.control.within == 0 and .control.between == 0 and .cost.within == 0 and .recommended == 0.01
  and ([.resolution[].precision] == [0.01, 0.02, 0.03, 0.05, 0.1])' null.json
check "and its device's clock is tested like any other" jq -e '.timer.trusted and all(.timer.checks[]; .low <= .measured and .measured <= .high)' null.json
check "a real clock" "$program" calibrate --technique none --seconds 3 --out real --json real.json
check "has some noise, and a tested clock" jq -e '.control.within > 0 and .cost.within > 0 and .processes >= 3
  and (.timer.checks | length) > 3 and all(.resolution[]; .seconds == null or .seconds > 0)
  and .clean >= 0 and .clean <= 1 and (.fingerprint.device | length) > 0' real.json
"$program" calibrate --backend null --technique none --seconds 3 --out null >table 2>/dev/null
check "the table says what to ask for" grep -qx 'recommended: precision: 1%' table
check "and what the clock is" grep -q '^device clock: ' table
expect 2 "--seconds: '2'" "$program" calibrate --seconds 2
expect 2 "unknown technique 'nothing'" "$program" calibrate --technique nothing --out gone --quiet
expect 2 "unknown backend 'nothing'" "$program" calibrate --backend nothing --out gone --quiet
finish
