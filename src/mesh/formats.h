#pragma once

#include <twrench/body/triangle_mesh.h>

#include <array>
#include <bit>
#include <cstddef>
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

/// Returns the number stored at `offset` in the given byte order. The caller checks the bounds.
template <typename Number>
Number number_at(std::string_view bytes, std::size_t offset,
                 std::endian order = std::endian::little) {
  std::array<char, sizeof(Number)> own{};
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::size_t from = order == std::endian::native ? i : own.size() - 1 - i;
    own[i] = bytes[offset + from];
  }
  return std::bit_cast<Number>(own);
}

/// Reads the vertices, with their colours, and the faces of a Wavefront OBJ file; everything else,
/// including materials, is ignored. Throws system::FileError about a line that is not OBJ, and
/// InvalidArgument about a line with invalid numbers.
Content read_obj(const Source& source);

/// Returns whether the bytes are exactly a binary STL file. The size decides, because many binary
/// files begin with "solid" as text files do.
bool is_binary_stl(std::string_view bytes);

/// Reads the triangles of an STL file, binary or text. No two triangles share a vertex. Normals and
/// the two bytes of attributes are ignored; longer attributes and bytes after the last triangle are
/// ignored with a note. Throws system::FileError if the file is damaged, and InvalidArgument if
/// a coordinate is not finite.
Content read_stl(const Source& source);

/// Reads the vertices, with their colours, and the faces of a PLY file, text or binary in either
/// byte order; other elements and properties are ignored, and bytes after the last element with a
/// note. Throws system::FileError if the file is damaged, and InvalidArgument if its numbers are
/// invalid.
Content read_ply(const Source& source);

/// Reads the triangles of the scene in a glTF 2.0 file, text or binary, in metres, with the nodes'
/// transforms applied and with the colours of the vertices. Of a material, only the base colour
/// factor is used; textures, skins, morph targets and animations are ignored. Buffers may only be
/// in the file itself or in files beside it. Throws system::FileError if the file is damaged, and
/// InvalidArgument if it requires an unsupported feature.
Content read_gltf(const Source& source);

/// Reads the faces of the scene in a COLLADA file, with the nodes' transforms applied, in the unit
/// that the file states. The coordinates are those of the file, whatever its up_axis, as in RViz.
/// Lines, skins and morph targets are left out with a note; materials and colours are ignored.
/// Throws system::FileError if the file is no COLLADA, and InvalidArgument about an element.
Content read_collada(const Source& source);

/// Reads the meshes of the build of a 3MF file, with the transforms of items and components
/// applied, in the unit that the file states. Objects of types other than "model" and
/// "solidsupport" are left out with a note; colours and materials are ignored. Throws
/// system::FileError if the archive is damaged or encrypted, or has no model or too much of it, and
/// InvalidArgument about an element.
Content read_3mf(const Source& source);

}  // namespace twrench::mesh
