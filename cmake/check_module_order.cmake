# SPDX-License-Identifier: LGPL-2.1-or-later
# Data flows one way: a module includes only itself and modules above it.
#   cmake -D ROOT=<source tree> -P check_module_order.cmake

cmake_minimum_required(VERSION 3.25)

# Every module with what it may include. qp is algebra only and includes nothing of the others.
set(order base parameters scene mesh_file catalogue scene_input mesh elasticity stiffness_inverse multigrid multiplier norms
          qp compliance boundary_model contact_iteration recovery motions postprocess refinement bound answer load_cases errors record verdict output pictures study runs)
set(allowed_qp base qp)
set(allowed_stiffness_inverse base stiffness_inverse)
set(allowed_scene base scene)
set(allowed_mesh_file base scene mesh_file)
set(above "")
foreach(module ${order})
  list(APPEND above ${module})
  if(NOT DEFINED allowed_${module})
    set(allowed_${module} ${above})
  endif()
endforeach()
# Only the study, load cases and the bound, which solves a dual problem of its own, know both the finite elements and
# the quadratic program.
foreach(module recovery motions postprocess refinement answer errors record verdict output pictures)
  list(REMOVE_ITEM allowed_${module} qp)
endforeach()

set(violations "")
foreach(module ${order})
  file(GLOB files "${ROOT}/include/signorini/${module}/*.h" "${ROOT}/source/${module}/*")
  if(NOT files)
    list(APPEND violations "module ${module} has no files")
  endif()
  foreach(file ${files})
    file(STRINGS ${file} includes REGEX "#include <signorini/")
    foreach(line ${includes})
      string(REGEX REPLACE ".*<signorini/([a-z_]+)/.*" "\\1" included "${line}")
      if(NOT included IN_LIST allowed_${module})
        file(RELATIVE_PATH name ${ROOT} ${file})
        list(APPEND violations "${name} must not include module ${included}")
      endif()
    endforeach()
  endforeach()
endforeach()

if(violations)
  list(JOIN violations "\n  " text)
  message(FATAL_ERROR "The order of modules is violated:\n  ${text}")
endif()
message(STATUS "The order of modules holds.")
