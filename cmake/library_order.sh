#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Prints the files of all libraries that a program loads, in an order in which the loader finds names soon: one that provides
# more of the look-ups of a start stands before others. An order decides which library provides a name that several define.
# Libraries that define the same name therefore keep the order in which this program loads them. Inline functions and
# instances of templates do not count: they are weak names of C++, of which every copy is the same.
# Prints nothing where the loader finds a library only by a path that another one names.
# usage: library_order.sh PROGRAM
set -eu
libraries=$(ldd "$1" | awk '$2 == "=>" { print $3 }')
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
LD_DEBUG=bindings LD_DEBUG_OUTPUT=$folder/bindings ldd -d "$1" >"$folder/loaded"
{
  PATH=$PATH:/sbin:/usr/sbin ldconfig -p | awk '{ print "known", $NF }'
  for library in $libraries; do echo "library $library"; done
  awk '$2 == "binding" { ++n[$7] } END { for (library in n) print "provides", library, n[library] }' "$folder"/bindings.*
  # FILE: NAME TYPE ...
  nm -A -D -P --defined-only --without-symbol-versions $libraries
} | awk '
  $1 == "known" { known[$2] = 1; next }
  $1 == "library" { if ($2 in known) file[++number] = $2; else unknown = 1; next }
  $1 == "provides" { provides[$2] = $3; next }
  last[$2] != $1 { definers[$2] = definers[$2] (last[$2] = $1) }
  $3 !~ /[WVu]/ || $2 !~ /^_Z/ { decides[$2] = $3 }
  # A library and those before it which are not named yet: their look-ups and their number.
  function weigh(library, n, list, i) {
    if (library in named || weighed[library] == round) return
    weighed[library] = round
    look_ups += provides[library]
    ++size
    n = split(before[library], list, ":")
    for (i = 1; i < n; ++i) weigh(list[i])
  }
  function name_library(library, n, list, i) {
    if (library in named) return
    named[library] = 1
    n = split(before[library], list, ":")
    for (i = 1; i < n; ++i) name_library(list[i])
    print library
  }
  END {
    if (unknown) exit
    split("_init _fini _edata _end __bss_start", list, " ")
    for (i in list) delete decides[list[i]]
    for (name in decides) {
      n = decides[name] == "A" ? 0 : split(definers[name], list, ":")
      for (i = 2; i < n; ++i) pair[list[i - 1], list[i]] = 1
    }
    for (k = 1; k <= number; ++k)
      for (i = 1; i < k; ++i) if ((file[i], file[k]) in pair) before[file[k]] = before[file[k]] file[i] ":"
    do {
      most = -1
      for (i = 1; i <= number; ++i) if (!(file[i] in named)) {
        ++round
        look_ups = size = 0
        weigh(file[i])
        if (look_ups / size > most) { most = look_ups / size; best = file[i] }
      }
      if (most >= 0) name_library(best)
    } while (most >= 0)
  }'
