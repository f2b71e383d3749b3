#!/usr/bin/env bash
# history: what is listed, exported and pruned, of nights whose journals are written here; tables are read by Python.
source "$(dirname "$0")/lib.sh"
keep=$AOBUDGET_BUILD/history_keep
cd "$folder"
mkdir run
# record KEY SCENE SLICES RATIO RADIUS BAND: timed unless RATIO is null, scored unless BAND is null
record() {
  jq -cn --arg key "$1" --arg scene "$2" --argjson slices "$3" --argjson ratio "$4" --argjson radius "$5" --argjson band "$6" '
    {key: $key, series: "s-\($key)", scene: $scene, view: "front", metre: 1, technique: "gtao",
     params: {radius: 0.5, slices: $slices}, options: {guard_band: 0, fetch: "sampled"}, backend: "vulkan",
     width: 480, height: 270, status: "ok", reason: "", memory_bytes: (if $slices == 4 then 12345678901 else 1036800 end),
     fingerprint: {cpu: "Xeon", cores: 2, device: "llvmpipe", driver: "Mesa", class: "cpu", fixed_pass: 1},
     image_digest: "i-\($key)",
     cache: {ps4: {status: "ok", frame: {levels: [{name: "l1", one: {miss_ratio: 0.125, fills_per_pixel: 2.5, bytes_per_pixel: 160},
                                                   most: {miss_ratio: 0.25, fills_per_pixel: (if $slices == 4 then 5 else null end), bytes_per_pixel: 320}}]}}}}
    + (if $ratio then {time: {clock: "cpu", cpu_ms: ($ratio / 2), wall_ms: 9, threads: 2, ref_ms: 0.5, ratio_to_ref: $ratio,
                              ci_low: ($ratio * 0.9), ci_high: ($ratio * 1.1)}} else {} end)
    + (if $band then {error: {target: {radius: $radius, weighting: "cosine"}, reference: "ray-traced", rmse: 0.0625,
                              band_rmse: $band, bias: -0.01234567891, band_pixels: 1558, covariance: {missing_estimator: -0.004}}} else {} end)'
}
echo '{"name":"nightly","build":"b1","techniques":[{"name":"gtao","module":null,"digest":"d1","params":[{"name":"radius","unit":"scene_units","initial":0.5},{"name":"slices","unit":"count","initial":3}]}]}' >run/run.json
{
  record a corner 3 2 0.5 0.1
  record b 'a "quoted", scene' 4 3.25 '"inf"' 0.125
  record c 'new
line' 3 null 0.5 0.25
  record d corner 8 4 0.5 null | jq -c '.status = "failed" | .reason = "it broke, \"badly\"" | del(.time, .memory_bytes, .cache)'
} >run/journal.jsonl
check "the first night" test "$("$keep" h.db nightly 1780279200 run '{"line": "calm", "slower": 0}')" = "1 4"
{
  record a corner 3 2.5 0.5 0.1
  record b 'a "quoted", scene' 4 3.5 '"inf"' 0.125
} >run/journal.jsonl
check "the second" test "$("$keep" h.db nightly 1780365600 run '{"line": "1 slower"}')" = "2 2"
check "another config" test "$("$keep" h.db weekly 1780365601 run)" = "3 2"

check "list" "$program" history h.db list --json list.json
cp .stdout list
check "a line a night" grep -qx '   1  2026-06-01T02:00:00Z  nightly  3 of 4 ok  whole  calm' list
check "its summary's line" grep -qx '   2  2026-06-02T02:00:00Z  nightly  2 of 2 ok  whole  1 slower' list
check "what did not end" grep -qx '   3  2026-06-02T02:00:01Z  weekly  2 of 2 ok  not ended' list
check "sums" grep -qx "3 nights, 6 lines, 8 points; the file has $(awk -v b="$(stat -c %s h.db)" 'BEGIN { printf "%.1f", b / 1e6 }') MB" list
check "as JSON" jq -e --argjson bytes "$(stat -c %s h.db)" '.lines == 6 and .points == 8 and .bytes == $bytes and (.history | endswith("/h.db")) and
  (.nights | length == 3 and (.[0] | .id == 1 and .config == "nightly" and .config_hash == "c0ffee" and .build == "b1" and .whole and .cases == 4 and
  .ok == 3 and .summary.slower == 0 and .date == "2026-06-01T02:00:00Z" and (.folder | endswith("/run"))) and (.[2] | .whole == false and .summary == null))' list.json
check "of one config" jq -e '(.nights | length) == 1 and .lines == 2 and .points == 2' <("$program" history h.db list --config weekly --json -)

check "CSV" "$program" history h.db export --out h.csv --json export.json
cp .stdout said
check "says so" grep -qx '8 points in h.csv' said
check "and as JSON" jq -e '.points == 8 and (.file | endswith("/h.csv"))' export.json
check "JSON lines" "$program" history h.db export --out h.jsonl
check "JSON lines: an infinity is a number of JSON, and of CSV inf" test "$(grep -c '"target_radius":1e999[,}]' h.jsonl) $(grep -c ',inf,' h.csv)" = "3 3"
cat >read.py <<'END'
import csv, json, math, sqlite3, subprocess
rows = list(csv.DictReader(open("h.csv", newline="")))
lines = [json.loads(line) for line in open("h.jsonl")]
assert len(rows) == len(lines) == 8, "eight points"
assert open("h.csv", newline="").read().count("\r\n") == 9, "RFC 4180 ends lines with CR LF"
for row, line in zip(rows, lines):
    assert list(row) == list(line), "the same columns"
    assert not None in row, "no field too many"
    for name, value in line.items():
        text = row[name]
        if value is None:
            assert text == "", name
        elif isinstance(value, (int, float)):
            assert float(text) == value, name
        else:
            assert text == value, name
a, b, c, d = lines[:4]
assert (a["night"], a["date"], a["config"]) == (1, "2026-06-01T02:00:00Z", "nightly")
assert (a["key"], a["series"], a["build"], a["image"], a["verdict"]) == ("a", "s-a", "d1", "i-a", "none")
assert a["class"] == "cpu, 2 x Xeon, llvmpipe, Mesa, fixed pass 1, 2 threads, cpu time"
assert (a["params"], a["options"], a["size"]) == ("radius=0.5 slices=3", "guard_band=0 fetch=sampled", "480x270")
assert (a["time_ms"], a["ratio_to_ref"], a["ci_low"], a["ref_ms"]) == (1, 2, 1.8, 0.5)
assert (a["memory_bytes"], a["band_pixels"], a["missing_estimator"]) == (1036800, 1558, -0.004)
assert a["bias"] == -0.0123456789 and a["flip"] is None
assert a["cache.ps4.l1.most.miss_ratio"] == 0.25 and a["cache.ps4.l1.most.fills_per_pixel"] is None
assert b["cache.ps4.l1.most.fills_per_pixel"] == 5
assert b["scene"] == 'a "quoted", scene' and b["target_radius"] == math.inf and rows[1]["target_radius"] == "inf"
assert b["memory_bytes"] == 12345678901 and rows[1]["memory_bytes"] == "12345678901"
assert c["scene"] == "new\nline" and c["ratio_to_ref"] is None and c["band_rmse"] == 0.25
assert (d["status"], d["reason"], d["memory_bytes"]) == ("failed", 'it broke, "badly"', None)
assert d["target_weighting"] == "" and d["cache.ps4.l1.one.miss_ratio"] is None
assert [r["ratio_to_ref"] for r in lines[4:]] == [2.5, 3.5, 2.5, 3.5]
db = sqlite3.connect("h.db")
assert db.execute("PRAGMA application_id").fetchone()[0] == 0x616F6268
assert db.execute("PRAGMA user_version").fetchone()[0] == 1
assert db.execute("PRAGMA journal_mode").fetchone()[0] == "wal"
kept = db.execute("SELECT night, series, ratio, band_rmse FROM point JOIN line ON line.id = point.line ORDER BY 1, line.id").fetchall()
assert kept == [(r["night"], r["series"], r["ratio_to_ref"], r["band_rmse"]) for r in lines], "the table is the database's"
packed = db.execute("SELECT zstd FROM journal WHERE night = 2").fetchone()[0]
assert subprocess.run(["zstd", "-dc"], input=packed, capture_output=True).stdout == open("run/journal.jsonl", "rb").read()
END
check "Python reads all of it, and finds what the journals say" python3 read.py
head -1 h.csv | tr -d '\r' | tr , '\n' >columns
mkdir page && cp run/* page && "$program" report page --out report --quiet >.stdout 2>&1
check "columns are called as in cases.csv" test -z "$(head -1 report/cases.csv | tr -d '\r' | tr , '\n' | grep -vxFf columns)"
check "from a date" "$program" history h.db export --from 2026-06-02 --config nightly --out from.jsonl
check "only later nights" jq -es 'map(.night) == [2, 2]' from.jsonl
check "from a moment" "$program" history h.db export --from 2026-06-02T02:00:01Z --out moment.csv
check "that one" test "$(wc -l <moment.csv)" -eq 3

expect 2 "usage: aobudget history F.db" "$program" history h.db
expect 2 "history: there is no 'lst'; there are list, plot, prune, export" "$program" history h.db lst
expect 2 "history list: takes no --keep" "$program" history h.db list --keep 3
expect 2 "history prune: takes no --config" "$program" history h.db prune --config nightly --keep 3
expect 2 "history prune: say how many nights of each config stay, as --keep 30" "$program" history h.db prune
for bad in 0 -1 1.5 x ""; do
  expect 2 "--keep: '$bad' is not a whole number from 1" "$program" history h.db prune --keep "$bad"
done
expect 2 "history export: say where to, as --out FILE.csv or --out FILE.jsonl" "$program" history h.db export
expect 2 "h.txt: its ending says the form: .csv or .jsonl" "$program" history h.db export --out h.txt
for bad in 2026 2026-6-1 2026-06-01T yesterday 2026-06-01T02:00:00Zx ""; do
  expect 2 "'$bad' is no date such as 2026-11-30" "$program" history h.db export --from "$bad" --out x.csv
done
expect 2 "lost/x.csv: cannot write" "$program" history h.db export --out lost/x.csv
expect 2 "has no night of a config 'monthly'" "$program" history h.db list --config monthly
expect 2 "none.db: there is no such history" "$program" history none.db list
expect 2 "none.db: there is no such history" "$program" history none.db prune --keep 1
check "nothing is made of it" test ! -e none.db -a ! -e x.csv -a ! -e h.txt
expect 2 "list: is not a history (no SQLite file)" "$program" history list list

cp h.db bare.db
check "figures of a night are lost" python3 -c 'import sqlite3; db = sqlite3.connect("bare.db"); db.execute("DELETE FROM figures WHERE night = 1"); db.commit()'
check "its points are exported" test "$("$program" history bare.db export --out bare.jsonl)" = "8 points in bare.jsonl"
check "without them" jq -es 'length == 8 and (map(select(.bias == null)) | length == 4) and .[0].ratio_to_ref == 2 and .[4].ratio_to_ref == 2.5 and .[4].bias == -0.0123456789' bare.jsonl
cp h.db rounds.db
check "prune --rounds" "$program" history rounds.db prune --keep 1 --rounds --json pruned.json
cp .stdout said
check "says what went" grep -qE '^removed the journal and raw rounds of 1 night; the file has 0\.[0-9] MB, 0\.[0-9] less$' said
check "and as JSON" jq -e '.rounds_only and .nights == 1 and .points == 0' pruned.json
check "the points stay" jq -e '.points == 8' <("$program" history rounds.db list --json -)
check "prune" "$program" history h.db prune --keep 1 --json pruned.json
cp .stdout said
check "says which" grep -qE '^removed 1 night with 4 points; the file has 0\.[0-9] MB, 0\.[0-9] less$' said
check "the numbers" jq -e '.rounds_only == false and .nights == 1 and .points == 4 and (.bytes | type) == "number"' pruned.json
check "the latest of each config stay" jq -e '[.nights[].id] == [2, 3] and .lines == 4 and .points == 4' <("$program" history h.db list --json -)
check "quiet" test -z "$("$program" history h.db prune --keep 1 --quiet)"
check "nothing lies about" test -z "$(ls -A | grep -E '(-wal|-shm|\.part)$')"
finish
