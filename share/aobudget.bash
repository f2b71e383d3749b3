# Bash completion of aobudget: commands, flags, and the names that the program itself lists.
_aobudget_names() { # techniques|scenes|backends
  "${COMP_WORDS[0]}" list "$1" --json - 2>/dev/null | sed -n 's/^      "name": "\([^"]*\)".*/\1/p'
}

_aobudget() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
  local words
  if [ "$COMP_CWORD" -eq 1 ]; then
    words="list plan run shot report papers doctor --help --version"
  else
    case $previous in
      --technique) words=$(_aobudget_names techniques) ;;
      --scene) words=$(_aobudget_names scenes) ;;
      --depth) words="planar distance device device_reversed" ;;
      --normals) words="view world derived" ;;
      --handed) words="right left" ;;
      --backend) words=$(_aobudget_names backends) ;;
      list) words="techniques scenes backends" ;;
      *)
        case $current in
          -*) words=$("${COMP_WORDS[0]}" "$command" --help 2>/dev/null | sed -n 's/^  \(--*[a-z-]*\).*/\1/p') ;;
        esac
        ;;
    esac
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
complete -o default -F _aobudget aobudget
