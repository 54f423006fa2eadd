# SPDX-License-Identifier: LGPL-2.1-or-later
# How tests are built and started.

# signorini_test_executable(GROUP SOURCE...): the executable test_GROUP. "test_GROUP ROOM/NAME ARGUMENTS" calls main() of
# NAME.cc with the arguments. What tests have in common, the templates of deal.II above all, takes most of the time of
# compiling them: where the build is a unity build, they are one source (join_tests.cmake), each in a namespace of its own.
function(signorini_test_executable group)
  set(calls "")
  set(declarations "")
  foreach(source ${ARGN})
    string(REGEX MATCH "([^/]+)/([^/]+)\\.cc$" match ${source})
    set(name ${CMAKE_MATCH_1}_${CMAKE_MATCH_2})
    string(APPEND declarations "int run_test_${name}(int, char **);\n")
    string(APPEND calls "  if (name == \"${CMAKE_MATCH_1}/${CMAKE_MATCH_2}\")\n"
                        "    return run_test_${name}(argc - 1, argv + 1);\n")
    get_filename_component(folder ${source} DIRECTORY)
    list(APPEND folders ${folder})
  endforeach()
  set(main ${CMAKE_CURRENT_BINARY_DIR}/joined/${group}_main.cc)
  file(CONFIGURE OUTPUT ${main} @ONLY CONTENT [[
#include <iostream>
#include <string>

@declarations@
int main(int argc, char **argv) {
  const std::string name = argc > 1 ? argv[1] : "";
@calls@  std::cerr << "test_@group@: there is no test '" << name << "'." << std::endl;
  return 1;
}
]])

  set(parts ${ARGN})
  if(CMAKE_UNITY_BUILD)
    list(JOIN ARGN "," parts)
  endif()
  set(joined "")
  foreach(part ${parts})
    string(REPLACE "," ";" sources ${part})
    list(GET sources 0 first)
    string(REGEX REPLACE "^.*/([^/]+)/([^/]+)$" "\\1_\\2" name ${first})
    set(source ${CMAKE_CURRENT_BINARY_DIR}/joined/${group}_${name})
    add_custom_command(OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -D OUTPUT=${source} "-D SOURCES=${part}" -P ${PROJECT_SOURCE_DIR}/cmake/join_tests.cmake
      DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/cmake/join_tests.cmake
      VERBATIM)
    list(APPEND joined ${source})
  endforeach()
  # A test computes in the library: little optimisation takes a third off the time of compiling it.
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT SIGNORINI_INSTRUMENTATION)
    set(flags -O1)
    # From version 13 on, g++ refuses a precompiled header whose other settings follow from -O2.
    if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
      list(APPEND flags -fexpensive-optimizations)
    endif()
    set_source_files_properties(${joined} PROPERTIES COMPILE_OPTIONS "${flags}")
  endif()
  set_source_files_properties(${main} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)

  set(target test_${group})
  add_executable(${target} EXCLUDE_FROM_ALL ${main} ${joined})
  deal_ii_setup_target(${target})
  target_link_libraries(${target} signorini_verification)
  list(REMOVE_DUPLICATES folders)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${folders})
  target_compile_definitions(${target} PRIVATE SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_precompile_headers(${target} REUSE_FROM signorini_library)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
endfunction()

# signorini_add_test(NAME LABELS RANKS COMMAND...): a test that starts in an empty folder of its own. Ranks that wait for one
# another take time of the processor, and the more of it the less they run side by side: ctest runs a test on several ranks
# alone. Ranks zero: without mpirun.
function(signorini_add_test name labels ranks)
  set(command ${ARGN})
  if(ranks GREATER 0)
    string(APPEND name ".mpirun=${ranks}")
    set(command ${DEAL_II_MPIEXEC} ${DEAL_II_MPIEXEC_NUMPROC_FLAG} ${ranks} ${DEAL_II_MPIEXEC_PREFLAGS} ${command}
                ${DEAL_II_MPIEXEC_POSTFLAGS})
  endif()
  add_test(NAME ${name}
    COMMAND sh ${PROJECT_SOURCE_DIR}/tests/start.sh ${CMAKE_CURRENT_BINARY_DIR}/${name} ${command})
  set_tests_properties(${name} PROPERTIES LABELS "${labels}")
  if(ranks GREATER 0)
    set_tests_properties(${name} PROPERTIES PROCESSORS ${ranks})
  endif()
endfunction()
