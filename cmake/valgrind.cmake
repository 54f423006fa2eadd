# SPDX-License-Identifier: LGPL-2.1-or-later
# Target "valgrind": small scenes under valgrind; a finding outside of the libraries named in
# cmake/sanitizers/memory.supp is an error.

find_program(VALGRIND_EXECUTABLE valgrind)
if(VALGRIND_EXECUTABLE)
  add_custom_target(valgrind
    COMMAND bash scripts/valgrind_scenes ${VALGRIND_EXECUTABLE} $<TARGET_FILE:signorini> ${PROJECT_BINARY_DIR}/valgrind
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    DEPENDS signorini
    USES_TERMINAL)
else()
  add_custom_target(valgrind
    COMMAND ${CMAKE_COMMAND} -E echo "valgrind was not found when this folder was configured."
    COMMAND ${CMAKE_COMMAND} -E false)
endif()
