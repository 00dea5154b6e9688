# Every target of ours is made here, so that warnings and sanitizers are the same for all.

set(TWRENCH_SANITIZE "" CACHE STRING "Sanitizers for our code, as -fsanitize= takes them")

add_library(twrench_options INTERFACE)
# Without contraction of a*b + c a number has the same bits on processors that have such an
# instruction, and wherever the compiler would use it.
target_compile_options(twrench_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off)
target_include_directories(twrench_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
if(TWRENCH_SANITIZE)
  target_compile_options(twrench_options INTERFACE
    -fsanitize=${TWRENCH_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(twrench_options INTERFACE -fsanitize=${TWRENCH_SANITIZE})
endif()

# twrench_library(NAME SOURCES ... LINKS ...): the static library twrench_NAME.
function(twrench_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_library(twrench_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(twrench_${name} PUBLIC ${ARG_LINKS} PRIVATE twrench_options)
  target_include_directories(twrench_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
endfunction()
