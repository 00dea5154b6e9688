# Installs the library of the dynamics, for find_package(twrench) and for pkg-config, the scenes and the licences. Files
# without a component in install() belong to that of the program.

include(CMakePackageConfigHelpers)

install(TARGETS ${twrench_public} EXPORT twrench
  ARCHIVE COMPONENT development
  LIBRARY COMPONENT program NAMELINK_COMPONENT development
  FILE_SET HEADERS COMPONENT development)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/twrench)
install(EXPORT twrench NAMESPACE twrench:: FILE twrenchTargets.cmake DESTINATION ${package}
  COMPONENT development)
configure_package_config_file(cmake/twrenchConfig.cmake.in twrenchConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(twrenchConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/twrenchConfig.cmake ${PROJECT_BINARY_DIR}/twrenchConfigVersion.cmake
  DESTINATION ${package} COMPONENT development)

file(RELATIVE_PATH twrench_pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/twrench.pc.in twrench.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/twrench.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)

if(TWRENCH_RENDER)
  # The scenes are built into the program; these copies are examples for new scenes.
  install(DIRECTORY assets/scenes assets/cases DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
endif()
install(FILES LICENSE THIRD-PARTY.md TYPE DOC)

# The packages contain the static library.
if(TWRENCH_RENDER AND NOT BUILD_SHARED_LIBS)
  include(cmake/DebianPackages.cmake)
endif()
