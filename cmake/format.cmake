# SPDX-License-Identifier: LGPL-2.1-or-later
# Target "format": brings all sources into the layout of .clang-format.

find_program(CLANG_FORMAT_EXECUTABLE NAMES clang-format-14 clang-format)
if(CLANG_FORMAT_EXECUTABLE)
  add_custom_target(format
    COMMAND ${CMAKE_COMMAND} -D ROOT=${PROJECT_SOURCE_DIR}
            -D CLANG_FORMAT=${CLANG_FORMAT_EXECUTABLE} -D MODE=apply
            -P ${PROJECT_SOURCE_DIR}/cmake/format_sources.cmake)
endif()
