# Sourced by bench.sh: what a history of 100,000 cases costs, in nights of 1,000 made of a real record (errors against two
# targets, caches of two levels, raw rounds for each block of six). A night is opened, begun, taken, ended and closed.
if wanted history; then
  cat >"$folder/history.yaml" <<EOF2
name: history
scenes: [{name: corner}]
resolutions: [96x54]
backends: [vulkan]
techniques: [{name: gtao}]
target: [{radius: 0.5}, {radius: 1}]
measure: {seconds: 0.5, cache: [ps4], images: false}
EOF2
  build/release/aobudget run "$folder/history.yaml" --out "$folder/history" --quiet
  while read -r name value unit; do
    case $name in
      last) row "history: 1,000 cases into 100,000" "$value" "$unit" "<=" 2 ;;
      mean) row "history: 1,000 cases, mean of 100 nights" "$value" "$unit" ;;
      read) row "history: all lines read, without figures" "$value" "$unit" "<=" 1 ;;
      figures) row "history: all lines read, with figures" "$value" "$unit" ;;
      size) row "history: size of the file" "$value" "$unit" ;;
      points) row "history: points" "$value" "" ">=" 100000 ;;
    esac
  done < <(build/release/bench/bench_history "$folder/history" "$folder/history-work" 100 1000)
  start=$(date +%s.%N)
  build/release/aobudget history "$folder/history-work/history.db" export --out "$folder/history.csv" --quiet
  row "history: all exported as CSV" "$(awk -v s="$start" -v e="$(date +%s.%N)" 'BEGIN { printf "%.1f", e - s }')" s
  rm -rf "$folder/history-work"
fi
