#!/usr/bin/env bash
# Completion and man page know every command, and complete what the program lists.
source "$(dirname "$0")/lib.sh"
source "$(dirname "$0")/../../share/aobudget.bash"
man=$(dirname "$0")/../../share/aobudget.1
commands=$("$program" --help | sed -n 's/^  \([a-z]*\)  *.*/\1/p')
check "there are commands" test "$(wc -w <<<"$commands")" -ge 6
complete_line() { # WORDS...: the last is being typed
  COMP_WORDS=("$program" "$@")
  COMP_CWORD=$#
  COMPREPLY=()
  _aobudget
  printf '%s\n' "${COMPREPLY[@]}"
}
for command in $commands; do
  check "the completion knows $command" grep -qx "$command" <(complete_line "")
  check "the man page knows $command" grep -qE "^\.BI? $command\b" "$man"
done
check "techniques" grep -qx gtao <(complete_line shot --technique g)
check "what is tuned" grep -qx alchemy <(complete_line tune al)
check "scenes" grep -qx corner <(complete_line shot --scene co)
check "backends" grep -qx gl-egl <(complete_line shot --backend "")
check "flags" grep -qx -- --reference-spp <(complete_line shot --re)
check "no flag of an old name" test "$(complete_line shot --re)" = --reference-spp
check "weightings" test "$(complete_line shot --target-weighting u)" = uniform
for flag in $("$program" shot --help | sed -n '/ is now /d; s/^  \(--*[a-z-]*\).*/\1/p'); do
  check "the man page knows $flag" grep -qF -- "${flag//-/\\-}" "$man"
done
check "what a history does" test "$(complete_line history h.db "" | xargs)" = "list plot prune export"
check "its flags" grep -qx -- --keep <(complete_line history h.db prune --)
check "nothing foreign" test -z "$(complete_line shot --technique xyz | tr -d '\n')"
finish
