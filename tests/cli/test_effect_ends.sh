#!/usr/bin/env bash
# effects: where its frames lie while it plans, and that they go with it however it ends, as its workers do.
source "$(dirname "$0")/lib.sh"
cd "$folder"
export AOBUDGET_CACHE=$folder/cache
small=("$program" effects corner --size 64x36 --backend gl-egl --quiet)
mkdir own shut
chmod 500 shut
left() { find "$1" -maxdepth 1 -name 'aobudget-effects-*' | wc -l; }
wait_for() { # TEXT CONDITION...: up to 20 s
  local what=$1 turn
  shift
  for ((turn = 0; turn < 400; turn++)); do
    "$@" && return
    sleep 0.05
  done
  check "$what" false
}
there() { test "$(left own)" = 1; }
gone() { test "$(left own)" = 0; }

# A plan that goes on for long, ended from outside: by a signal that can be caught, and by one that cannot.
workers_of() { pgrep -P "$1" -f worker; }
has_worker() { workers_of "$1" >/dev/null; }
dead() { ! kill -0 "$1" 2>/dev/null; }
ends_by() { # SIGNAL
  local pid worker code=0
  set -m # else a shell's background program ignores INT
  TMPDIR=$folder/own "$program" effects gallery --size 640x360 --backend gl-egl --reference-spp 4096 --quiet >ended 2>&1 &
  pid=$!
  set +m
  wait_for "a folder in TMPDIR" there
  wait_for "a worker" has_worker "$pid"
  worker=$(workers_of "$pid" | head -1)
  kill -"$1" "$pid"
  wait "$pid" 2>/dev/null || code=$?
  check "$1 ends it as such" test "$code" = $((128 + $(kill -l "$1")))
  wait_for "$1 leaves no folder" gone
  wait_for "$1 ends the worker" dead "$worker"
  check "$1: no word of it" test ! -s ended
}
ends_by TERM
ends_by INT
ends_by KILL

check "an orderly end" env TMPDIR="$folder/own" "${small[@]}"
check "leaves nothing" gone
# The folder's time tells that something was in it.
touch -d '2001-01-01' own
check "it lay there" bash -c 'TMPDIR=$0/own "$@" && test "$0/own" -nt "$0/shut"' "$folder" "${small[@]}"
check "a relative one" env TMPDIR=own "${small[@]}"
check "leaves nothing either" gone
for bad in "$folder/nowhere" "$folder/shut/none" '' "$folder/err"; do
  check "TMPDIR=$bad: /tmp serves" env TMPDIR="$bad" "${small[@]}"
done
cat >auto.yaml <<'YAML'
name: auto
scenes: [{name: gallery}]
resolutions: [640x360]
backends: [gl-egl]
effects: auto
techniques: [{name: gtao}]
YAML
TMPDIR=$folder/own "$program" run auto.yaml --out auto --quiet >ended 2>&1 &
pid=$!
wait_for "a run's plan is in TMPDIR" there
kill -TERM $pid
wait $pid || true
wait_for "and goes with it" gone
finish
