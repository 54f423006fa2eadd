# SPDX-License-Identifier: LGPL-2.1-or-later
# How the executables of tests are built. What the tests of a folder have in common, the templates of deal.II above all,
# takes most of the time of compiling them. Where the build is a unity build, the tests of a folder are therefore one
# source (join_tests.cmake) and one shared library, and each executable is a main() that calls its test.

# signorini_test_sources(VARIABLE TARGET): the sources of a test.
# deal.II's run_test.cmake removes the empty interrupt_guard.cc before the first run of a test, which would link every test
# a second time. Ninja and run_test.sh leave no output of an interrupted test, so nothing needs it.
function(signorini_test_sources variable target)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources EXCLUDE REGEX "/interrupt_guard.cc$")
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()

# signorini_single_test(TARGET): an executable of its own source. It reads the same headers as the library.
function(signorini_single_test target)
  signorini_test_sources(sources ${target})
  target_precompile_headers(${target} REUSE_FROM signorini_library)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF SOURCES "${sources}")
endfunction()

# signorini_joined_tests(LIBRARY TARGET...): the tests of a folder as one library.
function(signorini_joined_tests library)
  set(joined "")
  foreach(target ${ARGN})
    signorini_test_sources(source ${target})
    list(APPEND joined ${source})
    get_filename_component(name ${source} NAME_WE)
    set(main ${CMAKE_CURRENT_BINARY_DIR}/${name}_main.cc)
    file(CONFIGURE OUTPUT ${main} CONTENT
      "int run_test_@name@(int, char **);\nint main(int argc, char **argv)\n{\n  return run_test_@name@(argc, argv);\n}\n" @ONLY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF SOURCES ${main} LINK_LIBRARIES ${library})
  endforeach()
  list(GET ARGN 0 first)
  get_target_property(definitions ${first} COMPILE_DEFINITIONS)

  set(source ${CMAKE_CURRENT_BINARY_DIR}/${library}.cc)
  list(JOIN joined "," names)
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -D OUTPUT=${source} "-D SOURCES=${names}" -P ${PROJECT_SOURCE_DIR}/cmake/join_tests.cmake
    DEPENDS ${joined} ${PROJECT_SOURCE_DIR}/cmake/join_tests.cmake
    VERBATIM)
  add_library(${library} SHARED EXCLUDE_FROM_ALL ${source})
  deal_ii_setup_target(${library})
  target_link_libraries(${library} signorini_library)
  target_include_directories(${library} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_compile_definitions(${library} PRIVATE ${definitions})
  target_precompile_headers(${library} REUSE_FROM signorini_library)
  # A test computes in the library: little optimisation takes a third off the time of compiling it.
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT SIGNORINI_INSTRUMENTATION)
    set(flags -O1)
    # From version 13 on, g++ refuses a precompiled header whose other settings follow from -O2.
    if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
      list(APPEND flags -fexpensive-optimizations)
    endif()
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "${flags}")
  endif()
  # The executables are linked with this library only, and with the runtime of a sanitizer.
  get_target_property(link_options signorini_library INTERFACE_LINK_OPTIONS)
  if(NOT link_options)
    set(link_options "")
  endif()
  set_target_properties(${library} PROPERTIES UNITY_BUILD OFF DEFINE_SYMBOL "" INTERFACE_LINK_LIBRARIES ""
    INTERFACE_LINK_OPTIONS "${link_options};LINKER:--allow-shlib-undefined")
endfunction()

# signorini_processors_of_tests(): ranks that wait for one another take time of the processor, and the more of it the less they
# run side by side. ctest therefore runs a test on several ranks alone.
function(signorini_processors_of_tests)
  get_property(tests DIRECTORY PROPERTY TESTS)
  foreach(test ${tests})
    if(test MATCHES "\\.mpirun=([0-9]+)\\.")
      set_tests_properties(${test} PROPERTIES PROCESSORS ${CMAKE_MATCH_1})
    endif()
  endforeach()
endfunction()

# signorini_build_tests(): after deal_ii_pickup_tests(), all that makes the executables of this folder.
function(signorini_build_tests)
  get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
  set(tests "")
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    if(type STREQUAL EXECUTABLE)
      list(APPEND tests ${target})
    endif()
  endforeach()
  if(NOT tests)
    return()
  endif()
  add_dependencies(build_tests ${tests})
  if(CMAKE_UNITY_BUILD)
    get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
    signorini_joined_tests(tests_${folder} ${tests})
  else()
    foreach(test ${tests})
      signorini_single_test(${test})
    endforeach()
  endif()
endfunction()
