# Every library and file that the build takes from the system. What is missing is collected and
# reported in one message that lists the packages of Debian, Fedora and Arch, and the CMake variable
# for a copy elsewhere (docs/platforms.md).

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

find_package(Threads REQUIRED)

find_package(Eigen3 QUIET NO_MODULE)
if(Eigen3_FOUND AND Eigen3_VERSION VERSION_LESS 3.4)
  set(Eigen3_FOUND FALSE)
endif()
twrench_require("Eigen 3.4 or newer" FOUND "${Eigen3_FOUND}"
  DEBIAN libeigen3-dev FEDORA eigen3-devel ARCH eigen HINT "-DEigen3_ROOT=FOLDER")

find_package(fmt QUIET)
twrench_require("fmt" FOUND "${fmt_FOUND}"
  DEBIAN libfmt-dev FEDORA fmt-devel ARCH fmt HINT "-Dfmt_ROOT=FOLDER")

find_package(nlohmann_json QUIET)
twrench_require("nlohmann-json" FOUND "${nlohmann_json_FOUND}"
  DEBIAN nlohmann-json3-dev FEDORA json-devel ARCH nlohmann-json HINT "-Dnlohmann_json_ROOT=FOLDER")

find_package(CLI11 QUIET)
twrench_require("CLI11" FOUND "${CLI11_FOUND}"
  DEBIAN libcli11-dev FEDORA cli11-devel ARCH cli11 HINT "-DCLI11_ROOT=FOLDER")

find_package(Boost QUIET CONFIG)
twrench_require("Boost's headers" FOUND "${Boost_FOUND}"
  DEBIAN libboost-dev FEDORA boost-devel ARCH boost HINT "-DBoost_ROOT=FOLDER")

find_package(OpenSSL QUIET COMPONENTS Crypto)
twrench_require("OpenSSL" FOUND "${OPENSSL_FOUND}"
  DEBIAN libssl-dev FEDORA openssl-devel ARCH openssl HINT "-DOPENSSL_ROOT_DIR=FOLDER")

find_package(ZLIB QUIET)
twrench_require("zlib" FOUND "${ZLIB_FOUND}"
  DEBIAN zlib1g-dev FEDORA zlib-ng-compat-devel ARCH zlib HINT "-DZLIB_ROOT=FOLDER")

# twrench_pkgconfig(MODULE ...): defines the target PkgConfig::MODULE; other arguments as in
# twrench_require.
find_package(PkgConfig QUIET)
twrench_require("pkgconf" FOUND "${PkgConfig_FOUND}"
  DEBIAN pkgconf FEDORA pkgconf ARCH pkgconf HINT "-DPKG_CONFIG_EXECUTABLE=FILE")
macro(twrench_pkgconfig module what)
  set(${module}_FOUND FALSE)
  if(PkgConfig_FOUND)
    pkg_check_modules(${module} QUIET IMPORTED_TARGET ${module})
  endif()
  twrench_require("${what}" FOUND "${${module}_FOUND}" ${ARGN} HINT "-DCMAKE_PREFIX_PATH=FOLDER")
endmacro()
twrench_pkgconfig(tomlplusplus "toml++"
  DEBIAN libtomlplusplus-dev FEDORA tomlplusplus-devel ARCH tomlplusplus)
twrench_pkgconfig(libisal "ISA-L"
  DEBIAN libisal-dev FEDORA isa-l-devel ARCH isa-l)
twrench_pkgconfig(spng "libspng"
  DEBIAN libspng-dev FEDORA libspng-devel ARCH libspng)
twrench_pkgconfig(cairo-ft "Cairo with its FreeType fonts"
  DEBIAN libcairo2-dev FEDORA cairo-devel ARCH cairo)
twrench_pkgconfig(freetype2 "FreeType"
  DEBIAN libfreetype-dev FEDORA freetype-devel ARCH freetype2)
twrench_pkgconfig(harfbuzz "HarfBuzz"
  DEBIAN libharfbuzz-dev FEDORA harfbuzz-devel ARCH harfbuzz)
twrench_pkgconfig(fribidi "FriBidi"
  DEBIAN libfribidi-dev FEDORA fribidi-devel ARCH fribidi)

# twrench_header(VARIABLE HEADER WHAT ...): sets the include folder of HEADER; other arguments as in
# twrench_require.
macro(twrench_header variable header what)
  find_path(${variable} ${header})
  twrench_require("${what}" FOUND "${${variable}}" ${ARGN} HINT "-D${variable}=FOLDER")
endmacro()
twrench_header(GLM_INCLUDE_DIR glm/glm.hpp "GLM"
  DEBIAN libglm-dev FEDORA glm-devel ARCH glm)
twrench_header(STB_INCLUDE_DIR stb/stb_image_write.h "stb"
  DEBIAN libstb-dev FEDORA stb-devel ARCH stb)
twrench_header(GL_INCLUDE_DIR GL/glcorearb.h "OpenGL's headers"
  DEBIAN libgl-dev FEDORA libglvnd-devel ARCH libglvnd)
twrench_header(EGL_INCLUDE_DIR EGL/eglext.h "EGL's headers"
  DEBIAN libegl-dev FEDORA libglvnd-devel ARCH libglvnd)

# The fonts that are built into the program. FOLDERS are those of Debian, Fedora and Arch.
set(TWRENCH_FONT_FOLDERS
  truetype/roboto/unhinted/RobotoTTF truetype/firacode google-roboto fira-code TTF)
function(twrench_font variable file)
  find_file(${variable} ${file} PATHS /usr/share/fonts PATH_SUFFIXES ${TWRENCH_FONT_FOLDERS}
    NO_DEFAULT_PATH)
  twrench_require("the typeface ${file}" FOUND "${${variable}}" ${ARGN} HINT "-D${variable}=FILE")
endfunction()
foreach(weight Regular Medium)
  twrench_font(TWRENCH_SANS_${weight} Roboto-${weight}.ttf
    DEBIAN fonts-roboto-unhinted FEDORA google-roboto-fonts ARCH ttf-roboto)
  twrench_font(TWRENCH_MONO_${weight} FiraCode-${weight}.ttf
    DEBIAN fonts-firacode FEDORA fira-code-fonts ARCH ttf-fira-code)
endforeach()

if(BUILD_TESTING AND NOT TWRENCH_FUZZ)
  find_package(GTest QUIET)
  twrench_require("GoogleTest, for the tests" FOUND "${GTest_FOUND}"
    DEBIAN "libgtest-dev libgmock-dev" FEDORA gmock-devel ARCH gtest HINT "-DGTest_ROOT=FOLDER")
  find_file(TWRENCH_MANY_SCRIPTS NAMES FreeSerif.ttf FreeSerif.otf PATHS /usr/share/fonts
    PATH_SUFFIXES truetype/freefont gnu-free NO_DEFAULT_PATH)
  twrench_require("the typeface FreeSerif, for the tests" FOUND "${TWRENCH_MANY_SCRIPTS}"
    DEBIAN fonts-freefont-ttf FEDORA gnu-free-serif-fonts ARCH gnu-free-fonts
    HINT "-DTWRENCH_MANY_SCRIPTS=FILE")
  twrench_pkgconfig(harfbuzz-subset "HarfBuzz's subsets of fonts, for the tests"
    DEBIAN libharfbuzz-dev FEDORA harfbuzz-devel ARCH harfbuzz)
endif()

get_property(missing GLOBAL PROPERTY twrench_missing)
if(missing)
  message(FATAL_ERROR "Missing dependencies; install them, or set their locations:\n${missing}")
endif()
