#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# The program names all libraries that deal.II loads, in an order in which names are found soon (cmake/library_order.sh). It
# loads no others for that, and every library is given the same definitions as without this order.
# usage: libraries.sh PROGRAM ROOT MPIRUN

program=$(realpath "$1")
cache=$(dirname "$program")/../CMakeCache.txt
. "$2/tests/checks.bash"

IFS=';' read -ra first <<<"$(sed -n 's/^SIGNORINI_FIRST_LIBRARIES:INTERNAL=//p' "$cache")"
if [ "${#first[@]}" -eq 0 ] || ! grep -q '^CMAKE_BUILD_TYPE:STRING=Release' "$cache"; then
  echo "SKIP this build names no libraries first"
  exit 77
fi
# It names what the program would name without the order.
plain=$(dirname "$cache")/CMakeFiles/in_given_order

printf '%s\n' "${first[@]##*/}" >first
readelf -d "$program" | sed -n 's/.*(NEEDED).*\[\(.*\)\]$/\1/p' >needed
ldd "$program" | awk '$2 == "=>" { print $1 }' | sort >loaded
ldd "$plain" | awk '$2 == "=>" { print $1 }' | sort >loaded_without
check "the program names the libraries first" cmp first <(head -n "${#first[@]}" needed)
check "  by names, not by paths" [ "$(grep -c / needed)" -eq 0 ]
check "  all that deal.II loads, and no others" cmp <(sort first) loaded_without
check "what the program alone loads, it needs" [ -z "$(comm -23 loaded loaded_without | grep -vxFf needed)" ]

# bindings FILE: the bindings of a start of the file by "LIBRARY NAME" and the library that gives the definition, also of functions
# that are looked up when they are called.
bindings() {
  mkdir bindings
  LD_DEBUG=bindings LD_DEBUG_OUTPUT=bindings/of ldd -r "$1" >ldd 2>stderr
  cat $(grep -l libdeal bindings/*) | awk '$2 == "binding" { print $4, $11, $7 }'
  rm -r bindings
}
bindings "$plain" >plain
bindings "$program" >ordered
awk 'NR == FNR { plain[$1, $2] = $3; next }
     ($1, $2) in plain { ++n; if (plain[$1, $2] != $3) print substr($2, 2, length($2) - 2), plain[$1, $2], $3 }
     END { print n >"compared" }' plain ordered | sort -u >changed
check "bindings of $(<compared) names were compared" [ "$(<compared)" -gt 100000 ]
# Every copy of an inline function or an instance of a template is the same: both definitions are weak names of C++.
awk '{ print $2; print $3 }' changed | sort -u | xargs -r nm -A -D -P --defined-only --without-symbol-versions >names
awk 'NR == FNR { if ($2 ~ /^_Z/ && $3 ~ /^[WVu]$/) weak[$2, substr($1, 1, length($1) - 1)] = 1; next }
     !(($1, $2) in weak && ($1, $3) in weak)' names changed >others
check "$(wc -l <changed) of them have another library, all inline functions and templates" is_empty others
head -n 20 others

# visits FILE: how many libraries a look-up visits in the mean.
visits() {
  awk 'NR == FNR { if ($2 == "=>") place[$3] = NR; next } $3 in place { ++n; sum += place[$3] } END { print sum / n }' \
    <(ldd "$1") "$2"
}
before=$(visits "$plain" plain)
after=$(visits "$program" ordered)
check "a look-up visits $after libraries in place of $before: less than six tenths" \
  awk "BEGIN { exit !($after < 0.6 * $before) }"
echo "$failures failures"
[ "$failures" -eq 0 ]
