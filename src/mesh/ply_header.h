#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/line_reader.h"

namespace twrench::mesh {

/// The types of numbers in PLY files.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Returns the size in bytes of a number of the type in a binary file.
std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type{};
  /// For a list, the type of its entry count.
  std::optional<PlyType> count_type;
};

/// Items of one kind, such as vertices.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  enum class Format { text, little_endian, big_endian };
  Format format = Format::text;
  std::vector<PlyElement> elements;
};

/// Reads the header and leaves the lines that follow it. Throws system::FileError if it is damaged.
PlyHeader read_ply_header(LineReader& lines);

}  // namespace twrench::mesh
