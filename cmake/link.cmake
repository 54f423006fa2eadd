# SPDX-License-Identifier: LGPL-2.1-or-later
# What the program and its tests are linked with.
#
# SIGNORINI_SHORT_LINK: deal.II asks that programs are linked with every library that it was built with, 170 in Debian,
# and offer all their symbols to these. Reading and offering them takes two thirds of the time that it takes to link a
# test. With this option only those are read that headers of deal.II name in the objects of this program. The others are
# loaded with deal.II, as without it.
#
# SIGNORINI_FIRST_LIBRARIES: deal.II loads 200 libraries, and most of them look up their own symbols when the program
# starts, in all libraries one after the other. Libraries that are named first are found first: the program names all of
# them, in the order of library_order.sh (doc/design.md, "The start of the process"). Finding it takes some seconds, and
# nothing as long as deal.II loads the same libraries.

option(SIGNORINI_SHORT_LINK "Link only the libraries that this program names; the presets do" OFF)

if(EXISTS "${DEAL_II_TARGET_CONFIG}")
  include(${DEAL_II_TARGET_CONFIG})
  set(DEAL_II_TARGET_CONFIG_INCLUDED TRUE)
  foreach(_target ${DEAL_II_TARGET_DEBUG} ${DEAL_II_TARGET_RELEASE})
    get_target_property(_libraries ${_target} INTERFACE_LINK_LIBRARIES)
    set(_named ${_libraries})
    list(FILTER _named EXCLUDE REGEX "^/.*\\.so[.0-9]*$")
    set(_files ${_libraries})
    list(FILTER _files INCLUDE REGEX
      "^/.*/lib(tbb|lapack|blas|trilinos_amesos|trilinos_epetra|trilinos_teuchos[a-z]*|boost_[a-z]*|petsc|mpi|z)[^/a-z]*\\.so[.0-9]*$")
    if(SIGNORINI_SHORT_LINK)
      set_target_properties(${_target} PROPERTIES INTERFACE_LINK_LIBRARIES "${_files};${_named}")
    endif()
  endforeach()
  get_target_property(_library ${DEAL_II_TARGET_RELEASE} LOCATION)
  execute_process(COMMAND ldd ${_library} OUTPUT_VARIABLE _loaded)
  string(REGEX MATCHALL "/[^ \n]+" _loaded "${_library} ${_loaded}")
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT _loaded STREQUAL SIGNORINI_LOADED_LIBRARIES)
    message(STATUS "Putting the libraries of deal.II in order")
    # A program that names the libraries whose functions this one calls itself. BLAS is not one of them.
    set(_files ${_loaded})
    list(FILTER _files INCLUDE REGEX
      "/lib(deal|tbb|lapack|trilinos_amesos|trilinos_epetra|trilinos_teuchos|boost_|petsc|mpi|z|cholmod|gmp)[^/]*\\.so[.0-9]*$")
    set(_program ${PROJECT_BINARY_DIR}/CMakeFiles/in_given_order)
    file(WRITE ${_program}.cc "int main() {}")
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${_program}.cc -o ${_program} -Wl,--no-as-needed ${_files})
    execute_process(COMMAND sh ${PROJECT_SOURCE_DIR}/cmake/library_order.sh ${_program} OUTPUT_VARIABLE _order)
    string(REGEX MATCHALL "[^\n]+" _order "${_order}")
    set(SIGNORINI_LOADED_LIBRARIES "${_loaded}" CACHE INTERNAL "The files that deal.II loads")
    set(SIGNORINI_FIRST_LIBRARIES "${_order}" CACHE INTERNAL "The same in the order in which the program names them")
  endif()
endif()
if(SIGNORINI_SHORT_LINK)
  string(REPLACE "-rdynamic" "" DEAL_II_LINKER_FLAGS "${DEAL_II_LINKER_FLAGS}")
endif()
