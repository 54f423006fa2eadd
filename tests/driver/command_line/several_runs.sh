#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Several scenes, sweeps, single constants, tables for people.
# usage: several_runs.sh PROGRAM

program=$(realpath "$1")
. "$(dirname "$0")/../../checks.bash"

# run CODE ARGUMENTS...
run() {
  local code=$1
  shift
  timeout 100 "$program" "$@" >stdout 2>stderr </dev/null
  local found=$?
  check "exit code $code: signorini ${*}" [ "$found" -eq "$code" ]
}
complains() { [[ $(<stderr) == *"$1"* ]]; }
refuse() {
  local fragment=$1
  shift
  run 1 "$@"
  check "  says '$fragment'" complains "$fragment"
  check "  in one line" one_line_of_complaint
}

# A block of width and height 1 on a flat foundation that is a distance of 0.1 into it: u = 0 above, u_y = 0.1 below
# and rollers at the sides, so that the strain is 0.1, sigma_yy = -E (1 - nu) / ((1 + nu) (1 - 2 nu)) * 0.1.
cat >block.prm <<'PRM'
subsection Constants
  set Values = E=1, nu=0, depth=0.1, half=depth/2
end
subsection Material
  set Young's modulus = E
  set Poisson's ratio = nu
end
subsection Boundary
  set Clamped = top
  set Rollers = left right
  set Contact = bottom
end
subsection Contact
  set Gap = -2*half
end
subsection Discretization
  set Coarsest level = 1
  set Finest level   = 2
end
PRM
sed 's/Values = E=1/Values = E=2/' block.prm >stiff.prm
force() { sed -n 's/^  Contact force *(0, \([^)]*\)).*/\1/p' stdout; }

run 0 block.prm stiff.prm --set Constants/depth=0.2
check "the force of nu = 0 is E times the depth" [ "$(force)" = $'0.2\n0.4' ]
check "the constant stands in its list" grep -q 'set Values = E=1, nu=0, depth=0.2, half=depth/2' results/block/parameters.prm
check "  one directory each" [ -s results/block/convergence.csv ]
check "  named by the file" [ -s results/stiff/convergence.csv ]
check "  a line each" [ "$(grep -c '^[a-z]*\.prm: certified, exit code 0, results/' stdout)" -eq 2 ]
run 0 block.prm --set Constants/depth=0.2 --set Constants/E=3
check "two constants" [ "$(force)" = 0.6 ]
run 0 block.prm --set depth=0.2 --set E=3 --quiet --output quiet
check "constants by their names alone" cmp -s quiet/parameters.prm results/block/parameters.prm
check "a quiet run prints nothing" [ ! -s stdout ]
check "  and writes its results" [ -s quiet/answer.json ]
refuse "--set: found the constant 'depht', allowed: E, nu, depth, half." block.prm --set Constants/depht=1
refuse "allowed: one value" block.prm --set 'Constants/depth=1, nu=0.3'

# A bearing: three rollers carry a ring that is loaded from above. What does not press yet
# rolls anywhere, and patches that are to hold it must not come and go for ever.
cat >bearing.prm <<'PRM'
subsection Geometry
  set Bodies    = inner outer r1 r2 r3
  set Shape     = polygon
  set Vertices  = inner: -17.3205080757,-10; arc 0,0 ccw; -6.84040286651,-18.7938524157; arc 0,0 ccw; 6.84040286651,-18.7938524157; arc 0,0 ccw; 17.3205080757,-10; arc 0,0 ccw; 0,20; arc 0,0 ccw | outer: -36.705181399,-9.8351237139; arc 0,0 ccw; 36.705181399,-9.8351237139; 28.9777747887,-7.76457135308; arc 0,0 cw; 10.2606042998,-28.1907786236; arc 0,0 cw; -10.2606042998,-28.1907786236; arc 0,0 cw; -28.9777747887,-7.76457135308 | r1: 5,-25; arc 0,-25 ccw; -5,-25; arc 0,-25 ccw | r2: 19.8999124578,-15.9371730295; arc 16.0696902422,-19.151111078 ccw; 12.2394680266,-22.3650491264; arc 16.0696902422,-19.151111078 ccw | r3: -12.2394680266,-22.3650491264; arc -16.0696902422,-19.151111078 ccw; -19.8999124578,-15.9371730295; arc -16.0696902422,-19.151111078 ccw
  set Holes     = inner: circle 0,0,12
  set Mesh size = 12
end
subsection Material
  set Young's modulus = 210000
end
subsection Boundary
  set Contact = inner.side1 with r1.side0 | inner.side2 with r2.side0 | inner.side0 with r3.side0 | outer.side3 with r1.side1 | outer.side2 with r2.side1 | outer.side4 with r3.side1
  set Clamped = outer.side0
  set Plates  = inner.hole0: 0,-1
end
subsection Load
  set Plate force = inner.hole0: 1000
end
subsection Discretization
  set Coarsest level = 2
  set Finest level   = 2
end
subsection Solver
  set Tolerated error = 1e-3
end
PRM
run 2 bearing.prm block.prm --output rolling
check "the equations of five bodies are solved" grep -q '^NOT resolved, equations certified' stdout
check "  by the active set" grep -q '"contact_solver_replaced": false' rolling/bearing/certificate.json
# carried SIDE: the vertical force on a side of the ring.
carried() { sed -n "s/^    on $1 *([^,]*, \([^)]*\)).*/\1/p" stdout; }
check "  the rollers carry together what presses the ring down" \
  awk -v a="$(carried inner.side0)" -v b="$(carried inner.side1)" -v c="$(carried inner.side2)" \
  'BEGIN { sum = a + b + c; exit !(sum > 999.9 && sum < 1000.1) }'
check "  the message names the scene" grep -q '^signorini: bearing.prm: The error of level 2' stderr

run 1 block.prm missing.prm stiff.prm --output both
check "  the others are run" [ -s both/stiff/convergence.csv ]
check "  and it is said" grep -q '^missing.prm: wrong input, exit code 1' stdout

# column NAME: of sweep.csv, in one line.
column() {
  awk -F, -v name="$1" 'NR == 1 { for (c = 1; c <= NF; ++c) if ($c == name) k = c; next } { printf "%s ", $k }' "$2"
}
run 0 block.prm --sweep 'Constants/depth=0.05, 0.1, 0.2' --output sweep
check "  a directory each" [ -s sweep/0.05/convergence.csv ]
check "  rows in the order of the values" [ "$(column Constants/depth sweep/sweep.csv)" = '0.05 0.1 0.2 ' ]
check "  the force is linear in the depth" awk -F, 'NR > 1 && ($4 / $1 - 1) ^ 2 > 1e-18 { exit 1 }' sweep/sweep.csv
check "  the energy is quadratic" awk -F, 'NR > 1 && ($6 / $1 ^ 2 - 0.5) ^ 2 > 1e-16 { exit 1 }' sweep/sweep.csv
check "  the finest level" [ "$(column level sweep/sweep.csv)" = '2 2 2 ' ]
check "  verdicts" [ "$(column verdict sweep/sweep.csv)" = 'certified certified certified ' ]
check "  columns" [ "$(head -n 1 sweep/sweep.csv)" = \
  'Constants/depth,level,dofs,contact_force,peak_pressure,energy,estimate,bound,seconds,contact_length,'\
'reaction_left_x,reaction_left_y,reaction_right_x,reaction_right_y,reaction_top_x,reaction_top_y,verdict' ]
check "  reactions" awk -F, 'NR > 1 && ($16 / $4 + 1) ^ 2 > 1e-18 { exit 1 }' sweep/sweep.csv
check "  the table is printed" grep -q '^0.05  *2 ' stdout
run 0 block.prm --sweep 'Constants/E=1, 2' --sweep 'Constants/depth=0.1, 0.2' --output product
check "  all combinations" [ "$(column contact_force product/sweep.csv | tr ' ' '\n' | xargs printf '%.6f ')" = \
  '0.100000 0.200000 0.200000 0.400000 ' ]
check "  their directories" [ -s product/2_0.1/certificate.json ]
run 1 block.prm --sweep "Material/Poisson's ratio=0, 0.7" --output partly
check "  what is wrong for one value only" [ "$(column verdict partly/sweep.csv)" = 'certified wrong input ' ]
check "  its message names the option" grep -q "^signorini: --sweep: Material/Poisson's ratio: found 0.7 at" stderr
run 0 block.prm --sweep 'depth=0.1, 0.2' --sweep 'Geometry/Upper right=1,1 | 1,depth+1' --output commas
check "  values with commas" [ "$(column depth commas/sweep.csv)" = '0.1 0.1 0.2 0.2 ' ]
refuse "but 'Subsection/Parameter=value, value, ...' is expected" block.prm --sweep Constants/depth
refuse "but 'Subsection/Parameter=value, value, ...' is expected" block.prm --sweep 'Constants/depth=1,,2'
refuse "two runs would write into the directory '0.1'" block.prm --sweep 'Constants/depth=0.1, 0.1'
refuse "found 'abc', allowed: a number" block.prm --sweep 'Solver/Tolerance=1e-9, abc' --output refused
check "  before the first run" [ ! -e refused ]
refuse "found 'depth' and again 'Constants/depth', allowed: one sweep" block.prm --sweep depth=1,2 --sweep Constants/depth=3
refuse "--sweep: Constants/Values: found 'depth=1;2', allowed: name=number" block.prm --sweep 'depth=1;2'

# No other run writes into a finished directory of a sweep that goes on.
"$program" block.prm --sweep 'Discretization/Finest level=2, 9' --output kept >/dev/null 2>&1 </dev/null &
for i in $(seq 600); do
  if [ -e kept/9 ]; then break; fi
  sleep 0.05
done
refuse "into which another run is writing" block.prm --output kept/2
kill $!
wait $! 2>/dev/null

echo "$failures failures"
[ "$failures" -eq 0 ]
