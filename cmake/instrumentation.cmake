# SPDX-License-Identifier: LGPL-2.1-or-later
# SIGNORINI_INSTRUMENTATION: what is compiled into the program and its tests to watch them run.
#   memory    AddressSanitizer; every finding ends the program
#   address   the same with UndefinedBehaviorSanitizer, which doubles the time of compilation
#   thread    ThreadSanitizer
#   coverage  gcov's counters; target "coverage_report" tells which lines and branches the tests ran

set(SIGNORINI_INSTRUMENTATION "" CACHE STRING "Empty, memory, address, thread or coverage")
set_property(CACHE SIGNORINI_INSTRUMENTATION PROPERTY STRINGS "" memory address thread coverage)

set(_flags "")
if(SIGNORINI_INSTRUMENTATION STREQUAL "memory")
  set(_flags -fsanitize=address -fno-omit-frame-pointer)
elseif(SIGNORINI_INSTRUMENTATION STREQUAL "address")
  set(_flags -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
elseif(SIGNORINI_INSTRUMENTATION STREQUAL "thread")
  set(_flags -fsanitize=thread -fno-omit-frame-pointer)
elseif(SIGNORINI_INSTRUMENTATION STREQUAL "coverage")
  # Little optimisation, so that lines are told apart; threads run the same lines, so the counters are atomic.
  set(_flags --coverage -Og -fprofile-update=atomic -fprofile-abs-path)
elseif(NOT SIGNORINI_INSTRUMENTATION STREQUAL "")
  message(FATAL_ERROR "SIGNORINI_INSTRUMENTATION: found '${SIGNORINI_INSTRUMENTATION}', allowed: memory, address, thread, coverage.")
endif()
if(_flags)
  target_compile_options(signorini_library PUBLIC ${_flags})
  target_link_options(signorini_library PUBLIC ${_flags})
  # The linker that deal.II asks for complains about every symbol of clang's runtime, and takes three times as long as lld.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_link_options(signorini_library PUBLIC -fuse-ld=lld)
  endif()
endif()

if(SIGNORINI_INSTRUMENTATION STREQUAL "coverage")
  find_program(GCOVR_EXECUTABLE gcovr REQUIRED)
  add_custom_target(coverage_reset
    COMMAND find ${PROJECT_BINARY_DIR} -name "*.gcda" -delete)
  # Branches that only exceptions of the libraries take are not counted.
  add_custom_target(coverage_report
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/report
    COMMAND ${GCOVR_EXECUTABLE} --root ${PROJECT_SOURCE_DIR} --object-directory ${PROJECT_BINARY_DIR}
            --filter ${PROJECT_SOURCE_DIR}/include/ --filter ${PROJECT_SOURCE_DIR}/source/
            --exclude-throw-branches --exclude-unreachable-branches
            --txt ${PROJECT_BINARY_DIR}/report/lines.txt --html-details ${PROJECT_BINARY_DIR}/report/index.html
            --print-summary ${PROJECT_BINARY_DIR}
    COMMAND ${GCOVR_EXECUTABLE} --version
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
    USES_TERMINAL)
endif()
