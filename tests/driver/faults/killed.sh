#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Runs that are killed by a signal at any stage leave complete files that say so, and harm no later run.
# usage: killed.sh PROGRAM ROOT MPIRUN

program=$(realpath "$1")
mpirun=$3
. "$(dirname "$0")/results.bash"

write_scene 6
run() { "$program" scene.prm --set "Discretization/Finest level=$1" --output "$2" >stdout 2>stderr; }

# kill_run SIGNAL FILE SECONDS COMMAND...: kills the command SECONDS after the file has appeared; returns its exit code.
kill_run() {
  local signal=$1 file=$2 seconds=$3 process
  shift 3
  # A shell lets what runs in its background ignore SIGINT, and until the program begins, its copy would tidy up when killed.
  trap - EXIT
  env --default-signal "$@" >stdout 2>stderr &
  process=$!
  trap 'rm -rf "$directory"' EXIT
  until [ -e "$file" ] || ! kill -0 "$process" 2>/dev/null; do sleep 0.02; done
  sleep "$seconds"
  kill -s "$signal" "$process"
  wait "$process" 2>shell
}

one_sentence() { [ "$(grep -Ec "^signorini: interrupted by signal $1 $2\.\$" stderr)" -eq 1 ]; }

# Level 9 takes longer than any of these waits.
long=("$program" scene.prm --set 'Discretization/Finest level=9')
run 4 fresh
check "the run that others are compared with" verdict_is fresh certified
check "complete files" no_half_files fresh
cp -r fresh again

# kill_and_repeat SIGNAL EXIT_CODE FILE SECONDS
kill_and_repeat() {
  # This file is removed when the run begins, and written again by its level.
  rm -f "again/$3"
  kill_run "$1" "again/$3" "$4" "${long[@]}" --output again
  check "SIG$1 $4 s after $3: exit code $2" [ $? -eq "$2" ]
  check "  complete files" no_half_files again
  check "  an honest verdict" verdict_is again unfinished
  if [ "$1" != KILL ]; then
    check "  one sentence" one_sentence $(($2 - 128)) "on level [1-9]: .*; the results of finished levels are complete"
  fi
  run 4 again
  check "  the next run is as good as the first" same_results fresh again
}
kill_and_repeat TERM 143 contact-01.csv 0
kill_and_repeat INT 130 contact-06.vtu 0
kill_and_repeat HUP 129 contact-06.csv 0.2
kill_and_repeat KILL 137 solution-02.vtu 0
kill_and_repeat KILL 137 contact-05.csv 0
kill_and_repeat KILL 137 D-06.mtx 0.01

# Before MPI has started nothing has been touched.
kill_run TERM scene.prm 0 "${long[@]}" --output again
check "SIGTERM at once: exit code 143" [ $? -eq 143 ]
check "  and nothing is changed" same_results fresh again

# A pipe where a file is going to be written must not be waited for.
mkdir piped
mkfifo piped/.parameters.prm.part piped/.trial.part piped/.contact-01.csv.part
timeout 60 "$program" scene.prm --set 'Discretization/Finest level=4' --output piped >stdout 2>stderr
check "pipes in the place of temporary files: exit code 0" [ $? -eq 0 ]
check "  the same results" same_results fresh piped

# Half files of runs that were killed earlier, and results that have no part in this one.
cp -r fresh old
touch old/.convergence.csv.part old/.solution-07.vtu.part old/solution-07.vtu old/contact-09.csv
run 4 old
check "files of an earlier run are gone" same_results fresh old
echo mine >old/notes.txt
echo mine >old/.contact.part
run 4 old
check "foreign files stay" [ "$(cat old/notes.txt old/.contact.part | tr '\n' ' ')" = 'mine mine ' ]

# Wrong input destroys nothing.
cp -r fresh kept
"$program" scene.prm --set 'Contact/Gap=y' --output kept >stdout 2>stderr
check "wrong input: exit code 1" [ $? -eq 1 ]
check "  leaves earlier results alone" same_results fresh kept
"$program" scene.prm --set 'Discretization/Patch ratio=1' --set 'Solver/Require stability=true' --output kept >stdout 2>stderr
check "wrong input that shows on a level: exit code 1" [ $? -eq 1 ]
check "  leaves earlier results alone" same_results fresh kept
mkdir late
echo mine >late/notes.txt
"$program" scene.prm --set 'Discretization/Patch ratio=1' --set 'Solver/Require stability=true' --output late >stdout 2>stderr
check "wrong input that shows on the first level: exit code 1" [ $? -eq 1 ]
check "  leaves nothing behind" [ "$(ls -A late)" = notes.txt ]
# No number in a strip that is narrower than all distances of points.
"$program" scene.prm --set 'Scene/Name=described' --set 'Boundary/Clamped=top' --set 'Boundary/Contact=bottom' \
  --set 'Load/Body force=0; sqrt(abs(x-0.351207)-1e-6)' --output nothing >stdout 2>stderr
check "wrong input between all points: exit code 1" [ $? -eq 1 ]
check "  leaves nothing behind" [ ! -e nothing ]

# Two runs at once, the first of them started by nohup.
nohup "${long[@]}" --output shared >stdout.first 2>stderr.first &
first=$!
until [ -e shared/contact-01.csv ] || ! kill -0 "$first" 2>/dev/null; do sleep 0.02; done
kill -HUP "$first"
run 4 shared
check "two runs in one directory: exit code 1" [ $? -eq 1 ]
check "  in one sentence" grep -q "'shared', into which another run is writing" stderr
check "  the first goes on, and nohup keeps its meaning" kill -TERM "$first"
wait "$first" 2>shell

# On two ranks mpirun passes the signal on. Open MPI kills ranks that have not ended a second later, too early on a machine
# that does other things.
if [ -x "$mpirun" ]; then
  export OMPI_MCA_odls_base_sigkill_timeout=5
  # Each rank writes to a file of its own: mpirun may end before it has passed on what they say.
  kill_run TERM ranks/solution-05.vtu 0 "$mpirun" -np 2 \
    bash -c 'exec "$@" 2>"said.${OMPI_COMM_WORLD_RANK:-$PMI_RANK}"' rank "${long[@]}" --output ranks
  code=$?
  cat said.0 said.1 >stderr
  check "two ranks: not exit code 0" [ "$code" -ne 0 ]
  check "  one sentence" one_sentence 15 "on level [1-9]: .*"
  check "  no temporary files" no_temporary_files ranks
  check "  complete files" no_half_files ranks
  check "  an honest verdict" verdict_is ranks unfinished
else
  echo "SKIP two ranks: there is no mpirun"
fi
echo "$failures failures"
[ "$failures" -eq 0 ]
