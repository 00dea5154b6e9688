#include "mesh/gltf.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/gltf_accessor.h"
#include "mesh/gltf_buffers.h"
#include "mesh/gltf_chunks.h"
#include "mesh/gltf_json.h"
#include "mesh/gltf_nodes.h"
#include "mesh/gltf_sizes.h"

namespace twrench::mesh {
namespace {

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
