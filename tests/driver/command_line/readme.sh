#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# The README's first run prints the numbers that stand there, times excepted.
# usage: readme.sh PROGRAM ROOT

program=$(realpath "$1")
readme=$(realpath "$2")/README.md
scene=$(realpath "$2")/prm/block_on_parabola.prm
. "$(dirname "$0")/../../checks.bash"

# table: its rows in the text on standard input, from its heading to the first empty line. numbers: all of the table and of what follows.
table() { sed -n '/^ *level  *dofs/,/^ *$/p' | tr -s ' ' | sed 's/^ //'; }
numbers() {
  sed -n '/^ *level  *dofs/,/Certified:/p' | grep -v 'Time =\|Results in' |
    grep -oE '(^|[ (])[-+]?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?' | tr -d ' (+'
}

"$program" "$scene" --set Output/VTU=none --output results >stdout 2>stderr
check "the first run is certified" [ $? -eq 0 ]
check "the table of levels" diff <(table <"$readme") <(table <stdout)
numbers <"$readme" >expected
check "the answer, $(wc -l <expected) numbers" diff expected <(numbers <stdout)
check "  and as many as there are quantities" [ "$(wc -l <expected)" -gt 80 ]
echo "$failures failures"
[ "$failures" -eq 0 ]
