#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# The same run gives the same digits, with any number of threads; with several ranks they differ by rounding.
# usage: same_digits.sh PROGRAM ROOT MPIRUN

program=$(realpath "$1")
scenes=$(realpath "$2")/prm
mpirun=$3
. "$(dirname "$0")/results.bash"
# The other tests keep the BLAS to one thread.
unset OPENBLAS_NUM_THREADS OMP_WAIT_POLICY

# largest_difference A B: over convergence.csv, relative to the larger of the two values. Residuals and the part of the
# estimate that comes from p - p_H, which may be rounding themselves (p is constant in e1), and counts of iterations apart.
# Prints the difference and its column.
largest_difference() {
  paste -d, <(table "$1") <(table "$2") | awk -F, '
    NR == 1 { n = NF / 2; for (c = 2; c <= n; ++c) { skip[c] = $c ~ /^kkt$|^bound_algebra$|^estimated_algebra$|^estimated_pressure$|iterations$/; name[c] = $c } next }
    { for (c = 2; c <= n; ++c) if (!skip[c] && $c != $(c + n)) {
        size = $c ^ 2 > $(c + n) ^ 2 ? sqrt($c ^ 2) : sqrt($(c + n) ^ 2)
        difference = sqrt(($c - $(c + n)) ^ 2) / size
        if (difference > largest) { largest = difference; column = name[c] } } }
    END { printf "%.1e %s\n", largest, column }'
}
rounding() { awk "BEGIN { exit !(${1% *} < 1e-9) }"; }

# same_digits SCENE LEVEL THREADS RANKS: the run, again with numbers of threads, one of them twice, and on numbers of ranks.
same_digits() {
  local scene=$1 arguments=("$scenes/$1.prm" --set "Discretization/Finest level=$2" --set Output/VTU=all --set Output/Compliance=true)
  "$program" "${arguments[@]}" --output "$scene" >stdout 2>stderr
  check "$scene" [ $? -eq 0 ]
  for threads in $3; do
    DEAL_II_NUM_THREADS=$threads "$program" "${arguments[@]}" --output again >stdout 2>stderr
    check "  the same digits with $threads threads" same_results "$scene" again
  done
  if [ ! -x "$mpirun" ]; then
    echo "SKIP several ranks: there is no mpirun"
    return
  fi
  for ranks in $4; do
    OPENBLAS_NUM_THREADS=1 "$mpirun" -np "$ranks" "$program" "${arguments[@]}" --output again >stdout 2>stderr
    check "  $ranks ranks" [ $? -eq 0 ]
    check "  complete files" no_half_files again
    check "  the same files" [ "$(ls -A "$scene")" = "$(ls -A again)" ]
    difference=$(largest_difference "$scene" again)
    check "  the largest difference in convergence.csv: $difference" rounding "$difference"
  done
}
same_digits a1 5 "1 3 3" "2 3"
# A ring, with curved cells and more of them on every level.
same_digits e1 4 "" 2
echo "$failures failures"
[ "$failures" -eq 0 ]
