# SPDX-License-Identifier: LGPL-2.1-or-later
# Data flows one way through eight floors, the library, to the ninth, which verifies it: a file includes only its own floor
# and floors before it, directly and through other headers. Inside a floor, rooms include one another in one direction.
#   cmake -D ROOT=<source tree> -P check_module_order.cmake

cmake_minimum_required(VERSION 3.25)

set(floors base problem discretization solvers postprocessing error_control results driver verification)
# Solvers of linear systems and of quadratic programs are algebra: they know the names of choices, but no scene and no
# finite element, not even through other headers.
set(algebra solvers/stiffness/stiffness_inverse solvers/stiffness/condensed_inverse solvers/contact/dual_problem
            solvers/contact/projected_methods solvers/contact/dual_solver solvers/contact/active_set
            solvers/contact/set_system solvers/contact/solution_path)
set(violations "")

# room_of(NAME VARIABLE): "floor/room" of a header or source.
function(room_of name variable)
  string(REGEX REPLACE "/[^/]*$" "" room "${name}")
  set(${variable} "${room}" PARENT_SCOPE)
endfunction()

set(arrows "")
foreach(floor ${floors})
  list(FIND floors ${floor} own)
  file(GLOB_RECURSE files RELATIVE ${ROOT} "${ROOT}/include/signorini/${floor}/*.h" "${ROOT}/source/${floor}/*.h"
       "${ROOT}/source/${floor}/*.cc")
  if(NOT files)
    list(APPEND violations "the floor ${floor} has no files")
  endif()
  foreach(file ${files})
    string(REGEX REPLACE "^(include/signorini|source)/" "" name "${file}")
    string(REGEX REPLACE "\\.[a-z]+$" "" name "${name}")
    room_of(${name} room)
    file(STRINGS "${ROOT}/${file}" includes REGEX "#include <signorini/")
    foreach(line ${includes})
      string(REGEX REPLACE ".*<signorini/(.*)\\.h>.*" "\\1" included "${line}")
      string(REGEX REPLACE "/.*" "" included_floor "${included}")
      list(FIND floors ${included_floor} place)
      if(place EQUAL -1 OR place GREATER own)
        list(APPEND violations "${file} must not include ${included}, which stands on a later floor")
      endif()
      room_of(${included} included_room)
      if(floor STREQUAL driver AND NOT included_room STREQUAL room)
        list(APPEND folders_of_${room} ${included_room})
      endif()
      if(NOT included_room STREQUAL room AND included_floor STREQUAL floor)
        list(APPEND arrows "${room}>${included_room}")
      endif()
      if(name IN_LIST algebra AND NOT included_floor STREQUAL base AND NOT included IN_LIST algebra AND
         NOT included MATCHES "^(problem/parameters/options|discretization/space/admissible_set)$")
        list(APPEND violations "${file} is algebra and must not include ${included}")
      endif()
    endforeach()
  endforeach()
endforeach()

# The driver puts the floors together, and needs no details of them.
foreach(room driver/check driver/level driver/sequence driver/study driver/runs)
  list(REMOVE_DUPLICATES folders_of_${room})
  list(LENGTH folders_of_${room} n_folders)
  if(n_folders GREATER 12)
    list(APPEND violations "${room} includes the headers of ${n_folders} other folders, at most 12 are allowed: ${folders_of_${room}}")
  endif()
endforeach()

# Rooms that nothing points to are taken away until none is left; what stays is a circle.
list(REMOVE_DUPLICATES arrows)
set(changed TRUE)
while(arrows AND changed)
  set(changed FALSE)
  set(targets "")
  foreach(arrow ${arrows})
    string(REGEX REPLACE ".*>" "" target "${arrow}")
    list(APPEND targets ${target})
  endforeach()
  foreach(arrow ${arrows})
    string(REGEX REPLACE ">.*" "" source "${arrow}")
    if(NOT source IN_LIST targets)
      list(REMOVE_ITEM arrows "${arrow}")
      set(changed TRUE)
    endif()
  endforeach()
endwhile()
if(arrows)
  list(APPEND violations "these rooms include one another in a circle: ${arrows}")
endif()

if(violations)
  list(JOIN violations "\n  " text)
  message(FATAL_ERROR "The order of floors is violated:\n  ${text}")
endif()
message(STATUS "The order of floors holds.")
