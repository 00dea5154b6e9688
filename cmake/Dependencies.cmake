# Every library and file that the build takes from the system. Missing ones are collected and reported in one message
# that lists the packages of Debian, Fedora and Arch, and the CMake variable for a copy elsewhere (docs/platforms.md).

# The oldest compilers that support the C++20 features in use.
foreach(oldest "GNU 12" "Clang 14")
  separate_arguments(oldest)
  list(GET oldest 0 compiler)
  list(GET oldest 1 version)
  if(CMAKE_CXX_COMPILER_ID STREQUAL compiler AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS version)
    message(FATAL_ERROR "twrench needs GCC 12 or Clang 14, or newer; ${CMAKE_CXX_COMPILER} is "
      "${compiler} ${CMAKE_CXX_COMPILER_VERSION}: choose another with -DCMAKE_CXX_COMPILER=...")
  endif()
endforeach()

# twrench_require(WHAT FOUND <bool> DEBIAN ... FEDORA ... ARCH ... HINT ...): records WHAT as
# missing unless it was found. HINT is the variable that sets its location.
function(twrench_require what)
  cmake_parse_arguments(ARG "" "FOUND;DEBIAN;FEDORA;ARCH;HINT" "" ${ARGN})
  if(ARG_FOUND)
    return()
  endif()
  string(CONCAT lines
    "\n  ${what}\n"
    "    Debian, Ubuntu  ${ARG_DEBIAN}\n"
    "    Fedora          ${ARG_FEDORA}\n"
    "    Arch            ${ARG_ARCH}\n"
    "    a copy of it    ${ARG_HINT}\n")
  set_property(GLOBAL APPEND_STRING PROPERTY twrench_missing "${lines}")
endfunction()

find_package(Eigen3 QUIET NO_MODULE)
if(Eigen3_FOUND AND Eigen3_VERSION VERSION_LESS 3.4)
  set(Eigen3_FOUND FALSE)
endif()
twrench_require("Eigen 3.4 or newer" FOUND "${Eigen3_FOUND}"
  DEBIAN libeigen3-dev FEDORA eigen3-devel ARCH eigen HINT "-DEigen3_ROOT=FOLDER")

find_package(fmt QUIET)
twrench_require("fmt" FOUND "${fmt_FOUND}"
  DEBIAN libfmt-dev FEDORA fmt-devel ARCH fmt HINT "-Dfmt_ROOT=FOLDER")

find_package(Boost QUIET CONFIG)
twrench_require("Boost's headers" FOUND "${Boost_FOUND}"
  DEBIAN libboost-dev FEDORA boost-devel ARCH boost HINT "-DBoost_ROOT=FOLDER")

if(TWRENCH_RENDER OR twrench_tests)
  find_package(nlohmann_json QUIET)
  twrench_require("nlohmann-json" FOUND "${nlohmann_json_FOUND}"
    DEBIAN nlohmann-json3-dev FEDORA json-devel ARCH nlohmann-json HINT "-Dnlohmann_json_ROOT=FOLDER")
endif()

if(twrench_tests AND NOT TWRENCH_FUZZ)
  find_package(GTest QUIET)
  twrench_require("GoogleTest, for the tests" FOUND "${GTest_FOUND}"
    DEBIAN "libgtest-dev libgmock-dev" FEDORA gmock-devel ARCH gtest HINT "-DGTest_ROOT=FOLDER")
endif()

if(TWRENCH_RENDER)
  include(cmake/RenderDependencies.cmake)
endif()

get_property(missing GLOBAL PROPERTY twrench_missing)
if(missing)
  message(FATAL_ERROR "Missing dependencies; install them, or set their locations:\n${missing}")
endif()
