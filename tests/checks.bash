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

# find_python MODULE: sets python to one that has a module of Debian's package python3-MODULE; without one the test is skipped.
find_python() {
  for python in python3 /usr/bin/python3; do
    if "$python" -c "import $1" 2>/dev/null; then return; fi
  done
  echo "SKIP there is no python3 with $1 (package python3-$1)"
  exit 77
}

is_empty() { [ ! -s "$1" ]; }
# What the program has to say about wrong input, in the file stderr.
one_line_of_complaint() {
  local lines
  mapfile lines <stderr
  [[ ${#lines[@]} -eq 1 && ${lines[0]} == 'signorini: '*[.\)]$'\n' ]]
}
# ends_with SCENE VERDICT CODE DIRECTORY: the line of a scene at the end of what a call with several scenes prints.
ends_with() { grep -qxF "$1: $2, exit code $3, $4" stdout; }
# verdict_is DIRECTORY VERDICT
verdict_is() {
  local text=''
  [ -e "$1/certificate.json" ] && text=$(<"$1/certificate.json")
  [[ $text == *$'\n  "verdict": "'$2$'",\n'* ]]
}
# variant FILE NAME ENTRIES...: NAME.prm, the text of a scene with these entries, "Subsection/Entry=value", in place of its own.
variant() {
  local line lines entry parameter text=''
  mapfile -t lines <"$1"
  for line in "${lines[@]}"; do
    for entry in "${@:3}"; do
      parameter=${entry%%=*}
      if [[ $line =~ ^\ *set\ +"${parameter#*/}"\ *= ]]; then continue 2; fi
    done
    text+=$line$'\n'
  done
  for entry in "${@:3}"; do
    parameter=${entry%%=*}
    text+="subsection ${parameter%/*}"$'\n'"  set ${parameter#*/} = ${entry#*=}"$'\n'"end"$'\n'
  done
  printf '%s' "$text" >"$2.prm"
}
# Whether the directory holds what it held when "inputs=$(ls -A)" was set.
only_the_inputs() { [ "$(ls -A)" = "$inputs" ]; }
