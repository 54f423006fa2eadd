#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# The collection of contact problems: two of them are made, solved by other methods, and agree with the table; a wrong optimum is
# found, and solve_dual.py reads them. Skipped without scipy.
# usage: collection.sh PROGRAM ROOT

program=$(realpath "$1")
root=$(realpath "$2")
. "$(dirname "$0")/../../checks.bash"
find_python scipy
export SIGNORINI=$program PYTHONDONTWRITEBYTECODE=1
script=$root/scripts/collection.py

check "--help" "$python" "$script" --help
"$python" "$script" made nothing >stdout 2>stderr
check "an unknown problem" [ $? -eq 2 ]
"$python" "$script" made redundant coulomb >stdout 2>stderr
check "two problems are as the table says" [ $? -eq 0 ]
check "  with all their levels" grep -qx "coulomb: 4 problems of 8 to 64 multipliers" stdout
"$python" "$root/scripts/solve_dual.py" made/redundant 2 >stdout 2>stderr
check "solve_dual.py reads them" [ $? -eq 0 ]
check "  and compares C P where P is not unique" grep -q '^C P: ' stdout
cat >wrong.py <<'WRONG'
import sys
sys.path.insert(0, sys.argv[1])
from collection import Problem
right, wrong = Problem("made/coulomb", "04"), Problem("made/coulomb", "04")
wrong.P[3] *= 1 + 1e-6
print(right.residual(right.P, right.q) < 1e-12 and wrong.residual(wrong.P, wrong.q) > 1e-8)
WRONG
check "a pressure that is wrong by a millionth is found" [ "$("$python" wrong.py "$root/scripts" 2>stderr)" = True ]
check "every problem is in the table and on the page" "$python" - "$root" <<'TABLE'
import csv, sys
sys.path.insert(0, sys.argv[1] + "/scripts")
from collection import PROBLEMS
rows = list(csv.DictReader(open(sys.argv[1] + "/doc/measured/collection.csv")))
page = open(sys.argv[1] + "/doc/collection.md").read()
assert {row["problem"] for row in rows} == set(PROBLEMS) and all(f"| `{name}` |" in page for name in PROBLEMS)
TABLE
echo "$failures failures"
[ "$failures" -eq 0 ]
