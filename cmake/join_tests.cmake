# SPDX-License-Identifier: LGPL-2.1-or-later
# Writes one source that holds several tests: each in a namespace of its own, behind the headers of all.
#   cmake -D OUTPUT=<file> -D SOURCES=<test>,<test>... -P join_tests.cmake
# The function run_test_ROOM_NAME(argc, argv) of that source is main() of the test NAME.cc of the folder ROOM.

cmake_minimum_required(VERSION 3.25)

string(REPLACE "," ";" SOURCES "${SOURCES}")
set(headers "")
foreach(source ${SOURCES})
  file(STRINGS ${source} lines REGEX "^#include ")
  list(APPEND headers ${lines})
endforeach()
list(REMOVE_DUPLICATES headers)
list(SORT headers)
list(JOIN headers "\n" text)
string(APPEND text "

inline int call(int (*test)(), int, char **)
{
  return test();
}

inline int call(int (*test)(int, char **), int argc, char **argv)
{
  return test(argc, argv);
}
")
foreach(source ${SOURCES})
  string(REGEX MATCH "([^/]+)/([^/]+)\\.cc$" match ${source})
  set(name ${CMAKE_MATCH_1}_${CMAKE_MATCH_2})
  string(APPEND text "
namespace test_${name}
{
#include \"${source}\"
}
int run_test_${name}(int argc, char **argv)
{
  return call(test_${name}::main, argc, argv);
}
")
endforeach()
file(WRITE ${OUTPUT} "${text}")
