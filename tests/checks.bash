# SPDX-License-Identifier: LGPL-2.1-or-later
# Sourced by the tests in bash: an empty directory to work in, and a check with a count of failures.

directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
cd "$directory" || exit 1
failures=0

# check NAME COMMAND...: PASS if the command succeeds, else FAIL with what stands in the file stderr.
check() {
  local name=$1
  shift
  if "$@"; then
    echo "PASS $name"
  else
    echo "FAIL $name"
    if [ -e stderr ]; then sed 's/^/  stderr: /' stderr; fi
    failures=$((failures + 1))
  fi
}

is_empty() { [ ! -s "$1" ]; }
# What the program has to say about wrong input, in the file stderr.
one_line_of_complaint() {
  [ "$(wc -l <stderr)" -eq 1 ] && grep -q '^signorini: .*[.)]$' stderr
}
# Whether the directory holds what it held when "inputs=$(ls -A)" was set.
only_the_inputs() { [ "$(ls -A)" = "$inputs" ]; }
