# Creates every target, so that warnings and sanitizers are the same for all of them.

set(TWRENCH_SANITIZE "" CACHE STRING "Sanitizers for our code, as -fsanitize= takes them")

add_library(twrench_options INTERFACE)
# Without contraction of a*b + c, results are bit-identical on processors with and without fused multiply-add, and do
# not depend on where the compiler would use that instruction.
target_compile_options(twrench_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off)
# Where the sources of a room are compiled as one, local names would also shadow the constants of other sources.
if(NOT CMAKE_UNITY_BUILD)
  target_compile_options(twrench_options INTERFACE -Wshadow)
endif()
# GCC's garbage collector takes a tenth of the compile time. It begins only at this size of the heap, in kB, which few
# sources reach.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(twrench_options INTERFACE "SHELL:--param ggc-min-heapsize=1500000")
endif()
target_include_directories(twrench_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
# The standard library checks indexes and empty optionals in debug builds, among them those of the sanitizers.
target_compile_definitions(twrench_options INTERFACE $<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)
# In some releases HarfBuzz adds this flag to the targets that link it. All targets have it, because they can share
# precompiled headers only with the same flags.
if(TWRENCH_RENDER)
  target_compile_options(twrench_options INTERFACE -pthread)
endif()
if(TWRENCH_SANITIZE)
  target_compile_options(twrench_options INTERFACE
    -fsanitize=${TWRENCH_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # AddressSanitizer also detects what these checks would find, and they take a quarter of the compile time.
  target_compile_options(twrench_options INTERFACE -fno-sanitize=null,object-size,vptr)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # These take a third of the rest. The fuzzers, compiled by Clang, have them.
    target_compile_options(twrench_options INTERFACE -fno-sanitize=alignment,pointer-overflow)
    # The sanitizers' code causes false warnings of the optimiser, so these are enabled only in other builds.
    target_compile_options(twrench_options INTERFACE -Wno-array-bounds -Wno-maybe-uninitialized
      -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
  target_link_options(twrench_options INTERFACE -fsanitize=${TWRENCH_SANITIZE})
endif()

# Large headers that most sources include are precompiled. Each source still includes what it uses
# (-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON). nlohmann-json is not among them: its literals compile a parser in every source.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers.cpp CONTENT "")
function(twrench_precompiled name)
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/headers.cpp)
  target_link_libraries(${name} PRIVATE twrench_options Eigen3::Eigen)
  target_compile_options(${name} PRIVATE ${ARGN})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_precompile_headers(${name} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm> <filesystem> <functional> <map>
    <memory> <optional> <ranges> <span> <string> <variant> <vector>)
endfunction()
# The options of rooms that are optimised little: none where all are.
set(light)
twrench_precompiled(twrench_headers)
if(TWRENCH_RENDER AND CMAKE_BUILD_TYPE STREQUAL Release)
  set(light -O1)
  twrench_precompiled(twrench_light_headers ${light})
endif()

# twrench_library(NAME [LIGHT] SOURCES ... LINKS ...): creates the static library twrench_NAME. LIGHT is for rooms that
# compute nothing for each frame, row or step: -O1 takes three quarters of the time that -O3 takes to compile them.
function(twrench_library name)
  cmake_parse_arguments(ARG "LIGHT" "" "SOURCES;LINKS" ${ARGN})
  add_library(twrench_${name} STATIC ${ARG_SOURCES})
  # The Python module is a shared library that contains all of them.
  set_target_properties(twrench_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(twrench_${name} PUBLIC ${ARG_LINKS}
    PRIVATE $<BUILD_INTERFACE:twrench_options>)
  if(ARG_LIGHT AND light)
    target_compile_options(twrench_${name} PRIVATE ${light})
    target_precompile_headers(twrench_${name} REUSE_FROM twrench_light_headers)
  else()
    target_precompile_headers(twrench_${name} REUSE_FROM twrench_headers)
  endif()
endfunction()
