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

write_scene 9
mv scene.prm long.prm
write_scene 4
variant scene.prm brief 'Discretization/Finest level=2' 'Solver/Tolerated error=1'

# failed_honestly DIRECTORY: after a run that could not write all its files.
failed_honestly() {
  check "  one sentence, which names the file" \
    [ "$(grep -c "^signorini: The file '$1/.*' could not be written: the disk is full" stderr)" -eq 1 ]
  check "  no temporary files" no_temporary_files "$1"
  check "  complete files" no_half_files "$1"
  check "  no wrong verdict" grep -Eq '"verdict": "(unfinished|not certified)"' "$1/certificate.json"
}
sentences() { check "  $1 sentences" [ "$(wc -l <stderr)" -eq "$1" ]; }
no_residuals() { check "  no word of residuals" [ "$(grep -c 'KKT residuals are' stdout)" -eq 0 ]; }

# One run for each of several disks, which are mounted on one that is itself read-only.
small_disks() {
  local disk disks=(48k 96k 160k 240k few)
  mkdir small
  mount -t tmpfs none small
  for disk in "${disks[@]}" full; do
    mkdir "small/$disk"
    cp scene.prm "$disk.prm"
  done
  cp scene.prm results.prm
  mount -o remount,ro small
  for disk in 48k 96k 160k 240k; do mount -t tmpfs -o "size=$disk" none "small/$disk"; done
  # Bytes enough, but no room for more than ten files.
  mount -t tmpfs -o size=9m,nr_inodes=10 none small/few
  mount -t tmpfs -o size=4k,nr_inodes=4 none small/full
  head -c 4096 /dev/zero >small/full/other
  timeout 600 "$program" "${disks[@]/%/.prm}" full.prm results.prm --output small >stdout 2>stderr
  check "small disks: exit code 3" [ $? -eq 3 ]
  sentences $((${#disks[@]} + 2))
  no_residuals
  for disk in "${disks[@]}"; do
    check "a disk of $disk: exit code 3" ends_with "$disk.prm" 'not written' 3 "small/$disk"
    failed_honestly "small/$disk"
  done
  check "a disk that is full from the start: exit code 1" ends_with full.prm 'wrong input' 1 small/full
  check "  one sentence" [ "$(grep -c "^signorini: .*'small/full" stderr)" -eq 1 ]
  check "  leaves nothing behind" [ "$(ls -A small/full)" = other ]
  check "a read-only disk: exit code 1" ends_with results.prm 'wrong input' 1 small/results
  check "  one sentence" grep -q "^signorini: --output: found 'small/results', allowed: a directory that can be" stderr
  for disk in "${disks[@]}"; do mount -o remount,size=9m,nr_inodes=100 "small/$disk"; done
  timeout 600 "$program" "${disks[@]/%/.prm}" --output small >stdout 2>stderr
  for disk in "${disks[@]}"; do check "$disk with more room: as good as ever" same_results reference/large "small/$disk"; done
  umount -R small
}

# A small disk under a run on two ranks.
shared_disk() {
  mkdir shared
  mount -t tmpfs -o size=96k none shared
  timeout 600 "$mpirun" -np 2 "$program" scene.prm --output shared >stdout 2>stderr.all
  check "a disk of 96k, two ranks: exit code 3" [ $? -eq 3 ]
  # mpirun has something to say about exit codes, too.
  grep '^signorini' stderr.all >stderr
  sentences 1
  no_residuals
  failed_honestly shared
  umount shared
}

cp scene.prm large.prm
"$program" large.prm brief.prm --output reference >stdout 2>stderr
check "a disk that is large enough" verdict_is reference/large certified
check "complete files" no_half_files reference/large
taken=(gone)
if [ "$SIGNORINI_MAY_MOUNT" = yes ]; then
  small_disks
  if [ -x "$mpirun" ]; then shared_disk; else echo "SKIP two ranks: there is no mpirun"; fi
  taken+=(protected)
  mkdir -p taken/protected
  mount -t tmpfs none taken/protected
else
  echo "SKIP small and read-only disks: this system does not let tests mount any"
fi
if (prlimit --pid "$BASHPID" --fsize=100000) 2>stderr; then
  taken+=(limited)
else
  echo "SKIP a limit to the size of files: there is no prlimit"
fi

# From three long runs, one after the other, is taken away: the directory, the right to write to the disk, and the right to
# write a file of more than 100 kB.
for scene in "${taken[@]}"; do cp long.prm "$scene.prm"; done
"$program" "${taken[@]/%/.prm}" --output taken >stdout 2>stderr &
process=$!
wait_for taken/gone/contact-01.csv "$process"
until rm -rf taken/gone 2>/dev/null; do :; done
if [[ " ${taken[*]} " == *' protected '* ]]; then
  wait_for taken/protected/contact-02.csv "$process"
  until mount -o remount,ro taken/protected 2>/dev/null; do pause 0.001; done
fi
if [[ " ${taken[*]} " == *' limited '* ]]; then
  wait_for taken/limited/contact-02.csv "$process"
  prlimit --pid "$process" --fsize=100000
fi
wait "$process"
check "runs from which something is taken away: exit code 3" [ $? -eq 3 ]
sentences "${#taken[@]}"
no_residuals
check "a directory that is removed: exit code 3" ends_with gone.prm 'not written' 3 taken/gone
check "  one sentence, which names the file" [ "$(grep -c "^signorini: The file 'taken/gone/" stderr)" -eq 1 ]
check "  and stays removed" [ ! -e taken/gone ]
for scene in "${taken[@]:1}"; do
  check "a disk that becomes $scene: exit code 3" ends_with "$scene.prm" 'not written' 3 "taken/$scene"
  failed_honestly "taken/$scene"
done
if [ "$SIGNORINI_MAY_MOUNT" = yes ]; then umount taken/protected; fi

told_on_stderr() { [ "$(cat stderr)" = 'signorini: the standard output could not be written.' ]; }
"$program" brief.prm --output printed >/dev/full 2>stderr
check "a full disk under the standard output: exit code 3" [ $? -eq 3 ]
check "  one sentence" told_on_stderr
check "  the results are there" same_results reference/brief printed
"$program" brief.prm --output printed >&- 2>stderr
check "a closed standard output: exit code 3" [ $? -eq 3 ]
check "  one sentence" told_on_stderr
check "  and nothing printed into the results" same_results reference/brief printed
"$program" scene.prm --output printed 2>stderr | head -n 1 >stdout
check "a reader that goes away: exit code 3" [ "${PIPESTATUS[0]}" -eq 3 ]
check "  one sentence" told_on_stderr
check "  the results are there" same_results reference/large printed
"$program" --help >/dev/full 2>stderr
check "no room for the help: exit code 3" [ $? -eq 3 ]
check "  one sentence" told_on_stderr
"$program" --print-parameters 2>stderr | true
check "nobody reads the parameters: no complaints" [ ! -s stderr ]
"$program" scene.prm --set 'Contact/Gap=(' --output printed 2>&- >stdout
check "nobody hears complaints: the exit code tells" [ $? -eq 1 ]
echo "$failures failures"
[ "$failures" -eq 0 ]
