#include "mesh/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/enumeration.h"

namespace twrench::mesh {
namespace {

struct TypeName {
  PlyType type;
  std::string_view name, other_name;
  std::size_t bytes;
};

constexpr std::array type_names{TypeName{PlyType::int8, "char", "int8", 1},
                                TypeName{PlyType::uint8, "uchar", "uint8", 1},
                                TypeName{PlyType::int16, "short", "int16", 2},
                                TypeName{PlyType::uint16, "ushort", "uint16", 2},
                                TypeName{PlyType::int32, "int", "int32", 4},
                                TypeName{PlyType::uint32, "uint", "uint32", 4},
                                TypeName{PlyType::float32, "float", "float32", 4},
                                TypeName{PlyType::float64, "double", "float64", 8}};
static_assert(has_row_for_each(type_names, &TypeName::type));

PlyType read_type(LineReader& lines) {
  const std::string_view word = lines.word();
  for (const TypeName& known : type_names) {
    if (word == known.name || word == known.other_name) return known.type;
  }
  throw lines.bad(fmt::format("{} is no type of PLY", shown(word)));
}

PlyHeader::Format read_format(LineReader& lines) {
  const std::string_view word = lines.word();
  if (word == "ascii") return PlyHeader::Format::text;
  if (word == "binary_little_endian") return PlyHeader::Format::little_endian;
  if (word == "binary_big_endian") return PlyHeader::Format::big_endian;
  throw lines.bad(fmt::format("{} is no format of PLY", shown(word)));
}

PlyElement read_element(LineReader& lines) {
  PlyElement element;
  element.name = lines.word();
  const std::string_view count = lines.word();
  const auto [stop, error] =
      std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (error == std::errc() && stop == count.data() + count.size()) return element;
  throw lines.bad(fmt::format("{} is no number of elements", shown(count)));
}

PlyProperty read_property(LineReader& lines) {
  PlyProperty property;
  LineReader after = lines;
  if (after.word() == "list") {
    lines = after;
    property.count_type = read_type(lines);
  }
  property.type = read_type(lines);
  property.name = lines.word();
  return property;
}

}  // namespace

std::size_t size_of(PlyType type) {
  return std::ranges::find(type_names, type, &TypeName::type)->bytes;
}

PlyHeader read_ply_header(LineReader& lines) {
  PlyHeader header;
  bool has_format = false;
  lines.next();
  if (lines.word() != "ply") throw lines.bad("a PLY file begins with 'ply'");
  while (lines.next()) {
    const std::string_view keyword = lines.word();
    if (keyword == "end_header") {
      if (has_format) return header;
      throw lines.bad("the header has no 'format' line");
    }
    if (keyword == "format") {
      header.format = read_format(lines);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(lines));
    } else if (keyword == "property") {
      if (header.elements.empty()) throw lines.bad("a property before the first element");
      header.elements.back().properties.push_back(read_property(lines));
    } else if (keyword != "comment" && keyword != "obj_info") {
      throw lines.bad(fmt::format("{} is no keyword of a PLY header", shown(keyword)));
    }
  }
  throw lines.bad("the file is cut off: its header does not end");
}

}  // namespace twrench::mesh
