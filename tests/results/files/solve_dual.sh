#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Another program solves the dual problem of the files and finds the same pressure. Skipped without scipy.
# usage: solve_dual.sh PROGRAM ROOT

program=$(realpath "$1")
script=$(realpath "$2")/scripts/solve_dual.py
scenes=$(realpath "$2")/prm
python=
for candidate in python3 /usr/bin/python3; do
  if "$candidate" -c 'import scipy' 2>/dev/null; then python=$candidate; break; fi
done
if [ -z "$python" ]; then
  echo "SKIP there is no python3 with scipy (package python3-scipy)"
  exit 77
fi
. "$(dirname "$0")/../../checks.bash"

check "--help" "$python" "$script" --help
for arguments in "" nowhere "nowhere one" "nowhere 3"; do
  "$python" "$script" $arguments >stdout 2>stderr
  check "'$arguments': a message" eval "[ $? -ne 0 ] && ! grep -q Traceback stderr"
done

for scene in block_on_parabola two_contact_sides patch_test_distorted pressed_by_force o1; do
  "$program" "$scenes/$scene.prm" --set 'Discretization/Finest level=3' --set Output/Compliance=true \
    --set 'Solver/Tolerated error=1' --output "$scene" >stdout 2>stderr
  check "$scene" [ $? -eq 0 ]
  check "  the same P, C and F" "$python" "$script" "$scene" 3
done
"$python" - o1/P-03.mtx <<'CHANGE'
import sys
lines = open(sys.argv[1]).read().split("\n")
lines[2] = str(1.001 * float(lines[2]))
open(sys.argv[1], "w").write("\n".join(lines))
CHANGE
"$python" "$script" o1 3 >stdout 2>stderr
check "a pressure that is wrong by a thousandth is found" [ $? -eq 1 ]
for scene in friction/t1 friction/k1 friction/ssnv128 friction/torsion; do
  "$program" "$scenes/$scene.prm" --set 'Discretization/Coarsest level=2' --set 'Discretization/Finest level=3' \
    --set 'Discretization/Target error=0' --set Output/Compliance=true --set 'Solver/Tolerated error=1' --output friction >stdout 2>stderr
  check "$scene" [ $? -eq 0 ]
  check "  the same P, C and F" "$python" "$script" friction 3
done
echo "$failures failures"
[ "$failures" -eq 0 ]
