#!/usr/bin/env bash
# gpu_check.sh BUILD CONFIGS DIR: lays gpu-check out as one folder that runs on a machine with a GPU's driver and a glibc that
# is not older than what it was built with: the program behind gpu_check_start.sh, what it was linked with and such a machine
# may lack (lib/; the loaders of Vulkan and EGL in folders of their own, used where the machine has none), the images and
# G-buffers that it compares with (data/, made anew on the software driver from CONFIGS/*.yaml), and the licences of all
# that. DIR must not exist, or be such a folder.
set -euo pipefail
build=$(realpath "$1") configs=$(realpath "$2") target=$(realpath -m "$3")
runs=$(mktemp -d)
trap 'rm -rf "$runs"' EXIT
folder=$runs/pack

if [ -e "$target" ] && [ ! -e "$target/data/check.json" ]; then
  echo "gpu-check: $target exists and is no packed gpu-check: choose another folder" >&2
  exit 2
fi

images=()
for config in "$configs"/*.yaml; do
  name=$(basename "$config" .yaml)
  "$build/aobudget" run "$config" --device llvmpipe --out "$runs/$name" --quiet
  [ "$name" = times ] || images+=("$runs/$name")
done
"$build/gpu-check-data" "$folder/data" "$runs/times" "${images[@]}"

packages=(libjansson-dev libxxhash-dev glslang-dev spirv-tools libstdc++-12-dev) # archives that are linked
lay() { # FOLDER FILE: a library of the system, and its package's licence
  mkdir -p "$folder/$1"
  cp -L "$2" "$folder/$1/"
  packages+=("$(dpkg -S "*/$(basename "$(realpath "$2")")" | cut -d: -f1 | head -n 1)")
}
needed() { ldd "$1" | sed -n "s|.* => \\(/.*/$2[-.][^ ]*\\) (.*|\\1|p"; } # FILE NAME: where FILE finds lib NAME

strip -o "$folder/gpu-check-main" "$build/gpu-check"
strip -o "$folder/gpu-check-device" "$build/gpu-check-device"
lay lib "$(needed "$build/gpu-check-device" libOpenEXRCore)"
lay lib "$(needed "$build/gpu-check-device" libz)"
lay lib/vulkan "$(needed "$build/gpu-check-device" libvulkan)"
egl=$(ldconfig -p | sed -n 's|.*libEGL\.so\.1 (libc6,x86-64.*) => ||p' | head -n 1)
lay lib/egl "$egl"
lay lib/egl "$(needed "$egl" libGLdispatch)"
glibc=$(find "$folder" -type f \( -perm -u+x -o -name '*.so*' \) -exec readelf -V {} + |
  sed -n 's/.*Name: GLIBC_\([0-9.]*\) .*/\1/p' | sort -V | tail -n 1)
sed "s/@GLIBC@/$glibc/" "$(dirname "$0")/gpu_check_start.sh" >"$folder/gpu-check"
chmod +x "$folder/gpu-check"
mkdir -p "$folder/licences"
for package in $(printf '%s\n' "${packages[@]}" | sort -u); do
  cp -L "/usr/share/doc/$package/copyright" "$folder/licences/$package"
done
rm -rf "$target"
mkdir -p "$(dirname "$target")"
mv "$folder" "$target"
