#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# One part in the formats that Gmsh reads has one contact force; files that are no part are refused with one sentence, and
# nothing is left behind. Skipped without the program gmsh.
# usage: gmsh.sh PROGRAM ROOT

program=$(realpath "$1")
prm=$(realpath "$2")/prm
if ! command -v gmsh >/dev/null; then
  echo "SKIP there is no gmsh"
  exit 77
fi
. "$(dirname "$0")/../../checks.bash"
mkdir left
export TMPDIR=$PWD/left

# value COLUMN FOLDER: of the finest level.
value() {
  awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i } END { print $c }' "$2/convergence.csv"
}
# close VALUE REFERENCE SHARE
close() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(b > 0 && d <= t * b) }'; }

geo=$prm/parts/bracket.geo
grep -v '^Mesh\.\|^Physical' "$geo" >plain.geo
grep -v '^Mesh.Re\|^Mesh.Sub' "$geo" >triangles.geo
sed -i 's/MeshSizeMax = 20/MeshSizeMax = 12/' triangles.geo
make() { gmsh -v 1 "$@" >/dev/null 2>&1; }
make -0 "$geo" -format brep -o part.brep
make -2 -order 2 -bin "$geo" -o binary.msh
make -2 -order 2 "$geo" -format msh2 -bin -o old.msh
make -2 -order 2 -format msh22 triangles.geo -o triangles.msh
make -2 triangles.geo -o first_order.msh
make -2 triangles.geo -o part.unv
# What the program finds; without gmsh where it is /nowhere.
path=$PATH
run() {
  timeout 200 env PATH="$path" "$program" "$prm/bracket_from_$1.prm" --output "$2" --set Geometry/File="$3" "${@:4}" >stdout 2>stderr </dev/null
}
run file reference "$prm/parts/bracket.msh"
force=$(value contact_force_n reference)
check "the mesh of quadrilaterals has a force" close "$force" 1216 0.002
same() {
  local name=$1
  shift
  run "$@"
  check "$name: exit code 0" [ $? -eq 0 ]
  check "  the force of the other mesh" close "$(value contact_force_n "$2")" "$force" 0.001
}
same "STEP" step step "$prm/parts/bracket.step"
same "BREP" step brep part.brep
same "a script without names" step plain plain.geo
same "a script with names" file geo "$geo"
same "binary, version 4.1" file binary binary.msh
same "binary, version 2.2" file old old.msh
same "triangles of second order" file triangles triangles.msh
check "  the run says that they are split" grep -q '^Mesh .*triangle' stdout
same "UNV, triangles of first order" file unv part.unv --set Geometry/Arcs=fillet
path=/nowhere
same "triangles of text, without Gmsh" file first first_order.msh --set Geometry/Arcs=fillet
path=$PATH

# Two squares of different stiffness, on the same mesh as a rectangle with moduli that depend on x.
cat >two.geo <<'GEO'
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 1};
Rectangle(2) = {1, 0, 0, 1, 1};
Coherence;
Physical Surface("soft") = {1};
Physical Surface("hard") = {2};
Physical Curve("bottom") = {1, 5};
Physical Curve("top") = {3, 7};
Mesh.MeshSizeMax = 1;
Transfinite Surface {1, 2};
Transfinite Curve "*" = 2;
GEO
cat >two.prm <<'PRM'
subsection Geometry
  set Shape = file
  set File  = two.geo
end
subsection Material
  set Young's modulus = soft: 1 | hard: 5
  set Poisson's ratio = soft: 0.4 | hard: 0.2
end
subsection Boundary
  set Contact      = bottom
  set Displacement = top: 0; -0.01
end
subsection Discretization
  set Coarsest level = 0
  set Finest level   = 3
end
PRM
solve() { timeout 100 "$program" two.prm --output "$1" "${@:2}" >stdout 2>stderr </dev/null; }
solve regions
check "two regions: exit code 0" [ $? -eq 0 ]
solve expressions --set Geometry/Shape=rectangle --set Geometry/File= --set 'Geometry/Upper right=2,1' --set 'Geometry/Cells=4,2' \
  --set "Material/Young's modulus=x < 1 ? 1 : 5" --set "Material/Poisson's ratio=x < 1 ? 0.4 : 0.2"
check "  the force of moduli that depend on x" \
  close "$(value contact_force_n regions)" "$(value contact_force_n expressions)" 1e-9
check "  the energy, too" close "$(value energy regions | tr -d -)" "$(value energy expressions | tr -d -)" 1e-9

# refuse MESSAGE FILE ARGUMENTS...: exit code 1 and a line that contains the message.
refuse() {
  local message=$1 file=$2
  shift 2
  timeout 100 env PATH="$path" "$program" "$prm/bracket_from_step.prm" --output none --set Geometry/File="$file" "$@" >stdout 2>stderr </dev/null
  check "exit code 1: $message" [ $? -eq 1 ]
  check "  one line" one_line_of_complaint
  check "  that sentence" grep -qF "$message" stderr
  check "  and leaves nothing behind" [ ! -e none -a -z "$(ls -A left)" ]
}
refuse "allowed: 1 at (40 0), 2 at (80 10)" "$prm/parts/bracket.step" --set Boundary/Contact=foot
refuse "allowed: one of 1, ':' and its value" "$prm/parts/bracket.step" --set "Material/Young's modulus=steel: 1"
refuse "the number of entries for 'hard' is 0" two.geo --set "Material/Young's modulus=soft: 1" \
  --set "Material/Poisson's ratio=soft: 0.4 | hard: 0.2"
head -c 3000 /dev/urandom >noise.step
head -c 3000 "$prm/parts/bracket.step" >cut.step
head -c 5000 binary.msh >cut.msh
head -c 3000 /dev/urandom >noise.geo
(printf '$MeshFormat\n4.1 1 8\n' && head -c 3000 /dev/urandom) >noise.msh
(printf '$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n' && head -c 64 /dev/zero | tr '\0' '\377') >huge.msh
for file in noise.step cut.step cut.msh noise.geo noise.msh huge.msh; do refuse "Geometry/File: " "$file"; done
: >empty.step
refuse "which is empty" empty.step
mkdir folder.step
refuse "Geometry/File: " folder.step
cp two.geo part.txt
refuse "allowed: a file that Gmsh reads" part.txt
echo 'SystemCall "touch done";' >call.geo
refuse "found 'SystemCall' in line 1" call.geo
printf '\nInclude "two.geo";' >include.geo
refuse "found 'Include' in line 2" include.geo
echo 'SystemCall "touch done";' >call.msh
refuse "found no \$MeshFormat" call.msh
for ending in unv bdf nas mesh vtk med step stp iges igs brep; do
  echo "SystemCall \"touch $PWD/done\";" >call.$ending
  refuse "found 'SystemCall' in line 1" call.$ending
done
for ending in inp su2 txt; do
  cp call.unv call.$ending
  refuse "allowed: a file that Gmsh reads" call.$ending
done
check "nothing was called" [ ! -e done ]
echo 'x() = ListFromFile["/etc/hostname"]; Error("%g", x(0));' >list.geo
refuse "found 'ListFromFile' in line 1" list.geo
echo 'Sleep 1000;' >sleep.geo
refuse "found 'Sleep' in line 1" sleep.geo
printf 'For i In {1:1000000000}\n  x = i;\nEndFor\n' >loop.geo
# A program gmsh that waits: the limit without half a minute of work.
mkdir waiting
printf '#!/bin/sh\nexec /bin/sleep 100\n' >waiting/gmsh
chmod +x waiting/gmsh
path=$PWD/waiting
refuse "Gmsh did not end within" loop.geo
path=$PATH
for signal in INT TERM KILL; do
  env --default-signal timeout -s KILL 20 "$program" "$prm/bracket_from_step.prm" --output none --set Geometry/File=loop.geo >stdout 2>stderr </dev/null &
  process=$!
  for i in $(seq 100); do [ -n "$(ls -A left)" ] && break; sleep 0.05; done
  pkill -"$signal" -P "$process"
  wait "$process"
  for i in $(seq 100); do [ -z "$(ls -A left)" ] && break; sleep 0.05; done
  check "SIG$signal while Gmsh runs leaves no folder" [ -z "$(ls -A left)" ]
done
echo 'Point(1) = {0, 0, 0' >wrong.geo
refuse "Gmsh says" wrong.geo
path=/nowhere
refuse "apt install gmsh" plain.geo
echo "$failures failures"
[ "$failures" -eq 0 ]
