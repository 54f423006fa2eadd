#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Another program solves the dual problem of the files and finds the same pressure. Skipped without scipy.
# usage: solve_dual.sh PROGRAM ROOT

program=$(realpath "$1")
script=$(realpath "$2")/scripts/solve_dual.py
scenes=$(realpath "$2")/prm
. "$(dirname "$0")/../../checks.bash"
find_python scipy

check "--help" "$python" "$script" --help
for arguments in "" nowhere "nowhere one" "nowhere 3"; do
  "$python" "$script" $arguments >stdout 2>stderr
  check "'$arguments': a message" eval "[ $? -ne 0 ] && ! grep -q Traceback stderr"
done

# solve SCENES SETTINGS: one start for these scenes, with results in folders of their names.
solve() {
  local scene paths=() settings=()
  for scene in $1; do paths+=("$scenes/$scene.prm"); done
  while IFS= read -r setting; do settings+=(--set "$setting"); done <<<"$2"
  "$program" "${paths[@]}" "${settings[@]}" --output . >stdout 2>stderr
  check "$1" [ $? -eq 0 ]
  for scene in $1; do check "  exit code 0: $scene" grep -q "/$scene\.prm: .*, exit code 0, " stdout; done
}
plane="block_on_parabola two_contact_sides patch_test_distorted pressed_by_force o1"
friction="friction/t1 friction/k1 friction/ssnv128 friction/torsion"
common='Discretization/Finest level=3
Output/Compliance=true
Solver/Tolerated error=1'
solve "$plane" "$common"
solve "$friction" "$common
Discretization/Coarsest level=2
Discretization/Target error=0"
# One start of Python for all of them.
cat >all.py <<'ALL'
import runpy, sys
script, *folders = sys.argv[1:]
for folder in folders:
    sys.argv = [script, folder, "3"]
    try:
        runpy.run_path(script, run_name="__main__")
    except SystemExit as end:
        print(f"{folder}: exit code {end.code}", flush=True)
ALL
"$python" all.py "$script" $plane ${friction//friction\//} >stdout 2>stderr
check "the same P, C and F are looked for" [ $? -eq 0 ]
for scene in $plane $friction; do check "  the same P, C and F: $scene" grep -qx "${scene##*/}: exit code 0" stdout; done
cat stdout
"$python" - o1/P-03.mtx <<'CHANGE'
import sys
lines = open(sys.argv[1]).read().split("\n")
lines[2] = str(1.001 * float(lines[2]))
open(sys.argv[1], "w").write("\n".join(lines))
CHANGE
"$python" "$script" o1 3 >stdout 2>stderr
check "a pressure that is wrong by a thousandth is found" [ $? -eq 1 ]
echo "$failures failures"
[ "$failures" -eq 0 ]
