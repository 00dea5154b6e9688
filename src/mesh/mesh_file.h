#pragma once

#include <twrench/base/error.h>
#include <twrench/body/shape.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "system/error.h"

namespace twrench::mesh {

/// How the mesh of a file is meant.
struct ReadOptions {
  /// Centimetres per unit of the file. glTF, which is in metres, needs none.
  std::optional<double> scale;
  /// Vertices that are no farther apart than this, in cm, are joined; 0 joins those that coincide.
  double weld = 0.0;
  /// Thickness in cm of the wall along the surface, which may be open then; 0 for a solid.
  double shell = 0.0;
  /// Whether a solid is searched for triangles that cross and components that do not belong.
  bool search = true;
};

/// A mesh that was read and found sound.
struct MeshFile {
  /// The solid or the wall, in cm, with its integrals. These come from the coordinates in the
  /// file's own unit, so that the scale does not round what a distant body depends on.
  body::Mesh shape;
  /// The area of the surface in cm^2.
  double area = 0.0;
  /// Edges at which as many triangles do not run one way as the other; 0 for a solid.
  std::size_t open_edges = 0;
  /// Pieces of the surface that share no edge.
  std::size_t components = 0;
  /// What was changed or left out, a line each, for the user.
  std::vector<std::string> notes;
  /// SHA-256 of the bytes in hexadecimal digits. Where a glTF file has buffers in other files, it
  /// is that of the digests, in their order.
  std::string sha256;
  /// The other files of which it consists: the buffers of a glTF file that are not in it.
  std::vector<std::filesystem::path> others;
};

/// A mesh that can be read, but does not bound a solid or is not given completely.
class MeshError : public InvalidArgument {
 public:
  /// What is missing.
  enum class Reason {
    no_scale,  ///< The file has no unit, and none is given.
    open       ///< The surface is open.
  };

  /// The file and why, the remedy in the keys of a scene file, and the tolerance in cm at which
  /// welding closes the surface, if there is one.
  MeshError(Reason reason, const std::string& file, const std::string& why,
            const std::string& remedy, std::optional<double> weld = {})
      : InvalidArgument(file, why, remedy), reason_(reason), weld_(weld) {}

  Reason reason() const noexcept { return reason_; }
  const std::optional<double>& weld() const noexcept { return weld_; }

  /// Returns the same error with another remedy, for those who have no keys of a scene file.
  InvalidArgument with_remedy(const std::string& remedy) const;

 private:
  Reason reason_;
  std::optional<double> weld_;
};

/// Whether the name ends as those of meshes do: .obj, .stl, .ply, .gltf, .glb, in any case.
bool is_mesh_name(const std::filesystem::path& file);

/// Returns the length in cm of a unit: mm, cm, m, inch, km. Throws InvalidArgument about `what`.
double unit_length(const std::string& what, std::string_view unit);

/// Reads a mesh in OBJ, STL, PLY or glTF, whichever its content is. Equal vertices are joined, and
/// triangles without area that this leaves are taken out. A solid is turned inside out where that
/// is what it needs. Throws InvalidArgument about the file, or a line or triangle of it, where the
/// mesh is no solid, OutOfRange about "scale", "weld" and "shell", and system::FileError where the
/// file cannot be read, is longer than 1 GiB, or is damaged.
MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options);

/// Reads a mesh from memory; `name` is what messages call it, and its ending counts like a file's.
MeshFile read_mesh(std::string_view bytes, const std::string& name, const ReadOptions& options);

/// Does the same with a mesh that is in memory, whose unit is a centimetre unless the options say
/// otherwise; `name` is what messages call it. Throws InvalidArgument also where an index is out of
/// range or a coordinate is not finite.
MeshFile checked_mesh(const std::string& name, body::TriangleMesh mesh, const ReadOptions& options);

}  // namespace twrench::mesh
