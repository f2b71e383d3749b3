# Bash completion of aobudget. It offers commands, flags, and the names that the program itself lists.
_aobudget_names() { # techniques|scenes|lights|backends|profiles|budgets
  "${COMP_WORDS[0]}" list "$1" --json - 2>/dev/null | sed -n 's/^      "name": "\([^"]*\)".*/\1/p'
}

# A flag that was given another name stays in the help, to say so, and is not offered.
_aobudget_flags() {
  "${COMP_WORDS[0]}" "${COMP_WORDS[1]}" --help 2>/dev/null | sed -n '/ is now /d; s/^  \(--*[a-z-]*\).*/\1/p'
}

_aobudget() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
  local words
  if [ "$COMP_CWORD" -eq 1 ]; then
    words="list plan run shot merge report papers compare calibrate cache budget effects tune stress nightly history doctor --help --version"
  elif [ "$command" = history ] && [ "$COMP_CWORD" -eq 3 ]; then
    words="list plot prune export"
  elif [ "$command" = history ]; then
    words=$(_aobudget_flags)
  else
    case $previous in
      --technique) words=$(_aobudget_names techniques) ;;
      --scene) words=$(_aobudget_names scenes) ;;
      --light) words=$(_aobudget_names lights) ;;
      --depth) words="planar distance device device_reversed" ;;
      --normals) words="view world derived" ;;
      --handed) words="right left" ;;
      --backend) words=$(_aobudget_names backends) ;;
      --target-weighting) words="cosine uniform" ;;
      --profile) words=$(_aobudget_names profiles) ;;
      --budget) words=$(_aobudget_names budgets) ;;
      effects) words=$(_aobudget_names scenes) ;;
      tune) words=$(_aobudget_names techniques) ;;
      list) words="techniques scenes lights backends profiles budgets" ;;
      --property) words=$("${COMP_WORDS[0]}" stress --list 2>/dev/null | sed -n 's/^\([a-z0-9_]*\) (.*/\1/p') ;;
      --index) words="modulo xor" ;;
      *)
        case $current in
          -*) words=$(_aobudget_flags) ;;
        esac
        ;;
    esac
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
complete -o default -F _aobudget aobudget
