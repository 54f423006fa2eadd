#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# What stops a run before it has begun, or is taken away from it: one sentence and an exit code, and nothing of the user is lost.
# usage: start.sh PROGRAM ROOT MPIRUN

program=$(realpath "$1")
mpirun=$3
. "$(dirname "$0")/results.bash"

write_scene 4
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

# A process without a launcher has no folder of a session, which others would share.
TMPDIR=/proc/none run 1 missing.prm
check "  and no folder" says 'missing.prm: this parameter file cannot be read.'
# Side by side: SIGNORINI_STARTS=100 makes 400 of them.
for queue in 1 2 3 4; do
  for ((i = 0; i < ${SIGNORINI_STARTS:-3}; ++i)); do
    timeout 100 "$program" missing.prm >/dev/null 2>&1 </dev/null
    [ $? -eq 1 ] || echo "start $i of queue $queue"
  done >failed_starts.$queue &
done
wait
check "starts side by side" [ -z "$(cat failed_starts.*)" ]

# What the libraries need before the program begins: in Debian 12 520 MB and less than 64 KiB of stack, in later ones more.
# A computation that fits may succeed.
limits="550 650 750 1000" stack=64
if ! grep -q '^VERSION_ID="12"' /etc/os-release; then limits="710 810 910 1160" stack=512; fi
if ! (ulimit -v 20000000 && "$program" --version >stdout 2>stderr); then
  echo "SKIP limits of the address space: this build (with sanitizers?) needs more than 20 GB of it"
  limits=""
fi
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

ln -s missing dangling
run 1 scene.prm --output dangling
check "  the link stays" [ -L dangling ]
run 1 scene.prm --output dangling/below
check "  the link stays" [ -L dangling ]

cp scene.prm parameters.prm
run 1 parameters.prm --output .
check "  the scene stays" cmp -s scene.prm parameters.prm
cp scene.prm contact-02.csv
run 1 contact-02.csv --output .
check "  under any name" cmp -s scene.prm contact-02.csv
rm parameters.prm contact-02.csv
# The results go to another place than the file at first sight; so does what is removed again.
cp scene.prm mine.prm
run 1 mine.prm --output new/../mine.prm
check "  the scene stays" cmp -s scene.prm mine.prm
check "  and no directory" [ ! -e new ]
mkdir linked
cp scene.prm linked/contact-09.csv
ln -s linked/contact-09.csv by_link.prm
ln linked/contact-09.csv by_name.prm
for file in by_link.prm by_name.prm; do
  run 1 $file --output new/../linked
  check "  about the file" says "$file"
done
check "  the file stays" cmp -s scene.prm linked/contact-09.csv
cat >linked/answer.json <<'MSH'
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
ln -s linked/answer.json mesh.msh
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
cp linked/answer.json answer.json
run 1 mesh.prm --output linked
check "  about the mesh" says "mesh.msh"
check "  which stays" cmp -s answer.json linked/answer.json
mkdir next
cp scene.prm next.prm
cp scene.prm next/sweep.csv
run 1 next/sweep.csv --sweep 'Discretization/Finest level=4, 5' --output next
cp scene.prm next/contact-02.csv
run 1 next.prm next/contact-02.csv --output .
check "  a scene that is still to come stays" cmp -s scene.prm next/contact-02.csv
rm answer.json
run 0 scene.prm --output repeated
run 0 repeated/parameters.prm --output repeated

long=$(printf 'directory/%.0s' {1..20})
run 1 "$long/scene.prm"
check "  long paths are shortened" [ "$(wc -c <stderr)" -lt 150 ]

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
  on_ranks 'cd other' scene.prm --output ranks
  check "ranks with different files: exit code 1" [ $? -eq 1 ]
  check "  it is said" says 'scene.prm: found another text on rank 1'
  check "  nothing is solved" [ ! -e ranks ]
  on_ranks 'set -- "$@" --set "Discretization/Finest level=5"' scene.prm --output ranks
  check "ranks with different levels: exit code 1" [ $? -eq 1 ]
  check "  it is said" says 'another command line was given to rank 1'
  printf 'subsection Geometry\n  set Shape = file\n  set File = part.msh\nend\n' >mesh.prm
  cp mesh.prm other/mesh.prm
  echo '$one' >part.msh
  echo '$other' >other/part.msh
  on_ranks 'cd other' mesh.prm --output ranks
  check "ranks with different mesh files: exit code 1" [ $? -eq 1 ]
  check "  the first rank's is read" says 'mesh.prm:3: Geometry/File: found no $MeshFormat'
else
  echo "SKIP several ranks: there is no mpirun"
fi
check "nothing was made in vain" [ ! -e none/convergence.csv -o -s none/convergence.csv ]
echo "$failures failures"
[ "$failures" -eq 0 ]
