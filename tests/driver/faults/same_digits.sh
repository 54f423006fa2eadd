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

# E1 is a ring, with more cells on every level.
for level in a1:5 e1:4; do
  scene=${level%:*}
  arguments=("$scenes/$scene.prm" --set "Discretization/Finest level=${level#*:}" --set Output/VTU=all --set Output/Compliance=true)
  "$program" "${arguments[@]}" --output "$scene" >stdout 2>stderr
  check "$scene" [ $? -eq 0 ]
  for threads in 1 3; do
    DEAL_II_NUM_THREADS=$threads "$program" "${arguments[@]}" --output again >stdout 2>stderr
    check "  the same digits with $threads threads" same_results "$scene" again
  done
  "$program" "${arguments[@]}" --output again >stdout 2>stderr
  check "  the same digits when repeated" same_results "$scene" again
  if [ ! -x "$mpirun" ]; then
    echo "SKIP several ranks: there is no mpirun"
    continue
  fi
  for ranks in 2 3; do
    OPENBLAS_NUM_THREADS=1 "$mpirun" -np "$ranks" "$program" "${arguments[@]}" --output again >stdout 2>stderr
    check "  $ranks ranks" [ $? -eq 0 ]
    check "  complete files" no_half_files again
    check "  the same files" [ "$(ls -A "$scene")" = "$(ls -A again)" ]
    difference=$(largest_difference "$scene" again)
    check "  the largest difference in convergence.csv: $difference" rounding "$difference"
  done
done
echo "$failures failures"
[ "$failures" -eq 0 ]
