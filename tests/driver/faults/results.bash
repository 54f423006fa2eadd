# SPDX-License-Identifier: LGPL-2.1-or-later
# Sourced by the tests of this folder: what the files of a run look like, finished or not.

. "$(dirname "${BASH_SOURCE[0]}")/../../checks.bash"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1

# write_scene LEVEL: scene.prm, A1 up to that level with all files that a run can write.
write_scene() {
  cat >scene.prm <<PRM
subsection Scene
  set Name = A1
end
subsection Discretization
  set Coarsest level = 1
  set Finest level   = $1
end
subsection Output
  set VTU = all
  set Compliance = true
end
PRM
}

no_temporary_files() { [ -z "$(find "$1" -name '*.part')" ]; }
one_line() {
  local lines
  mapfile lines <"$1"
  [[ ${#lines[@]} -eq 1 && ${lines[0]} == *$'\n' ]]
}

# pause SECONDS: sleeps without starting a process.
mkfifo silence
exec {silence}<>silence
rm silence
pause() { read -rt "$1" -u "$silence" || :; }
# wait_for FILE PROCESS: waits until the file is there, or the process is gone.
wait_for() { until [ -e "$1" ] || ! kill -0 "$2" 2>/dev/null; do pause 0.02; done; }

# no_half_files DIRECTORY: every file that is there ends as its kind has to.
no_half_files() {
  local file tables=()
  for file in "$1"/*; do
    case $file in
      *.csv) tables+=("$file") && [ -s "$file" ] ;;
      *.vtu | *.pvtu | *.pvd | *.json | *.prm | *.mtx) [ -s "$file" ] ;;
      *) false ;;
    esac || { echo "half a file, or not one of a run: $file"; return 1; }
  done
  [ -z "$(tail -qc 1 /dev/null "${tables[@]}")" ] || { echo "half a line in one of ${tables[*]}"; return 1; }
  awk -F, '
    function is_half() {
      if (kind == "csv") return odd
      if (kind == "json") return (first last) != "{}"
      if (kind == "prm") return last != "end"
      if (kind == "mtx") return first !~ /^%%MatrixMarket/
      return (before "\n" last) !~ /<\/VTKFile>/
    }
    function finish() { if (is_half()) { print "half a file: " file; wrong = 1 } }
    FNR == 1 { if (NR > 1) finish(); file = kind = FILENAME; sub(/.*\./, "", kind); first = $0; last = ""; fields = NF; odd = 0 }
    kind == "mtx" { nextfile }
    { before = last; last = $0 }
    kind == "csv" && NF != fields { odd = 1 }
    END { finish(); exit wrong }' "$1"/*
}

# table DIRECTORY: convergence.csv without the columns of times and memory.
table() {
  awk -F, 'NR == 1 { for (c = 1; c <= NF; ++c) skip[c] = $c ~ /^t_|^cpu_total$|^peak_memory_mb$/ }
    { line = ""; for (c = 1; c <= NF; ++c) if (!skip[c]) line = line "," $c; print line }' "$1/convergence.csv"
}

# numbers DIRECTORY: what stands in convergence.csv and answer.json, without seconds.
numbers() { table "$1" && grep -v '"seconds"' "$1/answer.json"; }

# same_results A B: the same files, and in them the same digits, seconds apart.
same_results() {
  [ -s "$1/convergence.csv" ] && [ -s "$1/answer.json" ] &&
    diff -rq -x convergence.csv -x answer.json "$1" "$2" &&
    [ "$(ls -A "$1")" = "$(ls -A "$2")" ] && diff <(numbers "$1") <(numbers "$2")
}
