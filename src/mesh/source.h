#pragma once

#include <twrench/body/triangle_mesh.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::mesh {

/// The bytes of a file in one of the formats.
struct Source {
  /// What messages call it.
  std::string name;
  std::string_view bytes;
  /// The folder in which the files lie that it may refer to; nothing where there are none.
  std::optional<std::filesystem::path> folder;
};

/// Another file to which one refers, and which was read for it.
struct OtherFile {
  std::filesystem::path path;
  /// SHA-256 of its bytes, in hexadecimal digits.
  std::string sha256;
};

/// What stands in a file: finite coordinates in its own unit, and indices that are in range.
struct Content {
  body::TriangleMesh mesh;
  /// Centimetres per unit, where the format determines it.
  std::optional<double> scale = {};
  /// What was passed over.
  std::vector<std::string> notes = {};
  std::vector<OtherFile> others = {};
};

}  // namespace twrench::mesh
