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

/// How to interpret the mesh of a file.
struct ReadOptions {
  /// Centimetres per unit of the file. Not needed for glTF, which is in metres, and COLLADA and
  /// 3MF, which state their unit.
  std::optional<double> scale = {};
  /// Centimetres per unit of a file that does not determine it.
  std::optional<double> default_scale = {};
  /// Multiplies all lengths of the file.
  double factor = 1.0;
  /// Welding tolerance in cm: vertices that are no farther apart are joined; 0 joins only those
  /// that coincide.
  double weld = 0.0;
  /// Thickness in cm of a wall along the surface, which may then be open; 0 for a solid.
  double shell = 0.0;
  /// Whether a solid is searched for triangles that cross and components that are misplaced.
  bool search = true;
};

/// A mesh that was read and passed the checks.
struct MeshFile {
  /// The solid or the wall, in cm, with its integrals. The integrals are computed in the file's own
  /// unit. Scaling would round the coordinates, and the integrals of a distant body are sensitive
  /// to that.
  body::Mesh shape;
  /// The area of the surface in cm^2.
  double area = 0.0;
  /// Edges along which the numbers of triangles in the two directions differ; 0 for a solid.
  std::size_t open_edges = 0;
  /// Pieces of the surface that share no edge.
  std::size_t components = 0;
  /// Notes for the user on changed or omitted content, one per line.
  std::vector<std::string> notes;
  /// SHA-256 of the bytes in hexadecimal digits. If a glTF file has buffers in other files, it is
  /// the digest of the digests of all files, in order.
  std::string sha256;
  /// The other files that belong to the mesh: the external buffers of a glTF file.
  std::vector<std::filesystem::path> others;
};

/// A mesh that can be read, but does not bound a solid or is incomplete.
class MeshError : public InvalidArgument {
 public:
  /// The defect of the mesh.
  enum class Reason {
    no_scale,  ///< The unit of the file is unknown and was not given.
    open       ///< The surface is open.
  };

  /// `file` was rejected because of `why`. `remedy` is worded in keys of a scene file. `weld` is
  /// the tolerance in cm at which welding closes the surface, if there is one.
  MeshError(Reason reason, const std::string& file, const std::string& why,
            const std::string& remedy, std::optional<double> weld = {})
      : InvalidArgument(file, why, remedy), reason_(reason), weld_(weld) {}

  Reason reason() const noexcept { return reason_; }
  const std::optional<double>& weld() const noexcept { return weld_; }

  /// Returns the same error with another remedy, for callers without a scene file.
  InvalidArgument with_remedy(const std::string& remedy) const;

 private:
  Reason reason_;
  std::optional<double> weld_;
};

/// Returns whether the name has an extension of a mesh file: .obj, .stl, .ply, .gltf, .glb, .dae or
/// .3mf, in upper or lower case.
bool is_mesh_name(const std::filesystem::path& file);

/// Returns the names of the units that a mesh file may use.
std::vector<std::string> unit_names();

/// Returns the length in cm of a unit. Throws InvalidArgument about `what` if the unit is unknown.
double unit_length(const std::string& what, std::string_view unit);

/// Reads a mesh in OBJ, STL, PLY, glTF, COLLADA or 3MF. The content identifies PLY, binary glTF and
/// 3MF, the extension the others. Joins equal vertices and removes the triangles that lose their
/// area by this. Turns a solid over if it is inside out. Throws InvalidArgument about the file, or
/// a line or triangle of it, if the mesh is not a solid, OutOfRange about "scale", "weld" and
/// "shell", and system::FileError if the file cannot be read, is longer than 1 GiB, or is damaged.
MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options);

/// Reads a mesh file from memory. `name` identifies it in messages, and its extension is used as
/// that of a file name.
MeshFile read_mesh(std::string_view bytes, const std::string& name, const ReadOptions& options);

/// Does the same with a mesh structure, whose unit is a centimetre unless the options say
/// otherwise. `name` identifies it in messages. Also throws InvalidArgument if an index is out of
/// range or a coordinate is not finite.
MeshFile checked_mesh(const std::string& name, body::TriangleMesh mesh, const ReadOptions& options);

}  // namespace twrench::mesh
