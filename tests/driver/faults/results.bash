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

verdict() { sed -n 's/^  "verdict": "\(.*\)",$/\1/p' "$1/certificate.json"; }
verdict_is() { [ "$(verdict "$1")" = "$2" ]; }
no_temporary_files() { [ -z "$(find "$1" -name '*.part')" ]; }
one_line() { [ "$(wc -l <"$1")" -eq 1 ]; }

# no_half_files DIRECTORY: every file that is there ends as its kind has to.
no_half_files() {
  local file
  for file in "$1"/*; do
    case $file in
      *.csv) awk -F, 'NR == 1 { n = NF } NF != n { exit 1 } END { exit NR == 0 }' "$file" &&
        [ -z "$(tail -c 1 "$file")" ] ;;
      *.vtu | *.pvtu | *.pvd) tail -n 2 "$file" | grep -q '</VTKFile>' ;;
      *.json) [ "$(head -n 1 "$file")$(tail -n 1 "$file")" = '{}' ] ;;
      *.prm) [ "$(tail -n 1 "$file")" = end ] ;;
      *.mtx) head -n 1 "$file" | grep -q '^%%MatrixMarket' ;;
      *) false ;;
    esac || { echo "half a file, or not one of a run: $file"; return 1; }
  done
}

# table DIRECTORY: convergence.csv without the columns of times and memory.
table() {
  awk -F, 'NR == 1 { for (c = 1; c <= NF; ++c) skip[c] = $c ~ /^t_|^cpu_total$|^peak_memory_mb$/ }
    { line = ""; for (c = 1; c <= NF; ++c) if (!skip[c]) line = line "," $c; print line }' "$1/convergence.csv"
}

# same_results A B: the same files, and in them the same digits, seconds apart.
same_results() {
  [ "$(ls -A "$1")" = "$(ls -A "$2")" ] || { ls -A "$1" "$2"; return 1; }
  local file
  for file in "$1"/*; do
    case $file in
      */convergence.csv) [ "$(table "$1")" = "$(table "$2")" ] ;;
      */answer.json) cmp <(grep -v '"seconds"' "$file") <(grep -v '"seconds"' "$2/answer.json") ;;
      *) cmp "$file" "$2/${file##*/}" ;;
    esac || { echo "different: $file"; return 1; }
  done
}
