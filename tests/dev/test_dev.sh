#!/usr/bin/env bash
# What ./dev prints while it works, word for word but for the times, in a copy of it with an apt-get, a dpkg-query, a cmake
# and a sudo that only print. What they are to do lies in files of the folder `says`.
set -u
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
mkdir "$folder/fake" "$folder/says"
cp -r "$here/../../dev" "$here/../../dev.d" "$folder"
cd "$folder" || exit 1

fake() { # NAME, its text on standard input
  { echo '#!/usr/bin/env bash'; echo "says=$folder/says"; cat; } >"fake/$1"
  chmod +x "fake/$1"
}
fake dpkg-query <<'END'
echo "$3" >>"$says/asked"
grep -qx "$3" "$says/missing" || printf 'install ok installed'
END
# Real progress has three decimals in a percentage; the text after it may hold colons.
fake apt-get <<'END'
echo "$(id -u) $*" >>"$says/apt-calls"
case " $* " in
  *' -s '*) printf 'Inst %s\n' cmake libuv1 jq; echo 'Conf cmake' ;;
  *' update '*) echo 'Get:1 http://somewhere stable InRelease' ;;
  *)
    for n in 1 2 3; do echo "dlstatus:$n:$((n * 30)).3333:Retrieving file $n of 3 (1s remaining)" >&3; done
    for n in 0 4 8 12 50; do echo "pmstatus:libuv1:$n.1234:Unpacking libuv1:amd64 ($n)" >&3; done
    if [ -f "$says/apt-fails" ]; then
      echo 'E: Unable to correct problems' >&2
      exit 100
    fi
    echo 'pmstatus:jq:100.0000:Installed jq' >&3 ;;
esac
END
fake sudo <<'END'
echo "$*" >>"$says/sudo-calls"
PATH=$(dirname "$0")/root:$PATH exec "$@" 3>&- # like sudo, it hands on no further file
END
fake cmake <<'END'
if [ "$1" = --preset ]; then
  echo "-- Configuring done"
  [ ! -f "$says/configure-fails" ] || { echo 'CMake Error: no compiler' >&2; exit 1; }
else
  echo '[0/2] Re-checking globbed directories...'
  for n in $(seq 40); do
    status=${NINJA_STATUS//%f/$n}
    echo "${status//%t/40}Building C object source/file_$n.c.o"
    if [ -f "$says/build-fails" ] && [ $n -eq 27 ]; then
      echo 'file_27.c:1:1: error: wrong'
      echo 'ninja: build stopped: subcommand failed.'
      exit 1
    fi
  done
fi
END

# run CODE: ./dev build with the fakes; it must end with CODE and print what standard input holds. T stands for a time,
# HERE for the folder.
run() {
  local got=0
  PATH="$folder/fake:$PATH" ./dev build >stdout 2>stderr </dev/null || got=$?
  sed -E -i "s/[0-9]+:[0-9]{2}(;|\$)/T\1/; s|$(pwd -P)|HERE|" stderr
  cat >expected
  if [ $got -ne "$1" ] || [ -s stdout ] || ! diff expected stderr >difference; then
    echo "FAILED, line ${BASH_LINENO[0]}: code $got for $1; expected (<) and printed (>):"
    cat difference stdout
    failures=$((failures + 1))
  fi
}

built='dev: configure release: done in T
dev: build release: [4/40] Building C object source/file_4.c.o
dev: build release: [8/40] Building C object source/file_8.c.o
dev: build release: [12/40] Building C object source/file_12.c.o
dev: build release: [16/40] Building C object source/file_16.c.o
dev: build release: [20/40] Building C object source/file_20.c.o
dev: build release: [24/40] Building C object source/file_24.c.o
dev: build release: [28/40] Building C object source/file_28.c.o
dev: build release: [32/40] Building C object source/file_32.c.o
dev: build release: [36/40] Building C object source/file_36.c.o
dev: build release: [40/40] Building C object source/file_40.c.o
dev: build release: done in T'

touch says/missing
run 0 <<<"$built"
packages=$(wc -l <says/asked)
[ ! -f says/apt-calls ] || { echo "FAILED: nothing is missing, and apt-get was called"; failures=$((failures + 1)); }

printf 'cmake\njq\n' >says/missing
installing="dev: 2 of $packages packages are missing: cmake jq
dev: package lists: done in T
dev: 3 packages are to be installed: these and what they need
dev: packages: 30 %, Retrieving file 1 of 3 (1s remaining)
dev: packages: 60 %, Retrieving file 2 of 3 (1s remaining)
dev: packages: 90 %, Retrieving file 3 of 3 (1s remaining)
dev: packages: 12 %, Unpacking libuv1:amd64 (12)
dev: packages: 50 %, Unpacking libuv1:amd64 (50)"
run 0 <<END
$installing
dev: packages: 100 %, Installed jq
dev: packages: done in T
$built
END

touch says/apt-fails
run 1 <<END
$installing
dev: packages: failed after T; its last lines:
E: Unable to correct problems
dev: all that it printed is in HERE/build/log/packages.log
END
rm says/apt-fails

# Not root: apt-get is called through sudo, and its progress comes through all the same.
fake id <<<'echo 1000'
run 0 <<END
$installing
dev: packages: 100 %, Installed jq
dev: packages: done in T
$built
END
rm fake/id
calls=$(cut -d ' ' -f 1-2 says/sudo-calls)
[ "$calls" = $'true\nsh -c\nsh -c' ] || { echo "FAILED: sudo was called with $calls"; failures=$((failures + 1)); }

: >says/missing
touch says/build-fails
run 1 <<END
$(head -n 7 <<<"$built")
dev: build release: failed after T; its last lines:
[0/2] Re-checking globbed directories...
$(for n in $(seq 27); do echo "[$n/40] Building C object source/file_$n.c.o"; done)
file_27.c:1:1: error: wrong
ninja: build stopped: subcommand failed.
dev: all that it printed is in HERE/build/log/build-release.log
END

touch says/configure-fails
run 1 <<END
dev: configure release: failed after T; its last lines:
-- Configuring done
CMake Error: no compiler
dev: all that it printed is in HERE/build/log/configure-release.log
END
rm says/*-fails

# On a terminal of 30 columns one line is rewritten for each step of the build and stays within 29 of them.
PATH="$folder/fake:$PATH" script -qec 'stty cols 30; ./dev build' /dev/null </dev/null | tr '\r' '\n' |
  sed -E 's/\x1b\[K//; /^$/d; s/[0-9]+:[0-9]{2}$/T/' >stderr
{
  echo 'dev: configure release'
  echo 'dev: configure release: done in T'
  echo 'dev: build release'
  echo 'dev: build release: [0/2] Re-checking' | cut -c -29
  for n in $(seq 40); do echo "dev: build release: [$n/40] Building" | cut -c -29; done
  echo 'dev: build release: done in T'
} >expected
diff expected stderr || { echo "FAILED: on a terminal; expected (<) and printed (>)"; failures=$((failures + 1)); }

[ $failures -eq 0 ] && echo "all checks passed"
exit $((failures > 0))
