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

# on_ranks N SCENES...: the scenes on some ranks, with the results in ranks-N.
on_ranks() {
  local scenes_of_call=("${@:2}")
  OPENBLAS_NUM_THREADS=1 "$mpirun" -np "$1" "$program" "${scenes_of_call[@]/%/.prm}" --output "ranks-$1" >stdout 2>stderr
  check "${*:2} on $1 ranks" [ $? -eq 0 ]
}

# shared DIFFERENCE RANKS SCENE: what ranks that shared the last level say, beside the run on one rank.
shared() {
  local alone=alone/$3 again=ranks-$2/$3 difference table
  echo "$3 on $2 ranks"
  check "  complete files" no_half_files "$again"
  check "  a file of the body from every rank" [ "$(ls "$again"/solution-*.[0-9]*.vtu | wc -l)" -eq "$2" ]
  difference=$(largest_difference "$alone" "$again")
  check "  the largest difference in convergence.csv: $difference" rounding "$difference" "$1"
  table=$(ls "$alone" | grep -E '^contact-[0-9]+\.csv$' | tail -n 1)
  check "  all rows of $table" [ "$(cut -d, -f1-4 "$alone/$table")" = "$(cut -d, -f1-4 "$again/$table")" ]
}

variant "$scenes/a1.prm" a1 "Discretization/Finest level=5" Output/VTU=all Output/Compliance=true
names=(a1)
if [ -x "$mpirun" ]; then
  variant "$scenes/space/d3.prm" d3 Output/VTU=finest "Discretization/Finest level=4"
  # Only the level that is shared; d3 has the levels before, which each rank solves alone.
  variant "$scenes/space/d3.prm" d3_mumps Output/VTU=finest "Discretization/Coarsest level=4" "Discretization/Finest level=4" \
    "Solver/Linear solver=amesos_mumps" "Solver/Tolerated error=1"
  ln -s "$scenes/parts" parts
  variant "$scenes/bracket_from_file.prm" bracket Output/VTU=finest Output/Bound=false "Solver/Contact solver=multigrid" \
    Discretization/Strategy=nested
  # A ring, with curved cells, more of them on every level, and p4est's own order of the coarse mesh.
  variant "$scenes/e2.prm" e2 Output/VTU=finest "Discretization/Finest level=3" Output/Bound=false "Solver/Linear solver=amesos_mumps"
  names+=(d3 d3_mumps bracket e2)
fi
"$program" "${names[@]/%/.prm}" --output alone >stdout 2>stderr
check "${names[*]}" [ $? -eq 0 ]
DEAL_II_NUM_THREADS=1 "$program" a1.prm --output threads-1 >stdout 2>stderr
check "the same digits with 1 thread" same_results alone/a1 threads-1
cp a1.prm a1_again.prm
DEAL_II_NUM_THREADS=3 "$program" a1.prm a1_again.prm --output threads-3 >stdout 2>stderr
check "the same digits with 3 threads" same_results alone/a1 threads-3/a1
check "and once more" same_results alone/a1 threads-3/a1_again
if [ -x "$mpirun" ]; then
  on_ranks 2 a1 d3 d3_mumps bracket
  on_ranks 3 d3 e2
  # Where each rank solves all levels alone.
  check "the same digits on two ranks" same_results alone/a1 ranks-2/a1
  # On shared levels sums are rounded in another order, and V-cycles end at their tolerance.
  shared 1e-10 2 d3
  shared 1e-10 3 d3
  shared 1e-10 2 d3_mumps
  shared 1e-8 2 bracket
  shared 1e-9 3 e2
else
  echo "SKIP several ranks: there is no mpirun"
fi
echo "$failures failures"
[ "$failures" -eq 0 ]
