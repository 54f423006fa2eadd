# SPDX-License-Identifier: LGPL-2.1-or-later
# Completion of signorini's options, parameters and files in bash: source this file, or install the program.

_signorini() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} program=${COMP_WORDS[0]}
  local IFS=$'\n'
  case $before in
    --set | --sweep)
      # "Subsection/Name=", with blanks escaped.
      local names
      names=$("$program" --print-parameters 2>/dev/null | awk '
        $1 == "subsection" { sub(/^subsection /, ""); section = $0 "/" }
        $1 == "end" { section = "" }
        $1 == "set" { sub(/^ *set /, ""); sub(/ *=.*/, ""); print section $0 "=" }')
      mapfile -t COMPREPLY < <(compgen -W "$names" -- "${word//\\/}" | sed 's/[ '"'"']/\\&/g')
      compopt -o nospace
      ;;
    --verify)
      mapfile -t COMPREPLY < <(compgen -f -X '!*.vtu' -- "$word"; compgen -d -- "$word")
      compopt -o filenames
      ;;
    --output) mapfile -t COMPREPLY < <(compgen -d -- "$word") ;;
    *)
      if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$("$program" --help 2>/dev/null | grep -oE '^ +(-h \[ )?--[a-z-]+' | grep -oE -- '--[a-z-]+')" -- "$word")
      else
        mapfile -t COMPREPLY < <(compgen -f -X '!*.prm' -- "$word"; compgen -d -- "$word")
        compopt -o filenames
      fi
      ;;
  esac
}
complete -F _signorini signorini
