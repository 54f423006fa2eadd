# SPDX-License-Identifier: LGPL-2.1-or-later
# cmake --install: the program, and the library with its headers and the targets signorini::signorini, signorini::verification for
# find_package(signorini), scenes and documents.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/signorini)

install(TARGETS signorini RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(PROGRAMS ${PROJECT_SOURCE_DIR}/scripts/signorini-plot DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${PROJECT_SOURCE_DIR}/pyproject.toml DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/python DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini PATTERN __pycache__ EXCLUDE)
# Names of functions are for debuggers: two fifths of the program.
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_STRIP AND NOT SIGNORINI_INSTRUMENTATION AND NOT SIGNORINI_DEBUG_INFO)
  install(CODE "execute_process(COMMAND \"${CMAKE_STRIP}\"
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}/signorini\" COMMAND_ERROR_IS_FATAL ANY)")
endif()

install(TARGETS signorini_library signorini_verification EXPORT signorini-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT signorini-targets NAMESPACE signorini:: DESTINATION ${_package})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/signorini DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/signorini-config.cmake.in
  ${PROJECT_BINARY_DIR}/signorini-config.cmake INSTALL_DESTINATION ${_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/signorini-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/signorini-config.cmake ${PROJECT_BINARY_DIR}/signorini-config-version.cmake
  DESTINATION ${_package})

install(DIRECTORY ${PROJECT_SOURCE_DIR}/prm DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/doc DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN "*.1" EXCLUDE PATTERN "site" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/doc/signorini.1 ${PROJECT_SOURCE_DIR}/doc/signorini-plot.1
  DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_SOURCE_DIR}/scripts/completion.bash RENAME signorini
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES README.md CONTRIBUTING.md CHANGELOG.md CITATION.cff LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
