# Completion of ribbon-record, ribbon-play and ribbon-convert: options, and the words that they take, as
# their --help tells them; recordings and scenes for the rest.
# shellcheck shell=bash disable=SC2207  # options and words hold no spaces

# _ribbon_kind TOOL OPTION   What the option takes, as in "FILE" or "NAME:{draft,standard,final}".
_ribbon_kind() {
  "$1" --help 2>/dev/null | sed --quiet --regexp-extended "s/^  ([^ ]+,)?$2(,[^ ]+)? ([^ ]+).*/\3/p"
}

_ribbon() {
  local cur prev
  _get_comp_words_by_ref cur prev
  if [[ $cur == -* ]]; then
    COMPREPLY=($(compgen -W "$(_parse_help "$1")" -- "$cur"))
    return
  fi
  local kind='' choices
  [[ $prev != -* ]] || kind=$(_ribbon_kind "$1" "$prev")
  case $kind in
    '' | Needs: | Excludes:)
      if [[ $1 == *ribbon-record ]]; then _filedir '@(toml|rbn)'; else _filedir rbn; fi
      ;;
    FILE* | PATTERN*) _filedir ;;
    *:\{*)
      choices=${kind#*\{}
      choices=${choices%%\}*}
      COMPREPLY=($(compgen -W "${choices//,/ }" -- "$cur"))
      ;;
    *) ;; # a number or a word of the user's own
  esac
}

complete -F _ribbon ribbon-record ribbon-play ribbon-convert
