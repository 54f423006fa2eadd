# SPDX-License-Identifier: LGPL-2.1-or-later
# Target "site": the pages of doc/site, the documents and the gallery, which is run, in the folder site/html of the build.
# Target "check_site" opens them in a browser.

# The packages belong to Debian's Python, which need not be the first one on the path.
find_program(SIGNORINI_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(SIGNORINI_PYTHON python3)
execute_process(
  COMMAND ${SIGNORINI_PYTHON} -c "import importlib.util as u; print(end=';'.join(package for module, package in (
    ('sphinx', 'python3-sphinx'), ('myst_parser', 'python3-myst-parser'), ('furo', 'furo'), ('matplotlib', 'python3-matplotlib'))
    if u.find_spec(module) is None))"
  OUTPUT_VARIABLE _missing ERROR_QUIET)
if(NOT EXISTS /usr/share/javascript/mathjax/MathJax.js)
  list(APPEND _missing libjs-mathjax)
endif()
find_program(GMSH_EXECUTABLE gmsh)
if(NOT GMSH_EXECUTABLE)
  list(APPEND _missing gmsh)
endif()

if(_missing)
  list(JOIN _missing " " _missing)
  add_custom_target(site
    COMMAND ${CMAKE_COMMAND} -E echo "The site needs packages that are missing: apt-get install ${_missing}, then configure again."
    COMMAND ${CMAKE_COMMAND} -E false)
else()
  set(_reference "")
  if(DOXYGEN_EXECUTABLE)
    set(_reference --reference ${PROJECT_BINARY_DIR}/doc)
  endif()
  add_custom_target(site
    COMMAND ${SIGNORINI_PYTHON} ${PROJECT_SOURCE_DIR}/doc/site/build.py $<TARGET_FILE:signorini> ${PROJECT_BINARY_DIR}/site
            --tutorial $<TARGET_FILE:luo_liang> ${_reference}
    DEPENDS luo_liang
    USES_TERMINAL)
  add_dependencies(site signorini)
  if(TARGET doc)
    add_dependencies(site doc)
  endif()
endif()
add_custom_target(check_site
  COMMAND ${SIGNORINI_PYTHON} ${PROJECT_SOURCE_DIR}/scripts/check_site ${PROJECT_BINARY_DIR}/site/html
  USES_TERMINAL)
