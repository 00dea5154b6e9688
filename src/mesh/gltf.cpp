#include "mesh/gltf.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/gltf_buffers.h"
#include "mesh/gltf_chunks.h"
#include "mesh/gltf_json.h"

namespace twrench::mesh {
namespace {

using Eigen::Matrix4d;

/// A file can name its triangles as often as it likes.
constexpr std::size_t most_corners = 300'000'000;

/// A component of a colour as it is shown, of light (IEC 61966-2-1).
float srgb_of_linear(double light) {
  const double x = std::clamp(light, 0.0, 1.0);
  return static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

/// The transform of a node in its parent's frame.
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

/// Triangles of a primitive, as glTF calls its kinds.
enum class Mode : std::uint64_t { triangles = 4, strip = 5, fan = 6 };

class GltfReader {
 public:
  GltfReader(const Source& source, const GltfValue& document,
             std::optional<std::string_view> binary)
      : source_(source), document_(document), buffers_(source, document, binary) {}

  Content read() {
    require_readable();
    visited_.resize(document_.size("nodes"));
    std::vector<std::pair<std::uint64_t, Matrix4d>> open;
    for (const std::uint64_t root : roots()) open.emplace_back(root, Matrix4d::Identity());
    while (!open.empty()) {
      const auto [index, parent] = open.back();
      open.pop_back();
      const GltfValue node = document_.at("nodes").at(index);
      if (visited_[index]) throw node.bad("is a child of more than one node");
      visited_[index] = true;
      const Matrix4d transform = parent * transform_of(node);
      if (const auto mesh = node.find("mesh")) add_mesh(mesh->whole(), transform);
      for (const std::uint64_t child : indices(node.find("children"))) {
        open.emplace_back(child, transform);
      }
    }
    add_notes();
    return std::move(content_);
  }

 private:
  static std::vector<std::uint64_t> indices(const std::optional<GltfValue>& list) {
    std::vector<std::uint64_t> all;
    for (std::size_t i = 0; list && i < list->size(); ++i) all.push_back(list->at(i).whole());
    return all;
  }

  /// Throws where the file needs what is not read.
  void require_readable() const {
    if (!document_.at("asset").at("version").text().starts_with("2.")) {
      throw document_.at("asset").at("version").bad("is not 2.0");
    }
    for (std::size_t i = 0; i < document_.size("extensionsRequired"); ++i) {
      const std::string name = document_.at("extensionsRequired").at(i).text();
      // These change the look, or types of numbers that are read all the same.
      constexpr std::array harmless{"KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_",
                                    "KHR_mesh_quantization"};
      if (std::ranges::any_of(harmless, [&](const char* h) { return name.starts_with(h); }))
        continue;
      throw InvalidArgument(
          source_.name,
          fmt::format("it needs the extension '{}', which is not read", name.substr(0, 80)),
          "save it without compression");
    }
  }

  /// The nodes at the top of the scene that is shown, or of all where the file has no scene.
  std::vector<std::uint64_t> roots() const {
    if (document_.size("scenes") > 0) {
      return indices(document_.at("scenes").at(document_.whole_or("scene", 0)).find("nodes"));
    }
    const std::size_t count = document_.size("nodes");
    std::vector<bool> is_child(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (const std::uint64_t child : indices(document_.at("nodes").at(i).find("children"))) {
        if (child < count) is_child[child] = true;
      }
    }
    std::vector<std::uint64_t> top;
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_child[i]) top.push_back(i);
    }
    return top;
  }

  void add_mesh(std::uint64_t index, const Matrix4d& transform) {
    const GltfValue primitives = document_.at("meshes").at(index).at("primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const GltfValue primitive = primitives.at(i);
      const std::uint64_t mode = primitive.whole_or("mode", 4);
      if (mode < 4)
        ++points_and_lines_;
      else if (mode > 6)
        throw primitive.at("mode").bad("is no kind of primitive");
      else
        add_primitive(primitive, static_cast<Mode>(mode), transform);
      has_targets_ = has_targets_ || primitive.find("targets");
    }
  }

  GltfAccessor accessor(const GltfValue& index, std::size_t least_components) {
    const GltfValue value = document_.at("accessors").at(index.whole());
    GltfAccessor accessor(value, buffers_);
    if (accessor.components() < least_components) throw value.bad("has too few components");
    return accessor;
  }

  void add_primitive(const GltfValue& primitive, Mode mode, const Matrix4d& transform) {
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
    if (corners.size() > most_corners - corners_) throw repeats_too_often();
    corners_ += corners.size();
    // A transform that mirrors turns the triangles over.
    add_triangles(corners, mode, transform.topLeftCorner<3, 3>().determinant() < 0);
  }

  void add_vertices(const GltfValue& index, const Matrix4d& transform) {
    body::TriangleMesh& mesh = content_.mesh;
    const GltfAccessor positions = accessor(index, 3);
    if (positions.size() > most_corners - mesh.vertices.size()) throw repeats_too_often();
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Eigen::Vector4d point(positions.at(i, 0), positions.at(i, 1), positions.at(i, 2), 1.0);
      mesh.vertices.emplace_back((transform * point).head<3>());
      if (mesh.vertices.back().allFinite()) continue;
      throw InvalidArgument(fmt::format("{}: {}, element {}", source_.name, index.place(), i),
                            "a coordinate is not a finite number");
    }
    if (!mesh.colors.empty()) mesh.colors.resize(mesh.vertices.size(), {1.0F, 1.0F, 1.0F});
  }

  /// The linear colour of a primitive's material, where that has one.
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

  /// Gives the vertices from `first` on the product of their own linear colour and their
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

  void add_triangles(const std::vector<std::uint32_t>& corners, Mode mode, bool mirrored) {
    const std::size_t step = mode == Mode::triangles ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      std::array triangle{corners[i], corners[i + 1], corners[i + 2]};
      if (mode == Mode::fan) triangle[0] = corners[0];
      const bool is_odd = mode == Mode::strip && i % 2 == 1;
      if (is_odd != mirrored) std::swap(triangle[1], triangle[2]);
      content_.mesh.triangles.push_back(triangle);
    }
  }

  InvalidArgument repeats_too_often() const {
    return {source_.name,
            fmt::format("its nodes repeat its meshes to more than {} corners", most_corners),
            "remove repeated nodes"};
  }

  void add_notes() {
    content_.scale = 100.0;
    content_.others = buffers_.files();
    if (points_and_lines_ > 0) {
      content_.notes.push_back(fmt::format(
          "{} of its primitives are points or lines, and are left out", points_and_lines_));
    }
    if (document_.size("skins") > 0 || document_.size("animations") > 0 || has_targets_) {
      content_.notes.emplace_back("its skins, morph targets and animations are left out");
    }
  }

  const Source& source_;
  GltfValue document_;
  GltfBuffers buffers_;
  Content content_;
  std::vector<bool> visited_;
  std::size_t corners_ = 0, points_and_lines_ = 0;
  bool has_targets_ = false;
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
