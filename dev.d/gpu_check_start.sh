#!/bin/sh
# What gpu-check starts with in its folder: it says in one line what this machine lacks to run it at all. gpu_check.sh puts
# the version of glibc in.
needed=@GLIBC@
folder=$(dirname "$(readlink -f "$0")")
lacks() {
  echo "gpu-check: error: $1; it needs a 64-bit x86 Linux with glibc $needed or newer" >&2
  exit 2
}

[ "$(uname -s) $(uname -m)" = "Linux x86_64" ] || lacks "this machine is $(uname -s) $(uname -m)"
version=$(getconf GNU_LIBC_VERSION 2>/dev/null)
older=$(printf '%s\n' "$needed" "${version#glibc }" | sort -t . -k 1,1n -k 2,2n | head -n 1)
[ -z "$version" ] || [ "$older" = "$needed" ] || lacks "this machine has $version"
said=$("$folder/gpu-check-main" --help 2>&1 >/dev/null) || lacks "it cannot be started here ($(printf '%s' "$said" | tr '\n' ' '))"
exec "$folder/gpu-check-main" "$@"
