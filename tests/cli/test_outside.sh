#!/usr/bin/env bash
# A module from outside, made of the installed files only; docs/adding-a-technique.md shows its code and builds it.
source "$(dirname "$0")/lib.sh"
tree=$(realpath "$(dirname "$0")/../..")
tutorial=$tree/docs/adding-a-technique.md
export prefix=$folder/prefix
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
export ASAN_OPTIONS=detect_leaks=0 # drivers are loaded here

check "install" cmake --install "$AOBUDGET_BUILD" --prefix "$prefix"
mv "$prefix" "$folder/moved" && prefix=$folder/moved # nothing may name where it was
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
cp -r "$tree/examples/outside" "$folder/outside"
cd "$folder/outside"
program=$prefix/bin/aobudget

# What is installed stands alone.
for file in bin/aobudget bin/aobudget-plot lib/libaoviz.so lib/aobudget/modules/gtao.so include/aobudget/technique.h \
  include/aobudget/steps.h share/aobudget/shaders/common/noise.glsl \
  share/aobudget/shaders/steps/blur.glsl share/aobudget/slurm/aobudget-sweep.sbatch \
  share/aobudget/parallel/aobudget-sweep.sh lib/cmake/aobudget/aobudgetConfig.cmake; do
  check "$file" test -s "$prefix/$file"
done
# A path is named where it begins and ends as one: in a tree at /aobudget, share/aobudget is none of its paths.
names() { # PATH: whether a text file of the prefix names it
  local quoted
  quoted=$(sed 's/[][\\.*^$+?(){}|/]/\\&/g' <<<"$1")
  grep -rIE "(^|[^[:alnum:]_./}>]|-[IL])$quoted(/|[^[:alnum:]_.-]|$)" "$prefix"
}
nowhere() { ! names "$1"; }
check "no path of the tree" nowhere "$tree"
check "no path of the build" nowhere "$AOBUDGET_BUILD"
for named in "$folder/a tree" /aobudget; do
  for text in "$named" "include=$named/include" "-I$named/include" "(\"$named\")"; do
    echo "$text" >"$prefix/planted"
    check "a path is found in $text" names "$named"
  done
done
rm "$prefix/planted"
check "the plotter finds its library" bash -c "ldd '$prefix/bin/aobudget-plot' | grep -F 'libaoviz.so => $prefix/'"
check "the plotter starts" bash -c "echo '{\"figures\": []}' | '$prefix/bin/aobudget-plot'"
# Modules link what they use: the loader finds every symbol in what each one names.
links() { # FILE.so: all that it needs is in what it names
  local missing used
  missing=$(ldd -r "$1" 2>&1 | grep -E 'undefined symbol|not found')
  used=$(nm -D --undefined-only "$1" | grep -cE ' (sqrt|exp|exp2|pow|cos|sin|acos|atan|log|log2)f?@')
  [ -z "$missing" ] && { [ "$used" -eq 0 ] || readelf -d "$1" | grep -qF '[libm.so.6]'; } && return
  echo "$missing; $used functions of libm"
  return 1
}
gcc -shared -fPIC -xc - -o "$folder/unlinked.so" <<<'double sqrt(double); double f(double x); double f(double x) { return sqrt(x); }'
for module in "$prefix"/lib/aobudget/modules/*.so; do
  check "$(basename "$module") links what it uses" links "$module"
done
check "some of them use libm" bash -c "readelf -d '$prefix'/lib/aobudget/modules/*.so | grep -F '[libm.so.6]'"
unlinked() { ! links "$folder/unlinked.so"; }
check "one that does not is found" unlinked
check "an installed built-in" "$program" list techniques --module "$prefix/lib/aobudget/modules/gtao.so"

# The tutorial shows the files, and the files hold nothing that it does not show.
awk '/^```/ { on = 0; if ($0 ~ /^```[a-z]/) { on = 1; file = sprintf("%s/block%02d.%s", out, ++n, substr($0, 4)) } next }
  on { print > file }' out="$folder" "$tutorial"
shows() { # BLOCK: it stands in one of the files as it is
  local block file
  block=$(cat "$1")
  for file in CMakeLists.txt sweep.yaml depth_unsharp.c shaders/*.glsl; do
    [[ "$(cat "$file")" == *"$block"* ]] && return
  done
  cat "$1"
  return 1
}
check "the tutorial has its blocks" test "$(ls "$folder"/block*.{c,glsl,cmake,yaml} | wc -l)" -ge 8
for block in "$folder"/block*.{c,glsl,cmake,yaml}; do
  check "$(basename "$block") of the tutorial is the example's" shows "$block"
done
cat "$folder"/block*.{c,glsl,cmake,yaml} | grep . >"$folder/shown"
for file in CMakeLists.txt sweep.yaml depth_unsharp.c shaders/*.glsl; do
  check "the tutorial shows all of $file" bash -c "! grep . '$file' | grep -vxFf '$folder/shown'"
done

# Its commands, as they stand; without drivers those up to the first drawing.
module=build/depth_unsharp.so
shot=("$program" shot --technique depth_unsharp --module $module --scene corner --size 96x54)
drivers=yes
for backend in vulkan gl-egl; do
  "$program" shot --technique none --scene plane --size 8x8 --reference-spp 0 --backend $backend >/dev/null 2>&1 || drivers=
done
for block in "$folder"/block*.sh; do
  [ -z "$drivers" ] && ! grep -qE 'cmake|null' "$block" && continue
  check "$(basename "$block") of the tutorial" bash -euo pipefail "$block"
done
check "listed with its table" bash -c "'$program' list techniques --module $module | grep -F 'Two standard deviations'"
check "null" "${shot[@]}" --backend null --reference-spp 0
check "null, plain gcc" "${shot[@]}" --backend null --reference-spp 0 --module plain/depth_unsharp.so
expect 2 "blur: 2: must be odd, or 0" "${shot[@]}" --backend null -p blur=2
if [ -n "$drivers" ]; then
  figure() { # FIELD ARGUMENTS...: of the record; the oracle's of that name comes later in it
    local field=$1
    shift
    "$program" shot --size 96x54 --backend gl-egl --reference-spp 64 --json - "$@" | grep -m1 -oE "\"$field\": ?[-0-9.e]+" | grep -oE '[-0-9.e]+$'
  }
  ours=$(figure rmse --technique depth_unsharp --module plain/depth_unsharp.so --scene corner -p kernel=8)
  none=$(figure rmse --technique none --scene corner --target-radius 0.5)
  plane=$(figure rmse --technique depth_unsharp --module $module --scene plane)
  # A text of the module is traced as it is: its own depth, eight pairs of taps, and aob_is_sky.
  check "its fetches" bash -c "'$program' cache --technique depth_unsharp --module $module --scene corner --size 96x54 \
    --backend gl-egl -p blur=0 --profile generic | grep -F 'fetched 93312 times, 18 a pixel;'"
  check "better than nothing: $ours < 0.6 x $none" awk "BEGIN { exit !($ours > 0 && $ours < 0.6 * $none) }"
  check "an open plane stays open: $plane" awk "BEGIN { exit !(\"$plane\" != \"\" && $plane < 0.001) }"
fi

# A function that nobody has is an error of the linker, and a module's own come before those of the program's libraries.
for built in "$module" plain/depth_unsharp.so "$prefix/lib/aobudget/modules/gtao.so"; do
  check "$built finds its own names first" bash -c "readelf -d '$built' | grep -qw SYMBOLIC"
done
plain() { # OUT FLAGS...: the loop of tests/modules with the flags of pkg-config; it has a function of libjansson's name
  local out=$1
  shift
  gcc -std=c11 -O2 -shared -fPIC -DLOOP_TRIPS=2 -DLOOP_WORK=2 -DLOOP_SHIFT=5 -Dloop_shift=json_true "$@" \
    $(pkg-config --cflags aobudget) "$tree/tests/modules/loop/loop.c" -o "$out" 2>&1
}
# shellcheck disable=SC2046 # words of pkg-config
plain clash.so -Dloop_turns=json_false $(pkg-config --libs aobudget)
plain lost.so -Dloop_turns=json_false
if [ -n "$drivers" ]; then
  shown() { "$program" shot --technique loop --module "$1" --scene corner --size 32x18 --backend gl-egl --reference-spp 0; }
  lost() { ! shown lost.so; }
  check "a name of a library's" shown clash.so
  check "which is lost without those flags" lost
fi
undefined() { # COMMAND...: fails, and names the function
  ! "$@" >"$folder/.link" 2>&1 && grep -qF "undefined reference to \`nobody_has_this'" "$folder/.link"
}
cp depth_unsharp.c depth_unsharp.good
echo 'void nobody_has_this(void); void calls_it(void); void calls_it(void) { nobody_has_this(); }' >>depth_unsharp.c
check "CMake: an undefined symbol is an error" undefined cmake --build build
check "pkg-config: so is it" undefined gcc -std=c11 -shared -fPIC -Iplain $(pkg-config --cflags aobudget) depth_unsharp.c \
  -o plain/undefined.so $(pkg-config --libs aobudget)
mv depth_unsharp.good depth_unsharp.c && touch depth_unsharp.c
check "and good again" cmake --build build

# What is no module of this interface: one line, code 2.
strip --strip-all -o stripped.so $module
check "stripped of debug symbols, it still is one" "$program" list techniques --module stripped.so
echo 'int nothing;' | gcc -x c -shared -fPIC - -o empty.so
expect 2 "exports no symbol aob_module" "$program" list techniques --module empty.so
cp -r "$prefix/include" old
sed -i 's/AOB_ABI [0-9]*u/AOB_ABI 77u/' old/aobudget/technique.h
gcc -std=c11 -shared -fPIC -Iplain -Iold depth_unsharp.c -o old.so -lm
abi=$(sed -nE 's/^#define AOB_ABI ([0-9]+)u.*/\1/p' "$prefix/include/aobudget/technique.h")
expect 2 "made for module interface 77, this program has $abi: build it again" "${shot[@]:0:4}" --scene corner --module old.so
expect 2 "is it a file" "$program" list techniques --module build
expect 2 "cannot load the module" "$program" list techniques --module CMakeLists.txt
head -c 4096 $module >cut.so
expect 2 "cut.so" "$program" list techniques --module cut.so

# Mistakes of an author are named when the module is built.
echo '#include "common/nose.glsl"' >shaders/broken.glsl
check "a missing include is named" bash -c "! cmake --build build && cmake --build build | grep -F 'common/nose.glsl'"
echo '#include "broken.glsl"' >shaders/broken.glsl
check "so is one of itself" bash -c "cmake --build build 2>&1 | grep -F 'include itself'"
finish
