# twrench_embed(TARGET NAME FILES ...): embeds files in TARGET, accessible at run time through the generated header
# "embedded/NAME.h": twrench::embedded::NAME("file.ext") -> string_view. The assembler includes the bytes (.incbin), so
# that large assets cost no compile time. With ORDERED before the files, twrench::embedded::NAME_in_order() also lists
# their names in the order in which they are given here. The section type is %progbits, because on 32-bit Arm an @ begins a comment.

function(twrench_embed target name)
  set(dir ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  set(symbols "")
  set(lookups "")
  set(names "")
  cmake_parse_arguments(PARSE_ARGV 2 embed ORDERED "" "")
  set(assembly "")
  set(index 0)
  foreach(file IN LISTS embed_UNPARSED_ARGUMENTS)
    get_filename_component(path ${file} ABSOLUTE)
    get_filename_component(base ${file} NAME)
    set(symbol twrench_${name}_${index})
    string(APPEND assembly
      "asm(\".pushsection .rodata,\\\"a\\\",%progbits\\n\""
      "    \".global ${symbol}_begin\\n.balign 16\\n${symbol}_begin:\\n.incbin \\\"${path}\\\"\\n\""
      "    \".global ${symbol}_end\\n${symbol}_end:\\n.byte 0\\n.popsection\\n\");\n")
    string(APPEND symbols "extern const char ${symbol}_begin[], ${symbol}_end[];\n")
    string(APPEND lookups
      "    {\"${base}\", {${symbol}_begin, static_cast<std::size_t>(${symbol}_end - ${symbol}_begin)}},\n")
    string(APPEND names "\"${base}\", ")
    math(EXPR index "${index} + 1")
    list(APPEND paths ${path})
  endforeach()
  set(order_declaration "")
  set(order_definition "")
  set(order_include "")
  if(embed_ORDERED)
    set(order_include "#include <vector>\n")
    set(order_declaration
"/// The names of the files in the order in which CMake lists them.
const std::vector<std::string_view>& ${name}_in_order();
")
    set(order_definition
"const std::vector<std::string_view>& ${name}_in_order() {
  static const std::vector<std::string_view> names{${names}};
  return names;
}
")
  endif()
  file(CONFIGURE OUTPUT ${dir}/${name}.h @ONLY CONTENT
"#pragma once
#include <map>
#include <string_view>
@order_include@namespace twrench::embedded {
/// The embedded files by name; their bytes live as long as the program.
const std::map<std::string_view, std::string_view>& @name@();
@order_declaration@}
")
  file(CONFIGURE OUTPUT ${dir}/${name}.cpp @ONLY CONTENT
"#include \"embedded/@name@.h\"
#include <cstddef>
extern \"C\" {
@symbols@}
@assembly@
namespace twrench::embedded {
const std::map<std::string_view, std::string_view>& @name@() {
  static const std::map<std::string_view, std::string_view> files{
@lookups@  };
  return files;
}
@order_definition@}
")
  # Not in a unity build, whose files do not depend on embedded files.
  set_source_files_properties(${dir}/${name}.cpp PROPERTIES
    OBJECT_DEPENDS "${paths}" SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
  target_sources(${target} PRIVATE ${dir}/${name}.cpp)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
