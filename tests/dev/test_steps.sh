#!/usr/bin/env bash
# What ./dev prints, with an apt-get, a dpkg-query, a cmake and a sudo of our own: a copy of ./dev runs whole, not on a
# terminal. Fakes say what the real ones say; sudo closes files and drops the environment as the real one does.
set -u
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" "$folder/tree"
cp -r "$here/../../dev" "$here/../../dev.d" "$folder/tree"
failures=0

fake() { # NAME: the script is on standard input
  { echo '#!/usr/bin/env bash'; cat; } >"$folder/bin/$1"
  chmod +x "$folder/bin/$1"
}

# says 'WHAT' CODE [LINE...]: ./dev build ends with CODE and prints exactly these lines; seconds are not compared.
says() {
  local what=$1 code=$2 got=0
  shift 2
  printf '%s\n' "$@" >"$folder/expected"
  PATH="$folder/bin:$PATH" bash "$folder/tree/dev" build >"$folder/said" 2>&1 </dev/null || got=$?
  sed -i -E 's/(took|after) [0-9]+ s/\1 N s/' "$folder/said"
  if [ $got -ne "$code" ] || ! diff "$folder/expected" "$folder/said"; then
    echo "FAILED: $what: exit code $got, expected $code"
    failures=$((failures + 1))
  fi
}

fake id <<<'echo 1000'
fake sudo <<<'exec env -i PATH="$PATH" "$@" 3>&- 4>&-'
fake dpkg-query <<'EOS'
shift 2 # -W -f=...
for p in "$@"; do
  case $p in jq|g++) ;; cmake) echo "$p deinstall ok config-files" ;; *) echo "$p install ok installed" ;; esac
done
exit 1 # as dpkg-query does where it misses one
EOS
fake apt-get <<EOS
printf '%s\n' "\$*" "\${DEBIAN_FRONTEND:-unset}" >>"$folder/apt"
echo "Reading package lists..."
[[ "\$*" == *install* ]] || exit 0
for n in 1 9 11 12 100; do echo "dlstatus:1:\$n.5000:Retrieving file \$n" >&3; done
for n in 0 4 57 58 100; do echo "pmstatus:libc6:amd64:\$n.0000:Unpacking step \$n: cmake (amd64)" >&3; done
EOS
fake cmake <<'EOS'
[ "$1" = --preset ] && { echo "-- Configuring done"; exit 0; }
echo "[0/2] Re-checking globbed directories..."
echo "[1/20] Building C object CMakeFiles/core.dir/harness/a.c.o"
echo "[2/20] Building C object reports/plot/CMakeFiles/plot.dir/plot.c.o"
echo "[3/20] Generating shaders.h"
echo "[20/20] Linking C executable aobudget"
EOS

packages=(
  'dev: 3 of 42 packages are missing: cmake g++ jq'
  'dev: reading the package lists'
  'dev: reading the package lists took N s'
  'dev: installing the packages and what they need'
)
installed=(
  'dev: downloading, 1 %: Retrieving file 1'
  'dev: downloading, 11 %: Retrieving file 11'
  'dev: downloading, 100 %: Retrieving file 100'
  'dev: installing, 0 %: Unpacking step 0: cmake (amd64)'
  'dev: installing, 57 %: Unpacking step 57: cmake (amd64)'
  'dev: installing, 100 %: Unpacking step 100: cmake (amd64)'
  'dev: installing the packages and what they need took N s'
)
configured=('dev: configuring release' 'dev: configuring release took N s' 'dev: building release')
says "all goes well" 0 "${packages[@]}" "${installed[@]}" "${configured[@]}" \
  'dev: [1/20] harness/a.c.o' 'dev: [2/20] plot.c.o' 'dev: [20/20] Linking C executable aobudget' \
  'dev: building release took N s'
cat >"$folder/expected" <<'EOS'
-o APT::Status-Fd=3 update
noninteractive
-o APT::Status-Fd=3 install -y --no-install-recommends cmake g++ jq
noninteractive
EOS
diff "$folder/expected" "$folder/apt" || { echo "FAILED: apt-get is called so"; failures=$((failures + 1)); }

fake apt-get <<'EOS'
[[ "$*" == *install* ]] || exit 0
echo "pmstatus:jq:50.0000:Unpacking jq" >&3
echo "E: You don't have enough free space" >&2
exit 100
EOS
says "a package that cannot be installed" 100 "${packages[@]}" 'dev: installing, 50 %: Unpacking jq' \
  "E: You don't have enough free space" \
  "dev: installing the packages and what they need failed after N s with exit code 100; the whole output is in $folder/tree/build/log/packages.log"

fake dpkg-query <<<'shift 2; printf "%s install ok installed\n" "$@"'
fake cmake <<'EOS'
[ "$1" = --preset ] && exit 0
echo "[1/2] Building C object CMakeFiles/core.dir/a.c.o"
echo "FAILED: CMakeFiles/core.dir/b.c.o"
echo "b.c:7:3: error: expected ';'"
echo "ninja: build stopped: subcommand failed."
exit 1
EOS
says "nothing is missing, a file does not compile" 1 "${configured[@]}" 'dev: [1/2] a.c.o' \
  'FAILED: CMakeFiles/core.dir/b.c.o' "b.c:7:3: error: expected ';'" 'ninja: build stopped: subcommand failed.' \
  "dev: building release failed after N s with exit code 1; the whole output is in $folder/tree/build/log/build-release.log"
if ! grep -qxF '[1/2] Building C object CMakeFiles/core.dir/a.c.o' "$folder/tree/build/log/build-release.log"; then
  echo "FAILED: the log holds all of the output"
  failures=$((failures + 1))
fi

# A terminal of 30 columns: one line, rewritten and never as wide as the terminal, so that it does not wrap.
fake cmake <<'EOS'
[ "$1" = --preset ] && exit 0
echo "[1/2] Building C object CMakeFiles/core.dir/harness/a_file_of_a_long_name.c.o"
echo "[2/2] Linking C executable aobudget"
EOS
PATH="$folder/bin:$PATH" TERM=xterm script -qec "stty cols 30; bash '$folder/tree/dev' build" "$folder/typescript" >/dev/null </dev/null
grep -v '^Script' "$folder/typescript" | tr '\r' '\n' | sed -E 's/took [0-9]+ s/took N s/; s/\x1b\[K/<clear>/; /^$/d' >"$folder/said"
cat >"$folder/expected" <<'EOS'
dev: configuring release
<clear>dev: configuring release took N s
dev: building release
<clear>dev: [1/2] harness/a_file_of_
<clear>dev: [2/2] Linking C executab
<clear>dev: building release took N s
EOS
diff "$folder/expected" "$folder/said" || { echo "FAILED: on a terminal"; failures=$((failures + 1)); }

[ $failures -eq 0 ] && echo "all checks passed"
exit $((failures > 0))
