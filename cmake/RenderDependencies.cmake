# The dependencies of the program beyond those of the library of the dynamics (TWRENCH_RENDER).

find_package(Threads REQUIRED)

find_package(CLI11 QUIET)
twrench_require("CLI11" FOUND "${CLI11_FOUND}"
  DEBIAN libcli11-dev FEDORA cli11-devel ARCH cli11 HINT "-DCLI11_ROOT=FOLDER")

find_package(OpenSSL QUIET COMPONENTS Crypto)
twrench_require("OpenSSL" FOUND "${OPENSSL_FOUND}"
  DEBIAN libssl-dev FEDORA openssl-devel ARCH openssl HINT "-DOPENSSL_ROOT_DIR=FOLDER")

find_package(ZLIB QUIET)
twrench_require("zlib" FOUND "${ZLIB_FOUND}"
  DEBIAN zlib1g-dev FEDORA zlib-ng-compat-devel ARCH zlib HINT "-DZLIB_ROOT=FOLDER")

find_package(meshoptimizer QUIET CONFIG)
twrench_require("meshoptimizer" FOUND "${meshoptimizer_FOUND}"
  DEBIAN libmeshoptimizer-dev FEDORA meshoptimizer-devel ARCH meshoptimizer HINT "-Dmeshoptimizer_ROOT=FOLDER")

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
twrench_pkgconfig(libzip "libzip"
  DEBIAN libzip-dev FEDORA libzip-devel ARCH libzip)
twrench_pkgconfig(pugixml "pugixml"
  DEBIAN libpugixml-dev FEDORA pugixml-devel ARCH pugixml)
twrench_pkgconfig(yaml-0.1 "libyaml"
  DEBIAN libyaml-dev FEDORA libyaml-devel ARCH libyaml)
twrench_pkgconfig(libebur128 "libebur128"
  DEBIAN libebur128-dev FEDORA libebur128-devel ARCH libebur128)
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

# By default the Python of the system: scripts/maintain/setup.sh installs packages for it.
if(TWRENCH_PYTHON)
  find_program(Python_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
  find_package(Python 3.11 QUIET COMPONENTS Interpreter Development.Module)
  twrench_require("Python 3.11 or newer, with its headers" FOUND "${Python_FOUND}"
    DEBIAN "python3-dev" FEDORA python3-devel ARCH python HINT "-DPython_EXECUTABLE=FILE")
  find_package(pybind11 QUIET)
  twrench_require("pybind11" FOUND "${pybind11_FOUND}"
    DEBIAN pybind11-dev FEDORA pybind11-devel ARCH pybind11 HINT "-Dpybind11_ROOT=FOLDER")
endif()

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

if(twrench_tests AND NOT TWRENCH_FUZZ)
  find_file(TWRENCH_MANY_SCRIPTS NAMES FreeSerif.ttf FreeSerif.otf PATHS /usr/share/fonts
    PATH_SUFFIXES truetype/freefont gnu-free NO_DEFAULT_PATH)
  twrench_require("the typeface FreeSerif, for the tests" FOUND "${TWRENCH_MANY_SCRIPTS}"
    DEBIAN fonts-freefont-ttf FEDORA gnu-free-serif-fonts ARCH gnu-free-fonts
    HINT "-DTWRENCH_MANY_SCRIPTS=FILE")
  twrench_pkgconfig(harfbuzz-subset "HarfBuzz's subsets of fonts, for the tests"
    DEBIAN libharfbuzz-dev FEDORA harfbuzz-devel ARCH harfbuzz)
endif()
