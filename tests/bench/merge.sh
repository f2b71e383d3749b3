# Sourced by bench.sh: what it costs to merge the folders of a run's parts. The folders are written, not run: the record of one case
# with all its figures, under the keys of a plan that is dealt out in turn.
if wanted merge; then
  cat >"$folder/merge.yaml" <<EOF
name: merge
scenes: [{name: corner}]
resolutions: [160x90]
backends: [vulkan]
techniques: [{name: gtao}]
measure: {seconds: 0.2}
reference: {spp: 2}
EOF
  build/release/aobudget run "$folder/merge.yaml" --out "$folder/merge" --quiet
  # make_parts PARTS CASES IMAGES: folders $folder/part-1 and so on; IMAGES: yes, an image of its own for each case.
  make_parts() {
    local parts=$1 cases=$2 images=$3 part
    rm -rf "$folder"/part-*
    for part in $(seq "$parts"); do
      local into=$folder/part-$part
      mkdir -p "$into/images" "$into/truths" "$into/rounds"
      cp -r "$folder/merge/graphs" "$folder/merge/run.config.yaml" "$into"
      cp "$folder/merge"/truths/* "$into/truths"
      cp "$folder/merge"/rounds/* "$into/rounds"
      jq -c ".cases = $cases | .keys = [range($cases) | tostring | (\"0\" * (32 - length)) + .]
        | .asked = [.keys[range($part - 1; $cases; $parts)]]" "$folder/merge/run.json" >"$into/run.json"
      jq -c "$([ "$images" = yes ] || echo 'del(.image) |') ." "$folder/merge/journal.jsonl" |
        awk -v first=$((part - 1)) -v step="$parts" -v end="$cases" '{
          key = substr($0, 9, 32); rest = substr($0, 41)
          gsub("images/" key, "images/KEY", rest)
          split(rest, pieces, "KEY")
          for (i = first; i < end; i += step) {
            new = sprintf("%032d", i)
            print "{\"key\":\"" new pieces[1] (2 in pieces ? new pieces[2] : "")
          }
        }' >"$into/journal.jsonl"
    done
  }
  # One image under the names of all cases of a part, each with a seal of its own: what merging a folder of copies makes.
  seal_images() {
    local key part
    key=$(jq -r .key "$folder/merge/journal.jsonl")
    for part in "$folder"/part-*; do
      jq -r .key "$part/journal.jsonl" >"$folder/keys"
      build/release/seal_copies "$folder/merge/images/$key.exr" "$part/images" <"$folder/keys"
    done
  }
  make_parts 10 100000 no
  sync # a run has flushed its lines
  size=$(($(cat "$folder"/part-*/journal.jsonl | wc -c) / 1000000))
  row "merge: 10 folders of 10,000 cases, $size MB" "$(elapsed build/release/aobudget merge "$folder"/part-* --out "$folder/merged")" s "<=" 10
  row "merge: cases in the merged journal" "$(wc -l <"$folder/merged/journal.jsonl")" cases ">=" 100000
  rm -rf "$folder/merged"
  make_parts 4 1000 yes
  seal_images
  sync
  row "merge: 4 folders of 250 cases with images, $(du -sm "$folder"/part-*/images | awk '{ s += $1 } END { print s }') MB" \
    "$(elapsed build/release/aobudget merge "$folder"/part-* --out "$folder/merged")" s
  rm -rf "$folder"/part-* "$folder/merged"
fi
