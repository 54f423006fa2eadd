#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Wrong input over the program itself: exit code 1, one line, nothing left behind. Every twentieth block of the table, and
# what only the program meets.
# usage: binary.sh PROGRAM

program=$(realpath "$1")
table=$(dirname "$(realpath "$0")")/wrong_files.txt
. "$(dirname "$0")/../../checks.bash"

# Where something was set is the business of wrong_files.cc.
without_place() {
  sed -E -e 's/[0-9.]+ GiB of memory/{memory} of memory/' -e 's/^signorini: (--set|good\.prm(:[0-9]+)?): /signorini: /' "$1"
}

# refuse LATE MESSAGE ARGUMENTS...: MESSAGE is all that is said.
refuse() {
  local late=$1 message=$2
  shift 2
  timeout 60 "$program" "$@" >stdout 2>stderr </dev/null
  local code=$?
  check "exit code 1: $message" [ "$code" -eq 1 ]
  check "  one line" one_line_of_complaint
  check "  that sentence" [ "$(without_place stderr)" = "signorini: $message" ]
  if [ "$late" = no ]; then check "  and prints nothing else" is_empty stdout; fi
  check "  and leaves nothing behind" only_the_inputs
}

cat >good.prm <<'PRM'
subsection Boundary
  set Clamped = top
  set Contact = bottom
end
subsection Load
  set Body force = 0; -1
end
subsection Discretization
  set Finest level = 3
end
PRM
head -c 2000000 /dev/zero | tr '\0' '#' >large.prm
mkfifo pipe.prm
sed 's/0; -1/0/' good.prm >$'two\nlines.prm'
touch stdout stderr
inputs=$(ls -A)

arguments=() settings=0 count=0
while IFS= read -r line; do
  case $line in
    '' | '#'*) ;;
    '|'*) settings=0 arguments=(file) ;;
    '>'*)
      count=$((count + 1))
      message=${line#* }
      if [ "$settings" -gt 0 ] && { [ $((count % 20)) -eq 0 ] || [[ $line = '>>'* ]]; }; then
        refuse "$(if [[ $line = '>>'* ]]; then echo yes; else echo no; fi)" \
          "$(sed -E 's/^(@|bad\.prm): //' <<<"$message")" good.prm "${arguments[@]}"
      fi
      arguments=() settings=0
      ;;
    *'{'[0-9]* | *'\x'*) arguments=(file) settings=-100 ;;
    *)
      settings=$((settings + 1))
      arguments+=(--set "$(sed 's/ = */=/' <<<"$line")")
      ;;
  esac
done <"$table"
check "the table was read" [ "$count" -ge 150 ]

refuse no '/dev/zero: this is a device or a pipe, allowed: a file of text on a disk.' /dev/zero
refuse no 'pipe.prm: this is a device or a pipe, allowed: a file of text on a disk.' pipe.prm
refuse no 'large.prm: this file has 2000000 bytes, allowed: at most 1000000.' large.prm
refuse no "two?lines.prm:6: Load/Body force: found 1 component(s) in '0', allowed: 2 expressions separated by ';'." \
  $'two\nlines.prm'
refuse no "Contact/Gap: found the value nan of component 1 at (0.0001 0), allowed: values up to 1e+30 on the whole body." \
  good.prm --set Contact/Gap=0/0
echo "$failures failures"
[ "$failures" -eq 0 ]
