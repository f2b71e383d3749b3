#!/usr/bin/env bash
# `list lights`, and the lights that scenes name.
source "$(dirname "$0")/lib.sh"
root=$(realpath "$(dirname "$0")/../..")
cd "$folder"
check "the lights" "$program" list lights --json lights.json
check "there are three, uniform first" jq -e '[.lights[].name] == ["uniform", "sky", "window"]' lights.json
check "each with its figures" jq -e 'all(.lights[]; (.radiance | length > 0) and .held > 0 and .held <= 1 and
  (.factors | length == 2 and all(. > 0 and . <= 1)) and (.coefficients | length == 9 and all(length == 3)))' lights.json
check "uniform is 1: its coefficient is the square root of 4 pi" jq -e '.lights[0] | .held == 1 and .factors == [1, 1] and
  (.coefficients[0] | all(. > 3.54490 and . < 3.54491)) and (.coefficients[1:] | flatten | all(. == 0))' lights.json
"$program" list lights >told
check "a line for people" grep -q '^window: Dim room of 0.08 with a window' told
check "and what is lost" grep -qx '    nine coefficients hold 46.1 % of its energy; bands 1 and 2 count 0.662 and 0.290' told
while read -r name title; do
  check "docs/design.md has the light $name" grep -q "^| \`$name\` | .* %" "$root/docs/design.md"
done < <(sed -n 's/^\([a-z]*\): .*/\1/p' told)
check "the scenes" "$program" list scenes --json scenes.json
check "each names one of them" jq -es '(.[1].lights | map(.name)) as $lights | all(.[0].scenes[]; .light as $l | $lights | index([$l]))' scenes.json lights.json
while read -r name; do
  check "README.md has the scene $name" grep -q "^| .*\`$name\`.* |" "$root/README.md"
  check "docs/design.md has the scene $name" grep -q "^| \`$name\` |" "$root/docs/design.md"
done < <(jq -r '.scenes[].name' scenes.json)
"$program" list scenes >told
check "for people as well" grep -qx '    views: room table; light: window' told
finish
