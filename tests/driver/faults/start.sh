#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# What stops a run before it has begun, or is taken away from it: one sentence and an exit code, and nothing of the user is lost.
# usage: start.sh PROGRAM ROOT MPIRUN

program=$(realpath "$1")
mpirun=$3
. "$(dirname "$0")/results.bash"

write_scene 4
variant scene.prm brief 'Discretization/Finest level=2' 'Solver/Tolerated error=1'
# run CODE ARGUMENTS...: one sentence unless the code is 0.
run() {
  local code=$1
  shift
  timeout 100 "$program" "$@" >stdout 2>stderr </dev/null
  local found=$?
  check "exit code $code: signorini ${*:0:100}" [ "$found" -eq "$code" ]
  if [ "$code" -ne 0 ]; then check "  one sentence" one_line_of_complaint; fi
}
says() { grep -qF -- "$1" stderr; }

# Side by side: four calls with much that is wrong, and after each of them starts that find no file. SIGNORINI_STARTS=100 makes
# 400 of these. A process without a launcher has no folder of a session, which others would share.
calls=0
at_once() {
  calls=$((calls + 1))
  {
    TMPDIR=/proc/none timeout 100 "$program" "$@" >stdout.$calls 2>stderr.$calls </dev/null
    echo $? >code.$calls
    for ((i = 0; i < ${SIGNORINI_STARTS:-1}; ++i)); do
      timeout 100 "$program" missing.prm >/dev/null 2>&1 </dev/null
      [ $? -eq 1 ] || echo "start $i of queue $calls"
    done >failed_starts.$calls
  } &
}
# call N SCENES...: what the Nth call said, in the files stdout and stderr from now on: exit code 1, and a line for each of these
# scenes, which are all that are refused.
call() {
  local name lines
  mv "stdout.$1" stdout
  mv "stderr.$1" stderr
  check "call $1: exit code 1" [ "$(<"code.$1")" -eq 1 ]
  mapfile lines <stderr
  check "  one sentence each" [ "${#lines[@]}" -eq $(($# - 1)) ]
  check "  which end" [ "$(grep -c '^signorini: .*[.)]$' stderr)" -eq $(($# - 1)) ]
  if [ $# -gt 2 ]; then
    for name in "${@:2}"; do check "  $name: exit code 1" ends_with_code 1 "$name"; done
  fi
}
ends_with_code() { grep -q "^\(.*/\)\?$2: .*, exit code $1, " stdout; }

# Results that would replace what they come from, or go nowhere.
mkdir -p wrong/parameters wrong/contact-05 wrong/mesh wrong/next
ln -s missing wrong/dangling
cp scene.prm dangling.prm
cp scene.prm wrong/parameters/parameters.prm
cp scene.prm wrong/contact-05/contact-05.csv
cat >wrong/mesh/answer.json <<'MSH'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "top"
1 2 "bottom"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
3
1 1 2 1 1 3 4
2 1 2 2 2 1 2
3 3 2 3 1 1 2 3 4
$EndElements
MSH
cp wrong/mesh/answer.json answer.json
ln -s wrong/mesh/answer.json mesh.msh
cat >mesh.prm <<'PRM'
subsection Geometry
  set Shape = file
  set File  = mesh.msh
end
subsection Boundary
  set Clamped = top
  set Contact = bottom
end
PRM
cp scene.prm next.prm
cp brief.prm wrong/next/contact-02.csv
long=$(printf 'directory/%.0s' {1..20})
at_once missing.prm "$long/long.prm" dangling.prm wrong/parameters/parameters.prm wrong/contact-05/contact-05.csv mesh.prm \
  next.prm wrong/next/contact-02.csv --output wrong
# The results go to another place than the file at first sight; so does what is removed again.
mkdir -p linked/by_link linked/by_name
cp scene.prm linked/mine
cp scene.prm linked/by_link/contact-09.csv
cp scene.prm linked/by_name/contact-09.csv
ln -s linked/by_link/contact-09.csv by_link.prm
ln linked/by_name/contact-09.csv by_name.prm
at_once linked/mine by_link.prm by_name.prm --output new/../linked
ln -s missing below
at_once scene.prm --output below/results
mkdir swept
cp scene.prm swept/sweep.csv
at_once swept/sweep.csv --sweep 'Discretization/Finest level=4, 5' --output swept
wait
check "starts side by side" [ -z "$(cat failed_starts.*)" ]

call 1 missing.prm long.prm dangling.prm parameters.prm contact-05.csv mesh.prm next.prm
check "  no folder" says 'missing.prm: this parameter file cannot be read.'
check "  long paths are shortened" [ "$(grep 'long\.prm' stderr | wc -c)" -lt 150 ]
check "  the link stays" [ -L wrong/dangling ]
check "  the scene stays" cmp -s scene.prm wrong/parameters/parameters.prm
check "  under any name" cmp -s scene.prm wrong/contact-05/contact-05.csv
check "  about the mesh" says "mesh.msh"
check "  which stays" cmp -s answer.json wrong/mesh/answer.json
check "  a scene that is still to come stays" cmp -s brief.prm wrong/next/contact-02.csv
check "  and is run" ends_with_code 0 contact-02.csv
call 2 mine by_link.prm by_name.prm
check "  the scene stays" cmp -s scene.prm linked/mine
check "  and no directory" [ ! -e new ]
for file in by_link by_name; do
  check "  about the file" says "$file.prm"
  check "  the file stays" cmp -s scene.prm linked/$file/contact-09.csv
done
call 3 scene.prm
check "  the link stays" [ -L below ]
call 4 sweep.csv
check "  the scene stays" cmp -s scene.prm swept/sweep.csv

# What the libraries need before the program begins: in Debian 12 520 MB and less than 64 KiB of stack, in later ones more.
# A computation that fits may succeed.
limits="550 650 750 1000" stack=64
if ! grep -q '^VERSION_ID="12"' /etc/os-release; then limits="710 810 910 1160" stack=512; fi
if ! (ulimit -v 20000000 && "$program" brief.prm --output repeated >stdout 2>stderr); then
  echo "SKIP limits of the address space: this build (with sanitizers?) needs more than 20 GB of it"
  limits=""
  run 0 brief.prm --output repeated
fi
run 0 repeated/parameters.prm --output repeated
for limit in $limits; do
  (
    ulimit -v $((limit * 1024))
    timeout 100 "$program" scene.prm --output none >stdout 2>stderr
  )
  code=$?
  check "ulimit -v of $limit MB: exit code 0 or 3, found $code" [ "$code" -eq 0 -o "$code" -eq 3 ]
  check "  one sentence" [ "$code" -eq 0 -o "$(cat stderr)" = \
    'signorini: out of memory: there is not enough for this computation.' ]
done

(
  ulimit -s $stack
  timeout 100 "$program" scene.prm --output none >stdout 2>stderr
)
code=$?
check "a stack of $stack KiB: exit code 1" [ "$code" -eq 1 ]
check "  one sentence" grep -q "^signorini: The stack of a process is limited to $stack KiB" stderr

mkdir nowhere
scene=$PWD/scene.prm
cd nowhere && rmdir ../nowhere
timeout 100 "$program" "$scene" --output "$directory/none" >"$directory/stdout" 2>"$directory/stderr"
code=$?
cd "$directory" || exit 1
check "no working directory: exit code 1" [ "$code" -eq 1 ]
check "  one sentence" one_line_of_complaint

if [ -x "$mpirun" ]; then
  # on_ranks SCRIPT ARGUMENTS...: runs the script on rank 1 before the program begins there.
  on_ranks() {
    local script=$1
    shift
    timeout 100 "$mpirun" -np 2 bash -c 'script=$1 && shift && [ "${OMPI_COMM_WORLD_RANK:-$PMI_RANK}" = 0 ] || eval "$script"; exec "$@"' \
      on_ranks "$script" "$program" "$@" >stdout 2>stderr </dev/null
  }
  mkdir other
  sed 's/A1/A2/' scene.prm >other/scene.prm
  printf 'subsection Geometry\n  set Shape = file\n  set File = part.msh\nend\n' >part.prm
  cp part.prm other/part.prm
  echo '$one' >part.msh
  echo '$other' >other/part.msh
  on_ranks 'cd other' scene.prm part.prm --output ranks
  check "ranks with different files: exit code 1" [ $? -eq 1 ]
  check "  it is said" says 'scene.prm: found another text on rank 1'
  check "  also of mesh files" says 'part.prm:3: Geometry/File: found another text on rank 1 than on the first rank, allowed'
  for name in scene part; do check "  exit code 1 for $name.prm" ends_with_code 1 "$name.prm"; done
  check "  nothing is solved" [ ! -e ranks ]
  # Rank 1 has no directory for its part of the body, as on machines without a common file system.
  cat >plate.prm <<'PRM'
subsection Boundary
  set Clamped = top
  set Contact = bottom
end
subsection Load
  set Body force = 0; -0.01
end
subsection Discretization
  set Coarsest level = 4
  set Finest level = 4
end
subsection Solver
  set Linear solver = amesos_mumps
end
subsection Output
  set Bound = false
end
PRM
  cp plate.prm other/plate.prm
  on_ranks 'cd other' plate.prm
  check "a rank without the directory: exit code 3, and no rank waits" [ $? -eq 3 ]
  check "  one sentence" [ "$(grep -c '^signorini: ' stderr)" -eq 1 ]
  check "  which names the file and the rank" says "solution-04.0001.vtu' could not be written: rank 1 does not see the directory"
  on_ranks 'set -- "$@" --set "Discretization/Finest level=5"' scene.prm --output ranks
  check "ranks with different levels: exit code 1" [ $? -eq 1 ]
  check "  it is said" says 'another command line was given to rank 1'
else
  echo "SKIP several ranks: there is no mpirun"
fi
check "nothing was made in vain" [ ! -e none/convergence.csv -o -s none/convergence.csv ]
echo "$failures failures"
[ "$failures" -eq 0 ]
