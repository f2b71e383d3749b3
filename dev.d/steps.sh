# Sourced by ./dev: a step runs one long command. Its whole output goes into a log under build/log/, and a person sees
# one line of progress: rewritten on a terminal, else a new one for every ten percent, so that a CI log stays short.

say() { printf 'dev: %s\n' "$*" >&2; }

# progress PERCENT TEXT
tenth=-1 # the last ten percent that got a line of its own
progress() {
  if [ -t 2 ]; then
    local columns
    columns=$(stty size <&2 2>/dev/null | cut -d' ' -f2)
    [ "${columns:-0}" -gt 0 ] || columns=80
    printf '\r\033[K%.*s' "$((columns - 1))" "dev: $2" >&2
  elif [ $(($1 / 10)) -ne "$tenth" ]; then
    tenth=$(($1 / 10))
    say "$2"
  fi
}

# step WHAT READER LOG COMMAND...: READER reads what COMMAND prints, shows progress and adds to the log. If COMMAND fails,
# the end of its output is shown without the lines of progress, and ./dev ends with its exit code.
step() {
  local what=$1 reader=$2 log=build/log/$3.log start=$SECONDS code=0
  shift 3
  mkdir -p build/log
  : >"$log"
  say "$what"
  "$@" 2>>"$log" | "$reader" "$log" || code=$?
  [ -t 2 ] && printf '\r\033[K' >&2
  if [ $code -ne 0 ]; then
    grep -vE '^\[[0-9]+/[0-9]+\] ' "$log" | tail -n 60 >&2 || true
    say "$what failed after $((SECONDS - start)) s with exit code $code; the whole output is in $PWD/$log"
    exit $code
  fi
  say "$what took $((SECONDS - start)) s"
}

read_quietly() { cat >>"$1"; } # for a step of seconds

# What ninja writes: "[7/246] Building C object FOLDER/CMakeFiles/TARGET.dir/FILE.o". Only the file is of interest. A count
# of 0 is ninja's look at what there is to do.
read_ninja() {
  local line
  while IFS= read -r line; do
    printf '%s\n' "$line" >>"$1"
    if [[ $line =~ ^\[([1-9][0-9]*)/([0-9]+)\]\ (.*) ]]; then
      progress $((100 * BASH_REMATCH[1] / BASH_REMATCH[2])) "[${BASH_REMATCH[1]}/${BASH_REMATCH[2]}] ${BASH_REMATCH[3]##*.dir/}"
    fi
  done
}

# What apt writes to APT::Status-Fd: "dlstatus:NUMBER:PERCENT:TEXT" while it downloads, then "pmstatus:PACKAGE:PERCENT:TEXT"
# while it installs. A package's name may hold a colon, so the percent is known by its point.
read_apt() {
  local line doing
  while IFS= read -r line; do
    [[ $line =~ ^(dl|pm)status:.*:([0-9]+)\.[0-9]+:(.*) ]] || continue
    doing=installing
    [ "${BASH_REMATCH[1]}" = dl ] && doing=downloading
    progress "${BASH_REMATCH[2]}" "$doing, ${BASH_REMATCH[2]} %: ${BASH_REMATCH[3]}"
  done
}
