# Installs the library of the dynamics, for find_package(twrench) and for pkg-config, and the licences.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set_target_properties(twrench_dynamics PROPERTIES
  EXPORT_NAME dynamics OUTPUT_NAME twrench-dynamics
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
install(TARGETS twrench_dynamics EXPORT twrench FILE_SET HEADERS)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/twrench)
install(EXPORT twrench NAMESPACE twrench:: FILE twrenchTargets.cmake DESTINATION ${package})
configure_package_config_file(cmake/twrenchConfig.cmake.in twrenchConfig.cmake
  INSTALL_DESTINATION ${package})
# Until 1.0 a minor version may change the interface.
write_basic_package_version_file(twrenchConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/twrenchConfig.cmake ${PROJECT_BINARY_DIR}/twrenchConfigVersion.cmake
  DESTINATION ${package})

# A static library leaves fmt to be linked by whoever links it.
set(twrench_pc_requires "eigen3 >= 3.4")
if(NOT BUILD_SHARED_LIBS)
  string(APPEND twrench_pc_requires ", fmt")
endif()
file(RELATIVE_PATH twrench_pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/twrench.pc.in twrench.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/twrench.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/THIRD-PARTY.md TYPE DOC)
