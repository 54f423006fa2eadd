# SPDX-License-Identifier: LGPL-2.1-or-later
# Applies or checks .clang-format.
#   cmake -D ROOT=<source tree> -D CLANG_FORMAT=<program> -D MODE=check|apply -P format_sources.cmake

cmake_minimum_required(VERSION 3.25)

file(GLOB_RECURSE files "${ROOT}/include/*.h" "${ROOT}/source/*.h" "${ROOT}/source/*.cc"
                        "${ROOT}/tests/*.h" "${ROOT}/tests/*.cc")
if(MODE STREQUAL "check")
  set(flags --dry-run --Werror)
else()
  set(flags -i)
endif()
execute_process(COMMAND ${CLANG_FORMAT} ${flags} ${files} RESULT_VARIABLE result
  ERROR_VARIABLE complaints)
if(NOT result EQUAL 0)
  string(SUBSTRING "${complaints}" 0 4000 complaints)
  message(FATAL_ERROR "${complaints}\nSome files are not formatted; the target 'format' mends them.")
endif()
