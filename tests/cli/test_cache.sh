#!/usr/bin/env bash
# Whatever befalls a cached file, a shot gives the figures that it gave before. It says in one line of each file that it
# discarded it; what it cannot read it leaves as it is, and says that in one line with code 2.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
cat >box.obj <<END
v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
v -1 1 -1
v 1 1 -1
f 1 2 3
f 1 3 4
f 1 2 6
f 1 6 5
END
mesh=("$program" shot --technique hbao --scene box.obj --eye 0,1,2 --target 0,0.2,0 --size 32x18 --backend null
  --reference-spp 16 --quiet)
moving=("$program" run moving.yaml --fresh --quiet --out out)
cat >moving.yaml <<END
name: moving
scenes: [{name: corner, eye: [0, 2, 4], target: [0, 1, 0], previous: {eye: [0.1, 2, 4], target: [0, 1, 0]}}]
resolutions: [32x18]
backends: [null]
techniques: [{name: hbao, params: {blur: 0}}]
measure: {time: false, images: false}
reference: {spp: 16}
END
figures() { jq -S '.error, .errors' "$@"; }
run_mesh() { "${mesh[@]}" --json shot.json >said 2>&1; }
run_moving() { "${moving[@]}" >said 2>&1; }
check "a shot" run_mesh
check "says nothing" test ! -s said
figures shot.json >mesh.figures
cp -r cache mesh.files
check "a run" run_moving
figures out/journal.jsonl >moving.figures
check "a figure is one" grep -q '"definition_rmse": 0.0*[1-9]' mesh.figures
check "what is cached" test "$(ls cache | sed 's/-.*//' | sort | uniq -c | tr -s ' \n' ' ')" = " 2 gbuffer 1 mesh 6 visibility "
cp -r cache files
kinds=$(cd files && echo mesh-* gbuffer-* visibility-*)

# heals FILE WHAT: the file was spoilt. What reads it is done again: the figures are the same, one line says that the file
# was discarded, and it is what it was.
heals() {
  local what=moving
  [ -e "mesh.files/$1" ] && what=mesh
  check "$what with $1 $2" "run_$what"
  if [ $what = mesh ]; then figures shot.json; else figures out/journal.jsonl; fi >now.figures
  check "$1 $2: the same figures" cmp now.figures $what.figures
  check "$1 $2: one line says so" test "$(wc -l <said)" -eq 1
  check "$1 $2: it says what" grep -q "warning: $PWD/cache/$1: .*discarded and made again" said
  check "$1 $2: it is made again" cmp "cache/$1" "files/$1"
}
# Of each kind of file the first is spoilt in every way, and each of the others in its body.
is_first() { [ "$1" = "$(cd files && ls | grep "^${1%%-*}-" | head -1)" ]; }
for file in $kinds; do
  size=$(stat -c %s "files/$file")
  bytes=330
  is_first "$file" && bytes="0 40 330 $((size - 41)) $((size - 1))" # in a header, in the body, in the seal
  for sector in $(seq 0 $(((size - 1) / 512))); do
    is_first "$file" || break
    [ $((sector % 3)) -eq 0 ] || [ $(((sector + 1) * 512)) -ge "$size" ] || continue
    dd if=/dev/zero of="cache/$file" bs=512 seek="$sector" count=1 conv=notrunc status=none
    truncate -s "$size" "cache/$file"
    heals "$file" "without sector $sector"
  done
  for byte in $bytes; do
    [ "$byte" -lt "$size" ] || continue
    old=$(dd if="files/$file" bs=1 skip="$byte" count=1 status=none | od -An -tu1)
    printf "\\x$(printf %x $((old ^ 4)))" | dd of="cache/$file" bs=1 seek="$byte" conv=notrunc status=none
    heals "$file" "with byte $byte changed"
  done
  is_first "$file" || continue
  truncate -s 0 "cache/$file"
  heals "$file" "empty"
done
first=$(cd files && ls | grep visibility | head -1)
for other in $kinds; do # another file, which is whole, under the right name; of another shape, kind or content
  [ "$other" = "$first" ] && continue
  cp "files/$other" "cache/$first"
  heals "$first" "replaced by $other"
done
for file in $kinds; do printf x >>"cache/$file"; done
check "all at once" run_mesh
figures shot.json >now.figures
check "the same figures" cmp now.figures mesh.figures
check "a line each" test "$(grep -c 'discarded and made again' said)" -eq "$(ls mesh.files | wc -l)"

# stays FILE TEXT COMMAND...: it cannot be read. The command says so and the file is left.
stays() {
  expect 2 "$2" "${@:3}"
  check "one line names it" grep -q "$1.*stays as it is" .stderr
}
rm -r cache && cp -r files cache
for file in $(ls mesh.files); do
  mv "cache/$file" aside
  ln -s "$file" "cache/$file" # to itself
  stays "$file" "Too many levels" "${mesh[@]}"
  check "the link is left" test -L "cache/$file"
  rm "cache/$file" && mkdir "cache/$file"
  stays "$file" "no regular file" "${mesh[@]}"
  check "the folder is left" test -d "cache/$file"
  rmdir "cache/$file" && mv aside "cache/$file"
done
# A module that leaves its worker no file to open costs its own case, and no file of the cache.
sed 's/techniques: .*/techniques: [{name: few_files}]/' moving.yaml >few.yaml
for i in 1 2; do # the second time all is there, and none of it can be read
  expect 2 "nothing could run" "$program" run few.yaml --out few --fresh --quiet --module "$AOBUDGET_BUILD/tests/modules/few_files.so"
  check "the cause is named" grep -q "cache/.*: cannot read: Too many open files" few/journal.jsonl
  for file in $kinds; do check "$file is left" cmp "cache/$file" "files/$file"; done
done
# The folder may be deleted at any time: here whenever a worker that has this module ends, so after each block, as its own
# technique is in each. The run goes on and has the figures of one whose cache stays.
cat >forget.yaml <<END
name: forget
scenes: [{file: box.obj, eye: [0, 1, 2], target: [0, 0.2, 0], metres_per_unit: 1}, {name: corner}]
resolutions: [64x36, 32x18]
backends: [null]
techniques: [{name: hbao}]
measure: {time: false, images: false}
reference: {spp: 16}
END
check "a cache that stays" "$program" run forget.yaml --out kept --quiet
rm -r cache
sed 's/{name: hbao}/{name: hbao}, {name: forget}/' forget.yaml >both.yaml
"$program" run both.yaml --out gone --quiet --module "$AOBUDGET_BUILD/tests/modules/forget.so" || true # it draws nothing
check "it went" test ! -e cache
grep '"technique":"hbao"' gone/journal.jsonl >others.jsonl
check "four cases are ok" test "$(jq -r .status others.jsonl | sort | uniq -c | tr -s ' ')" = " 4 ok"
check "their figures are the same" cmp <(figures kept/journal.jsonl) <(figures others.jsonl)
cp -r files cache

# Root may read everything, so that somebody else tries: the program and all that it needs lie in this folder.
somebody=()
if [ "$(id -u)" -eq 0 ]; then
  somebody=(setpriv --reuid=65534 --regid=65534 --clear-groups)
  chmod 755 . && chown -R 65534 cache
  cp "$program" here
  mesh[0]=$folder/here
fi
file=$(ls mesh.files | grep visibility | head -1)
[ "$(id -u)" -eq 0 ] && chown 0 "cache/$file"
chmod 0 "cache/$file"
stays "$file" "Permission denied" "${somebody[@]}" "${mesh[@]}"
chmod 644 "cache/$file"
check "it is as it was" cmp "cache/$file" "files/$file"
check "and serves" "${somebody[@]}" "${mesh[@]}"
check "as it was" cmp "cache/$file" "files/$file"
mesh[0]=$program
[ "$(id -u)" -eq 0 ] && expect 2 "belongs to user 65534, not to you (user 0)" "${mesh[@]}"
rm -r cache

# A folder that is not the user's alone is not used, and a link in its place is not followed.
mkdir cache && chmod 777 cache
expect 2 "cache (set AOBUDGET_CACHE to move it): $folder/cache: others may write in the folder" "${mesh[@]}"
check "nothing is written there" test -z "$(ls -A cache)"
rmdir cache && mkdir elsewhere && ln -s elsewhere cache
expect 2 "$folder/cache: it is a link" "${mesh[@]}"
check "nothing is written there" test -z "$(ls -A elsewhere)"
rm cache

# An older version's files have no seal and other names. They stay, and nothing is said of them.
mkdir cache
old=visibility-0123456789abcdef0123456789abcdef.exr
echo "of an older version" >"cache/$old"
check "beside an older version's files" run_mesh
check "nothing is said" test ! -s said
check "they stay" grep -q "of an older version" "cache/$old"

# Programs that share a cache and are killed at any time leave nothing that is wrong.
rm -r cache
for i in 1 2 3 4 5 6; do
  rm -rf cache
  for k in 1 2 3; do # a lock each, as a wait for the others' would be told
    AOBUDGET_LOCK=$folder/lock$k "${mesh[@]}" --json "shot$k.json" >/dev/null 2>"said$k" & pids[k]=$!
  done
  if [ "$i" -lt 6 ]; then
    sleep 0."$i"
    kill -9 "${pids[1]}" "${pids[2]}" 2>/dev/null
  fi
  for k in 1 2 3; do wait "${pids[k]}" 2>/dev/null && { figures "shot$k.json" | cmp - mesh.figures || failures=$((failures + 1)); }; done
  check "nothing was wrong for the third" test ! -s said3
  check "nor is it for the next" run_mesh
  check "nothing was discarded" test ! -s said
  check "all is there as it was" diff -r mesh.files cache
done

# A page draws no picture of an image that is damaged, and says why.
sed 's/images: false/images: true/' moving.yaml >pictures.yaml
check "a run with images" "$program" run pictures.yaml --out pictures --quiet
image=$(jq -r .image pictures/journal.jsonl)
truncate -s -1 "pictures/$image"
"$program" report pictures --out page --quiet
check "the page names it" grep -q "pictures/$image: it does not end with" page/index.html
finish
