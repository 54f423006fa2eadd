#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Disks that are full, read-only or gone, and outputs that nobody takes: an honest message, an exit code, no half files.
# usage: disk.sh PROGRAM ROOT MPIRUN

# In a user namespace of its own a test may mount small disks.
if [ -z "${SIGNORINI_MAY_MOUNT:-}" ]; then
  SIGNORINI_MAY_MOUNT=no
  if unshare -rm mount -t tmpfs none /mnt 2>/dev/null; then
    export SIGNORINI_MAY_MOUNT=yes
    exec unshare -rm bash "$0" "$@"
  fi
fi
program=$(realpath "$1")
mpirun=$3
. "$(dirname "$0")/results.bash"

write_scene 5
run() {
  timeout 600 "$program" scene.prm "$@" >stdout 2>stderr
  code=$?
}
could_not_write() { grep -q "^signorini: The file '$1.*' could not be written: the disk is full" stderr; }

# failed_honestly DIRECTORY: after a run that could not write all its files.
failed_honestly() {
  check "  exit code 3" [ "$code" -eq 3 ]
  check "  one sentence" one_line stderr
  check "  which names the file" could_not_write "$1/"
  check "  no temporary files" no_temporary_files "$1"
  check "  complete files" no_half_files "$1"
  check "  no word of residuals" [ "$(grep -c 'KKT residuals are' stdout)" -eq 0 ]
  check "  no wrong verdict" grep -Eq '"verdict": "(unfinished|not certified)"' "$1/certificate.json"
}

small_disks() {
  local options
  mkdir small
  # The last one: bytes enough, but no room for more than ten files.
  for options in size=48k size=96k size=160k size=240k size=9m,nr_inodes=10; do
    mount -t tmpfs -o "$options" none small
    run --output small
    check "a disk of $options" [ "$code" -ne 0 ]
    failed_honestly small
    mount -o remount,size=9m,nr_inodes=100 small
    run --output small
    check "  with more room: as good as ever" same_results large small
    umount small
  done
  mount -t tmpfs -o size=4k,nr_inodes=4 none small
  head -c 4096 /dev/zero >small/other
  run --output small
  check "a disk that is full from the start: exit code 1" [ "$code" -eq 1 ]
  check "  one sentence" one_line stderr
  check "  leaves nothing behind" [ "$(ls -A small)" = other ]
  umount small
  if [ -x "$mpirun" ]; then
    mount -t tmpfs -o size=96k none small
    timeout 600 "$mpirun" -np 2 "$program" scene.prm --output small >stdout 2>stderr.all
    code=$?
    # mpirun has something to say about exit codes, too.
    grep '^signorini' stderr.all >stderr
    check "a disk of 96k, two ranks" [ "$code" -ne 0 ]
    failed_honestly small
    umount small
  else
    echo "SKIP two ranks: there is no mpirun"
  fi
}

read_only_disks() {
  mkdir protected
  mount -t tmpfs -o ro none protected
  run --output protected/results
  check "a read-only disk: exit code 1" [ "$code" -eq 1 ]
  check "  one sentence" grep -q "^signorini: --output: found 'protected/results', allowed: a directory that can be" stderr
  mount -o remount,rw protected
  "$program" scene.prm --set 'Discretization/Finest level=9' --output protected >stdout 2>stderr &
  local process=$!
  until [ -e protected/contact-04.csv ] || ! kill -0 "$process"; do sleep 0.02; done
  until mount -o remount,ro protected 2>/dev/null; do sleep 0.001; done
  wait "$process"
  code=$?
  check "a disk that becomes read-only" [ "$code" -ne 0 ]
  failed_honestly protected
  umount protected
}

run --output large
check "a disk that is large enough" verdict_is large certified
check "complete files" no_half_files large
if [ "$SIGNORINI_MAY_MOUNT" = yes ]; then
  small_disks
  read_only_disks
else
  echo "SKIP small and read-only disks: this system does not let tests mount any"
fi

"$program" scene.prm --set 'Discretization/Finest level=9' --output gone >stdout 2>stderr &
process=$!
until [ -e gone/contact-03.csv ] || ! kill -0 "$process"; do sleep 0.02; done
until rm -rf gone 2>/dev/null; do :; done
wait "$process"
check "a directory that is removed: exit code 3" [ $? -eq 3 ]
check "  one sentence" one_line stderr
check "  which names the file" grep -q "^signorini: The file 'gone/" stderr
check "  and stays removed" [ ! -e gone ]

# From here on the process may write no file of more than 100 kB.
"$program" scene.prm --set 'Discretization/Finest level=9' --output limited >stdout 2>stderr &
process=$!
until [ -e limited/contact-02.csv ] || ! kill -0 "$process"; do sleep 0.02; done
if prlimit --pid "$process" --fsize=100000 2>/dev/null; then
  wait "$process"
  code=$?
  check "a limit to the size of files" [ "$code" -ne 0 ]
  failed_honestly limited
else
  echo "SKIP a limit to the size of files: there is no prlimit"
  kill "$process"
fi

told_on_stderr() { [ "$(cat stderr)" = 'signorini: the standard output could not be written.' ]; }
"$program" scene.prm --output printed >/dev/full 2>stderr
check "a full disk under the standard output: exit code 3" [ $? -eq 3 ]
check "  one sentence" told_on_stderr
check "  the results are there" same_results large printed
"$program" scene.prm --output printed >&- 2>stderr
check "a closed standard output: exit code 3" [ $? -eq 3 ]
check "  one sentence" told_on_stderr
check "  and nothing printed into the results" same_results large printed
"$program" scene.prm --output printed 2>stderr | head -n 1 >stdout
check "a reader that goes away: exit code 3" [ "${PIPESTATUS[0]}" -eq 3 ]
check "  one sentence" told_on_stderr
check "  the results are there" same_results large printed
"$program" --help >/dev/full 2>stderr
check "no room for the help: exit code 3" [ $? -eq 3 ]
check "  one sentence" told_on_stderr
"$program" --print-parameters 2>stderr | true
check "nobody reads the parameters: no complaints" [ ! -s stderr ]
"$program" scene.prm --set 'Contact/Gap=(' --output printed 2>&- >stdout
check "nobody hears complaints: the exit code tells" [ $? -eq 1 ]
echo "$failures failures"
[ "$failures" -eq 0 ]
