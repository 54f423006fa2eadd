#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# The same run gives the same digits, with any number of threads; where several ranks share a level they differ by rounding.
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
rounding() { awk "BEGIN { exit !(${1% *} < $2) }"; }

# same_digits SCENE LEVEL THREADS: the run, and again with numbers of threads, one of them twice, and on two ranks, each of which
# solves all levels alone.
same_digits() {
  local scene=$1 arguments=("$scenes/$1.prm" --set "Discretization/Finest level=$2" --set Output/VTU=all --set Output/Compliance=true)
  "$program" "${arguments[@]}" --output "$scene" >stdout 2>stderr
  check "$scene" [ $? -eq 0 ]
  for threads in $3; do
    DEAL_II_NUM_THREADS=$threads "$program" "${arguments[@]}" --output again >stdout 2>stderr
    check "  the same digits with $threads threads" same_results "$scene" again
  done
  [ -x "$mpirun" ] || return
  OPENBLAS_NUM_THREADS=1 "$mpirun" -np 2 "$program" "${arguments[@]}" --output again >stdout 2>stderr
  check "  the same digits on two ranks" same_results "$scene" again
}

# shared DIFFERENCE RANKS SCENE ENTRIES...: the run on one rank, and on numbers of ranks that share the last level.
shared() {
  local most=$1 all_ranks=$2 scene=$3 arguments=("$scenes/$3.prm" --set Output/VTU=finest)
  for entry in "${@:4}"; do arguments+=(--set "$entry"); done
  "$program" "${arguments[@]}" --output alone >stdout 2>stderr
  check "$scene" [ $? -eq 0 ]
  for ranks in $all_ranks; do
    OPENBLAS_NUM_THREADS=1 "$mpirun" -np "$ranks" "$program" "${arguments[@]}" --output again >stdout 2>stderr
    check "  $ranks ranks" [ $? -eq 0 ]
    check "  complete files" no_half_files again
    check "  a file of the body from every rank" [ "$(ls again/solution-*.[0-9]*.vtu | wc -l)" -eq "$ranks" ]
    difference=$(largest_difference alone again)
    check "  the largest difference in convergence.csv: $difference" rounding "$difference" "$most"
    table=$(ls alone | grep -E '^contact-[0-9]+\.csv$' | tail -n 1)
    check "  all rows of $table" [ "$(cut -d, -f1-4 "alone/$table" | md5sum)" = "$(cut -d, -f1-4 "again/$table" | md5sum)" ]
  done
}

same_digits a1 5 "1 3 3"
if [ -x "$mpirun" ]; then
  # On shared levels sums are rounded in another order, and V-cycles end at their tolerance.
  shared 1e-10 "2 3" space/d3 "Discretization/Finest level=4"
  shared 1e-10 2 space/d3 "Discretization/Finest level=4" "Solver/Linear solver=amesos_mumps" "Solver/Tolerated error=1"
  shared 1e-8 2 bracket_from_file Output/Bound=false "Solver/Contact solver=multigrid" Discretization/Strategy=nested
  # A ring, with curved cells, more of them on every level, and p4est's own order of the coarse mesh.
  shared 1e-9 3 e2 "Discretization/Finest level=4" Output/Bound=false "Solver/Linear solver=amesos_mumps"
else
  echo "SKIP several ranks: there is no mpirun"
fi
echo "$failures failures"
[ "$failures" -eq 0 ]
