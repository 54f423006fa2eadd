#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# One part in the formats that Gmsh reads has one contact force; files that are no part are refused with one sentence, and
# nothing is left behind. One start solves all parts, another one gets all files that are refused. Skipped without the program
# gmsh.
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

# value COLUMN FOLDER [LEVEL]: of this level, or of the finest one.
value() {
  awk -F, -v name="$1" -v level="${3:-}" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i }
    NR > 1 && (level == "" || $1 == level) { found = $c } END { print found }' "$2/convergence.csv"
}
# close VALUE REFERENCE SHARE
close() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(b > 0 && d <= t * b) }'; }
# start PATH FOLDER SCENE...: one start for these scenes, with results in folders of the scenes' names.
start() {
  timeout 600 env PATH="$1" "$program" --output "$2" "${@:3}" >stdout 2>stderr </dev/null
}
# scene NAME FROM FILE ENTRY=VALUE...: NAME.prm is bracket_from_FROM.prm with the part of this file.
scene() {
  local entry changes=()
  for entry in "File=$3" "${@:4}"; do changes+=(-e $'s\1set '"${entry%%=*}"$' .*\1set '"${entry%%=*} = ${entry#*=}"$'\1'); done
  sed "${changes[@]}" "$prm/bracket_from_$2.prm" >"$1.prm"
}

geo=$prm/parts/bracket.geo
grep -v '^Mesh\.\|^Physical' "$geo" >plain.geo
grep -v '^Mesh.Re\|^Mesh.Sub' "$geo" >triangles.geo
sed -i 's/MeshSizeMax = 20/MeshSizeMax = 12/' triangles.geo
# Gmsh writes a part in several formats in one start.
make() { gmsh -v 1 -0 "$1" -o nothing.msh >/dev/null 2>&1; }
cat "$geo" - >make_quadrilaterals.geo <<'GEO'
Mesh.ElementOrder = 2;
Mesh.Binary = 1;
Mesh 2;
Save "binary.msh";
Mesh.MshFileVersion = 2.2;
Save "old.msh";
Save "part.brep";
GEO
cat triangles.geo - >make_triangles.geo <<'GEO'
Mesh 2;
Save "first_order.msh";
Save "part.unv";
Mesh.ElementOrder = 2;
Mesh 2;
Mesh.MshFileVersion = 2.2;
Save "triangles.msh";
GEO
make make_quadrilaterals.geo
make make_triangles.geo
# Words in comments run nothing.
sed -i '1i // Structured, to Save and Print\n/* Merge; Include "two.geo" */' plain.geo

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
cat >regions.prm <<'PRM'
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
sed -e 's/set Shape = .*/set Shape = rectangle/' -e 's/set File .*/set Upper right = 2,1\n  set Cells = 4,2/' \
  -e 's/soft: 1 | hard: 5/x < 1 ? 1 : 5/' -e 's/soft: 0.4 | hard: 0.2/x < 1 ? 0.4 : 0.2/' regions.prm >expressions.prm

# A cube of tetrahedra, which a gap of -0.02 compresses by 2 %.
cat >solid.geo <<'GEO'
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Mesh.MeshSizeMin = 0.5;
e = 0.001;
Physical Surface("bottom") = Surface In BoundingBox {-e, -e, -e, 1 + e, 1 + e, e};
Physical Surface("top") = Surface In BoundingBox {-e, -e, 1 - e, 1 + e, 1 + e, 1 + e};
Physical Surface("left") = Surface In BoundingBox {-e, -e, -e, e, 1 + e, 1 + e};
Physical Surface("front") = Surface In BoundingBox {-e, -e, -e, 1 + e, e, 1 + e};
GEO
cat >solid.prm <<'PRM'
set Dimension = 3
subsection Geometry
  set Shape     = file
  set File      = solid.geo
  set Mesh size = 1
end
subsection Material
  set Young's modulus = 1
  set Poisson's ratio = 0.3
end
subsection Boundary
  set Contact = bottom
  set Rollers = left front top
end
subsection Contact
  set Gap = -0.02
end
subsection Discretization
  set Coarsest level = 1
  set Finest level   = 1
end
PRM

# The reference, and the part in each format on level 2; "first" is text, which is read without Gmsh.
scene reference file "$prm/parts/bracket.msh"
parts=(step brep plain geo binary old triangles unv)
part() { scene "$@" 'Coarsest level=2' 'Finest level=2'; }
part step step "$prm/parts/bracket.step"
part brep step part.brep
part plain step plain.geo
part geo file "$geo"
part binary file binary.msh
part old file old.msh
part triangles file triangles.msh
part unv file part.unv
part first file first_order.msh
for name in unv first; do printf 'subsection Geometry\n  set Arcs = fillet\nend\n' >>"$name.prm"; done
start "$PATH" solved reference.prm regions.prm expressions.prm solid.prm "${parts[@]/%/.prm}"
check "parts in all formats, and two regions: exit code 0" [ $? -eq 0 ]
check "the mesh of quadrilaterals has a force" close "$(value contact_force_n solved/reference)" 1216 0.002
force=$(value contact_force_n solved/reference 2)
# same_force NAME FOLDER
same_force() {
  check "$1: exit code 0" grep -q "^$1\.prm: .*, exit code 0, $2/$1\$" stdout
  check "  the force of the other mesh" close "$(value contact_force_n "$2/$1")" "$force" 0.001
}
for name in "${parts[@]}"; do same_force "$name" solved; done
awk '/^Mesh .*triangle/ { said = 1 } /^  Results / { if (said) print $NF; said = 0 }' stdout >split
check "triangles: the run says that they are split" grep -qx solved/triangles split
check "two regions: the force of moduli that depend on x" \
  close "$(value contact_force_n solved/regions)" "$(value contact_force_n solved/expressions)" 1e-9
check "  the energy, too" close "$(value energy solved/regions | tr -d -)" "$(value energy solved/expressions | tr -d -)" 1e-9

check "a cube of tetrahedra: force" close "$(value contact_force_n solved/solid)" 0.02 1e-9
check "  largest pressure" close "$(value max_pressure solved/solid)" 0.02 1e-7

# refused NAME MESSAGE: of the last start.
refused() {
  check "exit code 1: $2" grep -q "^$1\.prm: wrong input, exit code 1, [a-z]*/$1\$" stdout
  grep "^signorini: $1\.prm:" stderr >line
  check "  one line" [ "$(wc -l <line)" -eq 1 ]
  check "  that sentence" grep -qF "$2" line
}
nothing_left() { [ ! -e none ] && [ -z "$(ls -A left)" ]; }
names=() messages=()
# refuse MESSAGE FILE ENTRY=VALUE...: the part of this file is refused, in a sentence that contains the message.
refuse() {
  names+=("wrong${#names[@]}")
  messages+=("$1")
  scene "${names[-1]}" step "${@:2}"
}
refuse "allowed: 1 at (40 0), 2 at (80 10)" "$prm/parts/bracket.step" Contact=foot
refuse "allowed: one of 1, ':' and its value" "$prm/parts/bracket.step" "Young's modulus=steel: 1"
refuse "the number of entries for 'hard' is 0" two.geo "Young's modulus=soft: 1" "Poisson's ratio=soft: 0.4 | hard: 0.2"
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
printf '// "\na = "//"; Include "two.geo";' >include.geo
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
echo 'x() = ListFromFile["/etc/hostname"]; Error("%g", x(0));' >list.geo
refuse "found 'ListFromFile' in line 1" list.geo
echo 'Sleep 1000;' >sleep.geo
refuse "found 'Sleep' in line 1" sleep.geo
echo 'Point(1) = {0, 0, 0' >wrong.geo
refuse "Gmsh says" wrong.geo
start "$PATH" none "${names[@]/%/.prm}"
check "${#names[@]} files: exit code 1" [ $? -eq 1 ]
check "  a line for each" [ "$(wc -l <stderr)" -eq "${#names[@]}" ]
check "  which is a sentence" [ "$(grep -c '^signorini: .*[.)]$' stderr)" -eq "${#names[@]}" ]
for i in "${!names[@]}"; do refused "${names[i]}" "${messages[i]}"; done
check "nothing is left behind" nothing_left
check "nothing was called" [ ! -e "done" ]

# No program gmsh.
scene without step plain.geo
start /nowhere none first.prm without.prm
check "without Gmsh: exit code 1" [ $? -eq 1 ]
same_force first none
check "one line" one_line_of_complaint
refused without "apt install gmsh"
rm -r none/first && rmdir none
check "  and leaves nothing behind" nothing_left

# A program gmsh that is killed, which is no matter of time.
mkdir killed
printf '#!/bin/sh\nkill -KILL $$\n' >killed/gmsh
chmod +x killed/gmsh
scene killed step plain.geo
start "$PWD/killed" none killed.prm
check "a Gmsh that is killed: exit code 1" [ $? -eq 1 ]
check "  that sentence" grep -qF "Gmsh was killed, by a user or for want of memory" stderr

# A program gmsh that waits: the limit without half a minute of work.
mkdir waiting
printf '#!/bin/sh\nexec /bin/sleep 100\n' >waiting/gmsh
chmod +x waiting/gmsh
scene loop step plain.geo
start "$PWD/waiting" none loop.prm
check "a Gmsh that does not end: exit code 1" [ $? -eq 1 ]
check "  one line" one_line_of_complaint
check "  that sentence" grep -qF "Gmsh did not end within" stderr
check "  and leaves nothing behind" nothing_left

printf 'For i In {1:1000000000}\n  x = i;\nEndFor\n' >loop.geo
scene loop step loop.geo
is_left() { compgen -G 'left/*' >/dev/null; }
is_none_left() { ! is_left; }
wait_until() {
  for i in $(seq 1000); do
    if "$1"; then break; fi
    sleep 0.1
  done
}
for signal in INT TERM KILL; do
  env --default-signal timeout -s KILL 100 "$program" loop.prm --output none >stdout 2>stderr </dev/null &
  process=$!
  wait_until is_left
  pkill -"$signal" -P "$process"
  wait "$process"
  wait_until is_none_left
  check "SIG$signal while Gmsh runs leaves no folder" [ -z "$(ls -A left)" ]
done
echo "$failures failures"
[ "$failures" -eq 0 ]
