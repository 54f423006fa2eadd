#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs the program and uses what was installed. Skipped where the library is made for its tests: in Debug, and watched.
# usage: install.sh PROGRAM ROOT

build=$(realpath "$(dirname "$1")/..")
version=$(sed -n 's/^project(signorini VERSION \([0-9.]*\) .*/\1/p' "$2/CMakeLists.txt")
setting() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }
if [ "$(setting CMAKE_BUILD_TYPE) $(setting SIGNORINI_INSTRUMENTATION)" != "Release " ]; then
  echo "SKIP this is not what is installed"
  exit 77
fi
project=$(dirname "$(realpath "$0")")/project
. "$(dirname "$0")/../../checks.bash"

cmake --install "$build" --prefix "$directory/there" >stdout 2>stderr
check "installs" [ $? -eq 0 ]
there/bin/signorini --version >stdout 2>stderr
check "the program starts" [ $? -eq 0 ]
check "  and knows its version" grep -qx "signorini $version" stdout
check "  of the citation" grep -qx "version: $version" there/share/doc/signorini/CITATION.cff
check "  of Debian's package" grep -q "^signorini ($version) " "$2/debian/changelog"
check "  of the Python module" grep -qx "version = \"$version\"" there/share/signorini/pyproject.toml
check "  and of the newest version's changes" [ "$(grep -m 1 '^## [0-9]' there/share/doc/signorini/CHANGELOG.md)" = "## $version" ]
check "the program is stripped" [ "$(readelf -S there/bin/signorini | grep -c symtab)" -eq 0 ]
there/bin/signorini there/share/signorini/prm/patch_test.prm --output results >stdout 2>stderr
check "a scene runs" [ $? -eq 0 ]
check "its manual page" [ -s there/share/man/man1/signorini.1 ]
check "completion for bash" bash -n there/share/bash-completion/completions/signorini
check "documents" [ -s there/share/doc/signorini/README.md ]
check "  with their pictures" [ -s there/share/doc/signorini/doc/pictures/block_deformed.png ]

cmake -S "$project" -B outside -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS_RELEASE=-O0 \
  -D CMAKE_PREFIX_PATH="$directory/there" >stdout 2>stderr
check "another project finds the library" [ $? -eq 0 ]
cmake --build outside >stdout 2>&1
check "  and is built" [ $? -eq 0 ] || tail -n 20 stdout
outside/outside there/share/signorini/prm/patch_test.prm >stdout 2>stderr
check "  and solves a scene" [ $? -eq 0 ]
# The pressure is 0.375 on sides of length 1 (scene D1).
check "  with the force that is known" grep -qx 'force 0.375' stdout
echo "$failures failures"
[ "$failures" -eq 0 ]
