#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Runs that are killed by a signal at any stage leave complete files that say so, and harm no later run.
# usage: killed.sh PROGRAM ROOT MPIRUN

program=$(realpath "$1")
mpirun=$3
. "$(dirname "$0")/results.bash"

write_scene 3
mv scene.prm short.prm
# Level 9 takes longer than any of the waits below.
write_scene 9
run() { "$program" short.prm --output "$1" >stdout 2>stderr; }

# kill_run SIGNAL FILE SECONDS COMMAND...: kills the command SECONDS after the file has appeared; returns its exit code.
kill_run() {
  local signal=$1 file=$2 seconds=$3 process
  shift 3
  # A shell lets what runs in its background ignore SIGINT. Its copy would tidy up when killed, and can lose the signal: the
  # command has to be there before it is killed.
  trap - EXIT
  env --default-signal "$@" >stdout 2>stderr &
  process=$!
  trap 'rm -rf "$directory"' EXIT
  while grep -qxE 'bash|env' "/proc/$process/comm" 2>/dev/null; do pause 0.01; done
  wait_for "$file" "$process"
  pause "$seconds"
  kill -s "$signal" "$process"
  wait "$process" 2>shell
}

one_sentence() { [ "$(grep -Ec "^signorini: interrupted by signal $1 $2\.\$" stderr)" -eq 1 ]; }

long=("$program" scene.prm)
run fresh
check "the run that others are compared with" verdict_is fresh certified
check "complete files" no_half_files fresh

# again NAME: the results of an earlier run, in again/NAME, where NAME.prm is going to be run.
mkdir again
again() {
  cp -r fresh "again/$1"
  cp short.prm "$1.prm"
}

# has_answer DIRECTORY: of the level of the last row, or of the one whose row is not written yet; before the first row there
# may be none.
has_answer() {
  local row level
  row=$(tail -n +2 "$1/convergence.csv" 2>/dev/null | tail -n 1 | cut -d, -f1)
  [ -n "$row" ] || return 0
  level=$(sed -n 's/^  "level": \([0-9]*\),$/\1/p' "$1/answer.json")
  [ "$level" -eq "$row" ] || [ "$level" -eq $((row + 1)) ]
}

# kill_again SIGNAL EXIT_CODE FILE SECONDS
kill_again() {
  local name=$1-${3%.*}
  killed+=("$name")
  again "$name"
  # This file is removed when the run begins, and written again by its level.
  rm -f "again/$name/$3"
  kill_run "$1" "again/$name/$3" "$4" "${long[@]}" --output "again/$name"
  check "SIG$1 $4 s after $3: exit code $2" [ $? -eq "$2" ]
  check "  complete files" no_half_files "again/$name"
  check "  an honest verdict" verdict_is "again/$name" unfinished
  if [ "$1" != KILL ]; then
    check "  one sentence" one_sentence $(($2 - 128)) "on level [1-9]: .*; the results of finished levels are complete"
    check "  answers of the last finished level" has_answer "again/$name"
  fi
}
killed=()
kill_again TERM 143 contact-01.csv 0
kill_again INT 130 contact-05.vtu 0
kill_again HUP 129 contact-05.csv 0.2
kill_again KILL 137 solution-02.vtu 0
kill_again KILL 137 contact-04.csv 0
kill_again KILL 137 D-06.mtx 0.01

# Before MPI has started nothing has been touched.
cp -r fresh kept
kill_run TERM scene.prm 0 "${long[@]}" --output kept
check "SIGTERM at once: exit code 143" [ $? -eq 143 ]
check "  and nothing is changed" same_results fresh kept

# A pipe where a file is going to be written must not be waited for.
again piped
rm -r again/piped/*
mkfifo again/piped/.parameters.prm.part again/piped/.trial.part again/piped/.contact-01.csv.part
# Half files of runs that were killed earlier, and results that have no part in this one.
again old
touch again/old/.convergence.csv.part again/old/.solution-07.vtu.part again/old/solution-07.vtu again/old/contact-09.csv
again foreign
echo mine >again/foreign/notes.txt
echo mine >again/foreign/.contact.part
next=("${killed[@]}" piped old foreign)
timeout 300 "$program" "${next[@]/%/.prm}" --output again >stdout 2>stderr
check "the next runs: exit code 0" [ $? -eq 0 ]
for name in "${killed[@]}"; do
  check "  after $name the next run is as good as the first" same_results fresh "again/$name"
done
check "  pipes in the place of temporary files: exit code 0" ends_with piped.prm certified 0 again/piped
check "  the same results" same_results fresh again/piped
check "  files of an earlier run are gone" same_results fresh again/old
check "  foreign files stay" [ "$(cat again/foreign/notes.txt again/foreign/.contact.part | tr '\n' ' ')" = 'mine mine ' ]

# Wrong input destroys nothing, also where it shows on the first level only.
mkdir -p wrong/late
cp -r fresh wrong/gap
cp -r fresh wrong/ratio
echo mine >wrong/late/notes.txt
variant short.prm gap Contact/Gap=y
variant short.prm ratio 'Discretization/Patch ratio=1' 'Solver/Require stability=true'
cp ratio.prm late.prm
# No number in a strip that is narrower than all distances of points.
variant short.prm nothing Scene/Name=described Boundary/Clamped=top Boundary/Contact=bottom \
  'Load/Body force=0; sqrt(abs(x-0.351207)-1e-6)'
"$program" gap.prm ratio.prm late.prm nothing.prm --output wrong >stdout 2>stderr
check "wrong input: exit code 1" [ $? -eq 1 ]
# refused SCENE WHAT
refused() { check "$2: exit code 1" ends_with "$1.prm" 'wrong input' 1 "wrong/$1"; }
refused gap "wrong input"
check "  leaves earlier results alone" same_results fresh wrong/gap
refused ratio "wrong input that shows on a level"
check "  leaves earlier results alone" same_results fresh wrong/ratio
check "  which is said" [ "$(grep -c 'Require stability: a contact patch is no longer than a face' stderr)" -eq 2 ]
refused late "wrong input that shows on the first level"
check "  leaves nothing behind" [ "$(ls -A wrong/late)" = notes.txt ]
refused nothing "wrong input between all points"
check "  which is said" grep -q 'Load/Body force: found the value nan' stderr
check "  leaves nothing behind" [ ! -e wrong/nothing ]

# Two runs at once, the first of them started by nohup.
nohup "${long[@]}" --output shared >stdout.first 2>stderr.first &
first=$!
wait_for shared/contact-01.csv "$first"
kill -HUP "$first"
wait_for shared/contact-03.csv "$first"
# It has outlived the signal, and sleeps while the second one tries.
kill -STOP "$first"
run shared
check "two runs in one directory: exit code 1" [ $? -eq 1 ]
check "  in one sentence" grep -q "'shared', into which another run is writing" stderr
check "  the first goes on, and nohup keeps its meaning" kill -TERM "$first"
kill -CONT "$first"
wait "$first" 2>shell

# On two ranks mpirun passes the signal on. Open MPI kills ranks that have not ended a second later, too early on a machine
# that does other things.
if [ -x "$mpirun" ]; then
  export OMPI_MCA_odls_base_sigkill_timeout=5
  # Each rank writes to a file of its own: mpirun may end before it has passed on what they say.
  kill_run TERM ranks/solution-03.vtu 0 "$mpirun" -np 2 \
    bash -c 'exec "$@" 2>"said.${OMPI_COMM_WORLD_RANK:-$PMI_RANK}"' rank "${long[@]}" --output ranks
  code=$?
  cat said.0 said.1 >stderr
  check "two ranks: not exit code 0" [ "$code" -ne 0 ]
  check "  one sentence" one_sentence 15 "on level [1-9]: .*"
  check "  complete files" no_half_files ranks
  check "  an honest verdict" verdict_is ranks unfinished
  # What was being written has a temporary name, and goes with the next run.
  run ranks
  check "  the next run is as good as the first" same_results fresh ranks
else
  echo "SKIP two ranks: there is no mpirun"
fi
echo "$failures failures"
[ "$failures" -eq 0 ]
