#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# The paper as one program and the library compute the same numbers, by different code.
# usage: luo_liang.sh PROGRAM ROOT

program=$(realpath "$1")
luo_liang=$(dirname "$program")/tutorial/luo_liang
folder=$(realpath "$2")/source/luo_liang
source=$folder/luo_liang.cc
scene=$(realpath "$2")/prm/a1_psor.prm
. "$(dirname "$0")/../../checks.bash"

# errors_of: the rows of the table of errors in the text on standard input, which may be a comment.
errors_of() { sed 's,^// *,,' | awk '$1 == "level" && $2 == "u_h1" { inside = 1; next } inside && !/^ *[0-9]/ { exit } inside { $1 = $1; print }'; }
# betas_of: the rows of the table of inf-sup constants.
betas_of() { sed 's,^// *,,' | awk '/^ *1\/[0-9]+ +0/ { $1 = $1; print }'; }

"$luo_liang" >stdout 2>stderr
check "runs without parameters" [ $? -eq 0 ]
check "  and leaves no files" [ "$(ls)" = "$(printf 'stderr\nstdout')" ]
check "  five levels of errors" [ "$(errors_of <stdout | wc -l)" -eq 5 ]
check "  which are those of its last comment" diff <(errors_of <"$source") <(errors_of <stdout)
check "  and so are the inf-sup constants" diff <(betas_of <"$source") <(betas_of <stdout)
check "  on five levels" [ "$(betas_of <stdout | wc -l)" -eq 5 ]

printf 'set Finest level = 5\nset Digits = 15\nset Write VTU = true\n' >digits.prm
"$luo_liang" digits.prm >table 2>stderr
check "runs with parameters" [ $? -eq 0 ]
check "  and writes four levels" [ "$(ls solution-0[2-5].vtu | wc -l)" -eq 4 ]
"$program" "$scene" --set 'Discretization/Coarsest level=2' --set 'Discretization/Finest level=5' --output run >stdout 2>stderr
check "the same scene by the library" [ $? -eq 0 ]

# Every column of both, but the residual, which is rounding. The table of errors has an order behind each number.
compare() {
  awk '
    FNR == NR { n = split($0, field, ","); if (FNR == 1) split($0, name, ",")
                for (i = 1; i <= n && FNR > 1; ++i) value[field[1], name[i]] = field[i]; next }
    $1 == "level" { columns = split($0, column, " "); step = column[2] == "u_h1" ? 2 : 1; next }
    $1 ~ /^[0-9]+$/ && columns > 0 {
      for (i = 2; i <= columns; ++i) {
        if (column[i] == "kkt") continue
        here = $(2 + step * (i - 2)); there = value[$1, column[i]]; ++compared
        if (there == "" || (here - there)^2 > 1e-20 * there^2) { print "level", $1, column[i] ":", here, there; ++different }
      } }
    END { print compared, "compared"; exit different > 0 || compared != 60 }' "$@"
}
check "15 columns on four levels agree to 1e-10" compare run/convergence.csv table

# A longer body has the same exact pressure.
printf 'set Length = 2\nset Coarsest level = 4\nset Finest level = 4\n' >long.prm
"$luo_liang" long.prm >stdout 2>stderr
check "a body of two squares" [ $? -eq 0 ]
check "  with the contact force 0.625" grep -q '^ *4 *512 *1122 *16 .* 6.251e-01 ' stdout

python3 "$folder/page.py" "$luo_liang" page >stdout 2>stderr
check "makes a page" [ $? -eq 0 ]
check "  with all headings" [ "$(grep -c '<h[123] ' page/index.html)" -eq "$(grep -c '^// @sect' "$source")" ]
check "  set formulas" grep -q '∫<sub>Ω</sub>' page/index.html
check "  figures" [ "$(grep -o 'src="[a-z]*.svg"' page/index.html | tr '\n' ' ')" = 'src="pressure.svg" src="deformed.svg" ' ]
check "  one of pressures" grep -q '<polyline' page/pressure.svg
check "  and one of the mesh" grep -q '<polygon' page/deformed.svg
check "  and no marks of the source" [ "$(grep -c '@sect\|@figure' page/index.html)" -eq 0 ]
cmake -S "$folder" -B alone -G Ninja >stdout 2>stderr
check "stands alone" [ $? -eq 0 ]

printf 'set Patch ratio = 3\n' >wrong.prm
"$luo_liang" wrong.prm >stdout 2>stderr
check "refuses patches of 4/3 edges" [ $? -eq 1 ]
check "  and says why" grep -q 'the Patch ratio must divide' stderr
echo "$failures failures"
[ "$failures" -eq 0 ]
