# Sourced by ./dev: what it says while it works, all of it on standard error. A step's own output goes to a log. How far it
# is stands in one line that is rewritten where standard error is a terminal, else in a line for each tenth of the step.
logs=build/log
live=
width=0
if [ -t 2 ]; then
  live=yes
  read -r _ width < <(stty size <&2)
fi
[ "$width" -gt 0 ] || width=80 # some terminals do not know

say() { # TEXT
  printf '%sdev: %s\n' "${live:+$'\r\e[K'}" "$1" >&2
}

# A line that the next one takes the place of, cut at the terminal's edge: a longer one would not be rewritten whole.
hint() { # TEXT
  local line="dev: $1"
  [ -z "$live" ] || printf '\r\e[K%s' "${line:0:width-1}" >&2
}

# Reads what a step prints, a line at a time: ninja's "[12/345] WHAT", and apt's "dlstatus:N:PERCENT:WHAT" while it fetches
# and "pmstatus:PACKAGE:PERCENT:WHAT" while it installs. apt fetches all before it installs, so the tenths begin again.
follow() { # NAME LOG
  local line percent what tenth=0
  while IFS= read -r line; do
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\  ]]; then
      percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2])) what=$line
    elif [[ $line =~ ^(dl|pm)status:[^:]*:([0-9]+)[^:]*:(.*) ]]; then
      percent=${BASH_REMATCH[2]} what="$percent %, ${BASH_REMATCH[3]}"
    else
      percent=''
    fi
    [[ $line =~ ^(dl|pm)status: ]] || printf '%s\n' "$line" >>"$2"
    [ -n "$percent" ] || continue
    hint "$1: $what"
    [ -n "$live" ] || [ $((percent / 10)) -le $tenth ] || say "$1: $what"
    tenth=$((percent / 10))
  done
}

# Runs COMMAND. If it fails, the end of what it printed is shown with the place of the rest, and ./dev ends.
step() { # NAME COMMAND...
  local name=$1 log="$logs/${1// /-}.log" start=$SECONDS code=0 took
  shift
  mkdir -p "$logs"
  : >"$log"
  hint "$name"
  "$@" 2>&1 | follow "$name" "$log" || code=$?
  took=$((SECONDS - start))
  took=$(printf '%d:%02d' $((took / 60)) $((took % 60)))
  if [ $code -eq 0 ]; then
    say "$name: done in $took"
  else
    say "$name: failed after $took; its last lines:"
    tail -n 30 "$log" >&2
    say "all that it printed is in $PWD/$log"
    exit 1
  fi
}

# For a step: apt-get's status goes to standard output, and all else straight to the step's log, since dpkg prints parts of
# lines. The shell opens the status's number behind sudo, which closes every number but the first three; the environment is
# set there too, since sudo keeps none of it.
run_apt() { # ARGUMENT...
  local root=()
  [ "$(id -u)" -eq 0 ] || root=(sudo)
  "${root[@]}" sh -c 'exec "$@" 3>&1 1>&2' sh env DEBIAN_FRONTEND=noninteractive LC_ALL=C \
    apt-get -o APT::Status-Fd=3 -y --no-install-recommends "$@" 2>>"$log"
}

# Installs those of the packages that are missing.
setup() { # PACKAGE...
  local missing=() all
  for p in "$@"; do
    dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'install ok installed' || missing+=("$p")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  say "${#missing[@]} of $# packages are missing: ${missing[*]}"
  [ "$(id -u)" -eq 0 ] || sudo true # so that it asks for the password on a line of its own
  step 'package lists' run_apt update
  all=$(LC_ALL=C apt-get -s --no-install-recommends install "${missing[@]}" 2>/dev/null | grep -c '^Inst ' || true)
  say "$all packages are to be installed: these and what they need"
  step 'packages' run_apt install "${missing[@]}"
}

build() { # PRESET
  step "configure $1" cmake --preset "$1"
  NINJA_STATUS='[%f/%t] ' step "build $1" cmake --build --preset "$1"
}
