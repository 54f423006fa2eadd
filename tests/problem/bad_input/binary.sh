#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Wrong input over the program itself: exit code 1, one line, nothing left behind. Every twentieth block of the table, all that
# only a level refuses, and what only the program meets. One start gets the files of the first kind, another one those of the
# second.
# usage: binary.sh PROGRAM

program=$(realpath "$1")
table=$(dirname "$(realpath "$0")")/wrong_files.txt
. "$(dirname "$0")/../../checks.bash"

start() { timeout 600 "$program" "$@" >stdout 2>stderr </dev/null; }
# The line of a file is the business of wrong_files.cc.
without_line() {
  sed -E -e 's/[0-9.]+ GiB of memory/{memory} of memory/' -e 's/^(signorini: [0-9]+\.prm):[0-9]+: /\1: /' stderr
}
same_lines() { diff "$1" "$2"; }

# refuse LATE MESSAGE SETTING: a start for one scene, which is set on the command line. MESSAGE is all that is said.
refuse() {
  start good.prm --set "$3"
  check "exit code 1: $2" [ $? -eq 1 ]
  check "  one line" one_line_of_complaint
  check "  that sentence" [ "$(cat stderr)" = "signorini: --set: $2" ]
  if [ "$1" = no ]; then check "  and prints nothing else" is_empty stdout; fi
  check "  and leaves nothing behind" only_the_inputs
}

# refuse_all KIND: one start for all files of the list, which gives KIND.messages and, at the end of the output, KIND.codes.
refuse_all() {
  local files
  mapfile -d '' -t files <"$1.files"
  start "${files[@]}"
  check "${#files[@]} files: exit code 1" [ $? -eq 1 ]
  check "  a sentence for each" [ "$(grep -c '^signorini: .*[.)]$' stderr)" -eq "${#files[@]}" ]
  check "  those of the table" same_lines "$1.messages" <(without_line)
  check "  exit code 1 for each" same_lines "$1.codes" <(tail -n "$(wc -l <"$1.codes")" stdout)
  if [ "$1" = early ]; then check "  and prints nothing else" same_lines early.codes <(tail -n +2 stdout); fi
  check "  and leaves nothing behind" only_the_inputs
}

# expect KIND FILE NAME MESSAGE: a file that is refused; NAME is what messages call it.
expect() {
  local name=${2##*/}
  printf '%s\0' "$2" >>"$1.files"
  printf 'signorini: %s: %s\n' "$3" "$4" >>"$1.messages"
  printf '%s: wrong input, exit code 1, results/%s\n' "$2" "${name%.prm}" >>"$1.codes"
}

declare -A value
start_block() {
  paths=(Boundary/Clamped Boundary/Contact 'Load/Body force' 'Discretization/Finest level')
  value=([Boundary/Clamped]=top [Boundary/Contact]=bottom ['Load/Body force']='0; -1' ['Discretization/Finest level']=3)
  settings=0
}
write_block() {
  local path
  for path in "${paths[@]}"; do
    case $path in
      */*) printf 'subsection %s\nset %s = %s\nend\n' "${path%%/*}" "${path#*/}" "${value[$path]}" ;;
      *) printf 'set %s = %s\n' "$path" "${value[$path]}" ;;
    esac
  done
}
start_block
write_block >good.prm

count=0
while IFS= read -r line; do
  case $line in
    '' | '#'*) ;;
    '>'*)
      count=$((count + 1))
      message=${line#* }
      message=${message#@: }
      kind=early
      if [[ $line = '>>'* ]]; then kind=late; fi
      if [ "$settings" -gt 0 ] && { [ $((count % 20)) -eq 0 ] || [ "$kind" = late ]; }; then
        write_block >"$count.prm"
        expect "$kind" "$count.prm" "$count.prm" "${message#bad.prm: }"
      fi
      start_block
      ;;
    # A whole file, or one with characters that the table does not write.
    '|'* | *'{'[0-9]* | *'\x'*) settings=-100 ;;
    *)
      settings=$((settings + 1))
      path=${line%%=*}
      path=${path% }
      if [ -z "${value[$path]+set}" ]; then paths+=("$path"); fi
      value[$path]=${line#*=}
      value[$path]=${value[$path]# }
      ;;
  esac
done <"$table"
check "the table was read" [ "$count" -ge 150 ]

expect early /dev/zero /dev/zero 'this is a device or a pipe, allowed: a file of text on a disk.'
mkfifo pipe.prm
expect early pipe.prm pipe.prm 'this is a device or a pipe, allowed: a file of text on a disk.'
head -c 2000000 /dev/zero | tr '\0' '#' >large.prm
expect early large.prm large.prm 'this file has 2000000 bytes, allowed: at most 1000000.'
sed 's/0; -1/0/' good.prm >$'two\nlines.prm'
expect early $'two\nlines.prm' 'two?lines.prm:8' \
  "Load/Body force: found 1 component(s) in '0', allowed: 2 expressions separated by ';'."
touch stdout stderr
inputs=$(ls -A)

refuse_all early
refuse_all late
refuse no "Contact/Gap: found the value nan of component 1 at (0.0001 0), allowed: values up to 1e+30 on the whole body." \
  Contact/Gap=0/0
refuse yes "Discretization/Patches: found 33 patches on the 8 contact faces of the finest level, allowed: at most 4 per face." \
  Discretization/Patches=33
echo "$failures failures"
[ "$failures" -eq 0 ]
