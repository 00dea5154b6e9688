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
  /// The name in messages.
  std::string name;
  std::string_view bytes;
  /// The folder of the files that this one may refer to; nothing if it may refer to none.
  std::optional<std::filesystem::path> folder;
};

/// Another file that a mesh file refers to and that was read for it.
struct OtherFile {
  std::filesystem::path path;
  /// SHA-256 of its bytes, in hexadecimal digits.
  std::string sha256;
};

/// The content of a file: finite coordinates in its own unit, and indices that are in range.
struct Content {
  body::TriangleMesh mesh;
  /// Centimetres per unit, if the format determines it.
  std::optional<double> scale = {};
  /// Notes on ignored content.
  std::vector<std::string> notes = {};
  std::vector<OtherFile> others = {};
};

}  // namespace twrench::mesh
