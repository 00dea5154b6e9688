#include <fmt/format.h>
#include <twrench/base/error.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/formats.h"
#include "mesh/gltf_document.h"

namespace twrench::mesh {
namespace {

/// A mesh of a glTF file as placed by a node.
struct GltfInstance {
  std::uint64_t mesh;
  Eigen::Matrix4d transform;  ///< From the mesh to the scene.
  /// Whether the node repeats the mesh by the extension EXT_mesh_gpu_instancing, which is not read.
  bool is_repeated;
};

using Eigen::Matrix4d;

/// Returns the transform of a node in its parent's frame.
Matrix4d transform_of(const GltfValue& node) {
  if (const auto matrix = node.find("matrix")) {
    const std::vector<double> columns = matrix->numbers(16);
    return Eigen::Map<const Matrix4d>(columns.data());
  }
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (const auto translation = node.find("translation")) {
    const std::vector<double> t = translation->numbers(3);
    transform.translate(Eigen::Vector3d(t[0], t[1], t[2]));
  }
  if (const auto rotation = node.find("rotation")) {
    const std::vector<double> q = rotation->numbers(4);
    transform.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized());
  }
  if (const auto scale = node.find("scale")) {
    const std::vector<double> s = scale->numbers(3);
    transform.scale(Eigen::Vector3d(s[0], s[1], s[2]));
  }
  return transform.matrix();
}

std::vector<std::uint64_t> indices(const std::optional<GltfValue>& list) {
  std::vector<std::uint64_t> all;
  for (std::size_t i = 0; list && i < list->size(); ++i) all.push_back(list->at(i).whole());
  return all;
}

/// Returns the indices of the root nodes.
std::vector<std::uint64_t> roots(const GltfValue& document) {
  if (document.size("scenes") > 0) {
    return indices(document.at("scenes").at(document.whole_or("scene", 0)).find("nodes"));
  }
  const std::size_t count = document.size("nodes");
  std::vector<bool> is_child(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::uint64_t child : indices(document.at("nodes").at(i).find("children"))) {
      if (child < count) is_child[child] = true;
    }
  }
  std::vector<std::uint64_t> top;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_child[i]) top.push_back(i);
  }
  return top;
}

/// Returns the mesh instances of the default scene, or of all nodes if the file has no scene.
/// Throws system::FileError if the nodes do not form a forest.
std::vector<GltfInstance> gltf_instances(const GltfValue& document) {
  std::vector<GltfInstance> instances;
  std::vector<bool> visited(document.size("nodes"));
  std::vector<std::pair<std::uint64_t, Matrix4d>> open;
  for (const std::uint64_t root : roots(document)) open.emplace_back(root, Matrix4d::Identity());
  while (!open.empty()) {
    const auto [index, parent] = open.back();
    open.pop_back();
    const GltfValue node = document.at("nodes").at(index);
    if (visited[index]) throw node.bad("is a child of more than one node");
    visited[index] = true;
    const Matrix4d transform = parent * transform_of(node);
    if (const auto mesh = node.find("mesh")) {
      const auto extensions = node.find("extensions");
      const bool is_repeated = extensions && extensions->find("EXT_mesh_gpu_instancing");
      instances.push_back({mesh->whole(), transform, is_repeated});
    }
    for (const std::uint64_t child : indices(node.find("children"))) {
      open.emplace_back(child, transform);
    }
  }
  return instances;
}

/// The kinds of primitives that consist of triangles, with glTF's numbers.
enum class GltfMode : std::uint64_t { triangles = 4, strip = 5, fan = 6 };

/// A primitive that has triangles.
struct GltfPrimitive {
  GltfValue value;
  GltfMode mode;
};

/// The primitives of a glTF mesh and their counts.
struct GltfMesh {
  std::vector<GltfPrimitive> primitives;
  std::uint64_t vertices = 0, triangles = 0;
  std::uint64_t points_and_lines = 0;  ///< Primitives that are omitted.
  bool has_targets = false;
};

std::uint64_t triangles_of(GltfMode mode, std::uint64_t corners) {
  if (mode == GltfMode::triangles) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

void count(const GltfValue& document, const GltfValue& primitive, GltfBuffers& buffers,
           GltfMesh& mesh) {
  mesh.has_targets = mesh.has_targets || primitive.find("targets");
  const std::uint64_t mode = primitive.whole_or("mode", 4);
  if (mode > 6) throw primitive.at("mode").bad("is no kind of primitive");
  if (mode < 4) {
    ++mesh.points_and_lines;
    return;
  }
  const auto size = [&](const GltfValue& index) {
    return GltfAccessor(document.at("accessors").at(index.whole()), buffers).size();
  };
  const std::size_t vertices = size(primitive.at("attributes").at("POSITION"));
  const auto indices = primitive.find("indices");
  const std::uint64_t triangles = triangles_of(GltfMode(mode), indices ? size(*indices) : vertices);
  if (triangles == 0) return;
  mesh.vertices += vertices;
  mesh.triangles += triangles;
  mesh.primitives.push_back({primitive, GltfMode(mode)});
}

GltfMesh counted(const GltfValue& document, std::uint64_t index, GltfBuffers& buffers) {
  GltfMesh mesh;
  const GltfValue primitives = document.at("meshes").at(index).at("primitives");
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    count(document, primitives.at(i), buffers, mesh);
  }
  return mesh;
}

/// Returns the contents of the meshes that the instances use, by index, without building the
/// meshes. A file can repeat a mesh any number of times. Throws system::FileError if a mesh is
/// damaged, and InvalidArgument if the instances together have far more triangles than the file has
/// bytes.
std::map<std::uint64_t, GltfMesh> gltf_meshes(const Source& source, const GltfValue& document,
                                              const std::vector<GltfInstance>& instances,
                                              GltfBuffers& buffers) {
  std::map<std::uint64_t, GltfMesh> meshes;
  for (const GltfInstance& instance : instances) {
    if (meshes.contains(instance.mesh)) continue;
    meshes.emplace(instance.mesh, counted(document, instance.mesh, buffers));
  }
  // Without repetition, a triangle takes at least one byte.
  constexpr std::uint64_t repeated = 3'000'000;
  const std::uint64_t most =
      std::max<std::uint64_t>(source.bytes.size() + buffers.bytes(), repeated);
  std::uint64_t vertices = 0, triangles = 0;
  for (const GltfInstance& instance : instances) {
    vertices += meshes.at(instance.mesh).vertices;
    triangles += meshes.at(instance.mesh).triangles;
    if (triangles <= most && vertices <= 3 * most) continue;
    throw InvalidArgument(source.name,
                          fmt::format("its nodes repeat its meshes to more than {} triangles, or "
                                      "{} vertices",
                                      most, 3 * most),
                          "remove repeated nodes, or save each mesh as often as it is there");
  }
  return meshes;
}

using Eigen::Matrix4d;

/// Returns the sRGB component of a linear one (IEC 61966-2-1).
float srgb_of_linear(double light) {
  const double x = std::clamp(light, 0.0, 1.0);
  return static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

constexpr std::string_view instancing = "EXT_mesh_gpu_instancing";

/// Returns the remedy for a file that requires an extension which is not read.
std::string remedy_for(std::string_view extension) {
  if (extension == instancing) return "save it with a node for each instance";
  if (extension.ends_with("_compression")) return "save it without compression";
  return "save it without this extension";
}

class GltfReader {
 public:
  GltfReader(const Source& source, const GltfValue& document,
             std::optional<std::string_view> binary)
      : source_(source), document_(document), buffers_(source, document, binary) {}

  Content read() {
    require_readable();
    const std::vector<GltfInstance> instances = gltf_instances(document_);
    const auto meshes = gltf_meshes(source_, document_, instances, buffers_);
    for (const GltfInstance& instance : instances) {
      for (const auto& [primitive, mode] : meshes.at(instance.mesh).primitives) {
        add_primitive(primitive, mode, instance.transform);
      }
    }
    add_notes(instances, meshes);
    return std::move(content_);
  }

 private:
  /// Throws if the file requires an unsupported feature.
  void require_readable() const {
    if (!document_.at("asset").at("version").text().starts_with("2.")) {
      throw document_.at("asset").at("version").bad("is not 2.0");
    }
    for (std::size_t i = 0; i < document_.size("extensionsRequired"); ++i) {
      const std::string name = document_.at("extensionsRequired").at(i).text();
      // These change only the appearance, or allow number types that are read anyway.
      constexpr std::array harmless{"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                    "MSFT_texture_",  "KHR_lights_",  "KHR_mesh_quantization"};
      if (std::ranges::any_of(harmless, [&](const char* h) { return name.starts_with(h); }))
        continue;
      throw InvalidArgument(
          source_.name,
          fmt::format("it needs the extension '{}', which is not read", name.substr(0, 80)),
          remedy_for(name));
    }
  }

  GltfAccessor accessor(const GltfValue& index, std::size_t least_components) {
    const GltfValue value = document_.at("accessors").at(index.whole());
    GltfAccessor accessor(value, buffers_);
    if (accessor.components() < least_components) throw value.bad("has too few components");
    accessor.require_order();
    return accessor;
  }

  void add_primitive(const GltfValue& primitive, GltfMode mode, const Matrix4d& transform) {
    const GltfValue attributes = primitive.at("attributes");
    const std::size_t first = content_.mesh.vertices.size();
    add_vertices(attributes.at("POSITION"), transform);
    add_colors(attributes.find("COLOR_0"), base_color(primitive), first);
    const std::size_t count = content_.mesh.vertices.size() - first;
    std::vector<std::uint32_t> corners;
    if (const auto list = primitive.find("indices")) {
      corners = corners_of(*list, first, count);
    } else {
      for (std::size_t i = 0; i < count; ++i)
        corners.push_back(static_cast<std::uint32_t>(first + i));
    }
    // A mirroring transform turns the triangles over.
    add_triangles(corners, mode, transform.topLeftCorner<3, 3>().determinant() < 0);
  }

  void add_vertices(const GltfValue& index, const Matrix4d& transform) {
    body::TriangleMesh& mesh = content_.mesh;
    const GltfAccessor positions = accessor(index, 3);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Eigen::Vector4d point(positions.at(i, 0), positions.at(i, 1), positions.at(i, 2), 1.0);
      mesh.vertices.emplace_back((transform * point).head<3>());
      if (mesh.vertices.back().allFinite()) continue;
      throw InvalidArgument(fmt::format("{}: {}, element {}", source_.name, index.place(), i),
                            "a coordinate is not a finite number");
    }
    if (!mesh.colors.empty()) mesh.colors.resize(mesh.vertices.size(), {1.0F, 1.0F, 1.0F});
  }

  /// Returns the linear colour of a primitive's material, if it has one.
  std::optional<std::array<double, 3>> base_color(const GltfValue& primitive) const {
    const auto index = primitive.find("material");
    if (!index) return {};
    const GltfValue material = document_.at("materials").at(index->whole());
    const auto surface = material.find("pbrMetallicRoughness");
    const auto factor = surface ? surface->find("baseColorFactor") : std::nullopt;
    if (!factor) return {};
    const std::vector<double> color = factor->numbers(4);
    return std::array{color[0], color[1], color[2]};
  }

  /// Colours the vertices from `first` with the product of their linear colour and their
  /// material's.
  void add_colors(const std::optional<GltfValue>& index,
                  const std::optional<std::array<double, 3>>& material, std::size_t first) {
    if (!index && !material) return;
    body::TriangleMesh& mesh = content_.mesh;
    mesh.colors.resize(mesh.vertices.size(), {1.0F, 1.0F, 1.0F});
    const auto own = index ? std::optional(accessor(*index, 3)) : std::nullopt;
    for (std::size_t i = first; i < mesh.vertices.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double light = own && i - first < own->size() ? own->at(i - first, k) : 1.0;
        mesh.colors[i][k] = srgb_of_linear(light * (material ? (*material)[k] : 1.0));
      }
    }
  }

  std::vector<std::uint32_t> corners_of(const GltfValue& index, std::size_t first,
                                        std::size_t vertices) {
    const GltfAccessor list = accessor(index, 1);
    if (!list.is_unsigned()) throw index.bad("are no whole numbers");
    std::vector<std::uint32_t> corners;
    corners.reserve(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      const double corner = list.at(i, 0);
      if (corner >= static_cast<double>(vertices)) {
        throw InvalidArgument(
            fmt::format("{}: {}, element {}", source_.name, index.place(), i),
            fmt::format("it refers to vertex {}, but there are {} vertices, from 0 on", corner,
                        vertices));
      }
      corners.push_back(static_cast<std::uint32_t>(first + static_cast<std::size_t>(corner)));
    }
    return corners;
  }

  void add_triangles(const std::vector<std::uint32_t>& corners, GltfMode mode, bool mirrored) {
    const std::size_t step = mode == GltfMode::triangles ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      std::array triangle{corners[i], corners[i + 1], corners[i + 2]};
      if (mode == GltfMode::fan) triangle[0] = corners[0];
      const bool is_odd = mode == GltfMode::strip && i % 2 == 1;
      if (is_odd != mirrored) std::swap(triangle[1], triangle[2]);
      content_.mesh.triangles.push_back(triangle);
    }
  }

  void add_notes(const std::vector<GltfInstance>& instances,
                 const std::map<std::uint64_t, GltfMesh>& meshes) {
    content_.scale = 100.0;
    content_.others = buffers_.files();
    std::uint64_t points_and_lines = 0;
    bool has_targets = false, has_instances = false;
    for (const GltfInstance& instance : instances) {
      points_and_lines += meshes.at(instance.mesh).points_and_lines;
      has_targets = has_targets || meshes.at(instance.mesh).has_targets;
      has_instances = has_instances || instance.is_repeated;
    }
    if (points_and_lines > 0) {
      content_.notes.push_back(fmt::format(
          "{} of its primitives are points or lines, and are left out", points_and_lines));
    }
    if (has_instances) {
      content_.notes.push_back(
          fmt::format("the instances of its nodes ({}) are left out", instancing));
    }
    if (document_.size("skins") > 0 || document_.size("animations") > 0 || has_targets) {
      content_.notes.emplace_back("its skins, morph targets and animations are left out");
    }
  }

  const Source& source_;
  GltfValue document_;
  GltfBuffers buffers_;
  Content content_;
};

}  // namespace

Content read_gltf(const Source& source) {
  const GltfChunks chunks = gltf_chunks(source);
  try {
    const nlohmann::json json = nlohmann::json::parse(chunks.json);
    return GltfReader(source, GltfValue(source.name, json), chunks.binary).read();
  } catch (const nlohmann::json::parse_error& error) {
    throw system::FileError("cannot read " + source.name,
                            fmt::format("it is no glTF: no JSON at byte {}", error.byte));
  } catch (const nlohmann::json::exception&) {  // a number that is too large
    throw system::FileError("cannot read " + source.name, "it is no glTF: a number is too large");
  }
}

}  // namespace twrench::mesh
