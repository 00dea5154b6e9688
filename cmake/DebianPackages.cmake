# Debian packages, which cpack makes from the installed components; scripts/maintain/package.sh runs all steps.
# dpkg-shlibdeps finds the dependencies on linked libraries. Libraries and programs that are loaded or started at run
# time are listed here, by the same rule for every release.

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
# Each package has its own synopsis.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "the twrench authors <twrench@noreply.example.org>")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/finish.cmake)
set(CPACK_TWRENCH_STRIP ${CMAKE_STRIP})
set(CPACK_TWRENCH_FOLDER ${PROJECT_SOURCE_DIR})

# If Mesa no longer has OSMesa, its EGL also draws without a screen. Until Mesa 24 the drivers were in a separate
# package, on which EGL does not depend.
string(JOIN ", " opengl
  libegl1 libegl-mesa0 "mesa-libgallium | libgl1-mesa-dri" "libosmesa6 | libegl-mesa0 (>= 25.1~)")

# twrench_package(COMPONENT NAME <package> SECTION ... DEPENDS ... [RECOMMENDS ...] SYNOPSIS ... DESCRIPTION ...): makes
# the package NAME of the component.
macro(twrench_package component)
  cmake_parse_arguments(ARG "" "NAME;SECTION;DEPENDS;RECOMMENDS;SYNOPSIS;DESCRIPTION" "" ${ARGN})
  string(TOUPPER ${component} upper)
  set(prefix CPACK_DEBIAN_${upper}_PACKAGE)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(${prefix}_NAME ${ARG_NAME})
  set(${prefix}_SECTION ${ARG_SECTION})
  set(${prefix}_DEPENDS ${ARG_DEPENDS})
  set(${prefix}_RECOMMENDS ${ARG_RECOMMENDS})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${ARG_SYNOPSIS}\n${ARG_DESCRIPTION}")
endmacro()

twrench_package(program NAME twrench SECTION science
  DEPENDS "${opengl}, ffmpeg" RECOMMENDS "gnuplot-nox | gnuplot"
  SYNOPSIS "films of rigid bodies that rotate freely"
  DESCRIPTION
"twrench turns a rigid body's equations of motion into a film. It computes the
body's inertia from its shape, integrates Euler's equations on the rotation
group SO(3) by Runge-Kutta-Munthe-Kaas methods or evaluates the exact solution,
draws each frame with OpenGL, without a screen, and encodes the video.

The default film shows the Dzhanibekov effect, the flips of a T-shaped wrench
in weightlessness. Scenes in TOML describe other bodies and motions. It also
compares methods, plots attitudes and writes trajectories as CSV or JSON.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)

twrench_package(development NAME libtwrench-dev SECTION libdevel
  DEPENDS "libeigen3-dev (>= 3.4)"
  SYNOPSIS "rigid-body rotation on SO(3) - development files"
  DESCRIPTION
"A C++20 library that computes the free rotation of rigid bodies: maps of the
rotation group SO(3), mass properties, Lie-group and other integrators, the
exact motion in elliptic functions with the times of its flips, and studies
that compare methods with it.

This package has the headers, the static library, and the files by which CMake
(find_package) and pkg-config find them.")

if(TWRENCH_PYTHON)
  # The module is compiled for a single minor version of Python, that of find_package(Python).
  math(EXPR next_python "${Python_VERSION_MINOR} + 1")
  twrench_package(python NAME python3-twrench SECTION python
    DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${next_python}), python3-numpy, ${opengl}"
    RECOMMENDS ffmpeg
    SYNOPSIS "rigid-body rotation and its films, from Python"
    DESCRIPTION
"The Python module twrench computes the free rotation of rigid bodies as NumPy
arrays, by the exact solution or by Lie-group and other integration methods,
and draws it as pictures and films.

It is compiled from the same code as the program twrench, which is not needed.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/packaging/python3-twrench/postinst
    ${PROJECT_SOURCE_DIR}/packaging/python3-twrench/prerm)
endif()

include(CPack)
