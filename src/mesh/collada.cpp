#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/words.h"
#include "mesh/assembly.h"
#include "mesh/formats.h"
#include "mesh/polygon.h"
#include "mesh/xml_numbers.h"
#include "system/error.h"

namespace twrench::mesh {
namespace {

using Eigen::Affine3d;
using pugi::xml_node;

/// The triangles of one <geometry>, in its own coordinates.
struct Geometry {
  body::TriangleMesh mesh;
  std::uint64_t lines = 0;  ///< Primitives that are left out.
};

class ColladaReader {
 public:
  explicit ColladaReader(const Source& source)
      : source_(source), assembly_(source.name, source.bytes.size()) {
    // Only the five entities of XML are expanded, and nothing else is loaded.
    const pugi::xml_parse_result parsed = document_.load_buffer(
        source.bytes.data(), source.bytes.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!parsed) {
      throw bad(fmt::format("the XML document is cut off or damaged at byte {}: {}", parsed.offset,
                            to_lower(parsed.description())));
    }
    if (root().name() != std::string_view("COLLADA")) {
      throw bad(fmt::format("it is no COLLADA document: its root is <{}>", root().name()));
    }
    index_elements();
  }

  Content read() {
    content_.scale = 100.0 * metres_per_unit();
    const xml_node scene =
        target(root().child("scene").child("instance_visual_scene"), "visual_scene");
    add_nodes(scene, Affine3d::Identity(), 0);
    content_.mesh = std::move(assembly_.mesh());
    add_notes();
    return std::move(content_);
  }

 private:
  xml_node root() const { return document_.document_element(); }

  system::FileError bad(const std::string& why) const {
    return {"cannot read " + source_.name, why, "save it again as COLLADA 1.4 or 1.5, in UTF-8"};
  }

  InvalidArgument bad(xml_node element, const std::string& why,
                      const std::string& remedy = {}) const {
    const std::string_view id = element.attribute("id").value();
    const std::string name = id.empty()
                                 ? fmt::format("<{}>", element.name())
                                 : fmt::format("<{} id=\"{}\">", element.name(), id.substr(0, 80));
    return {fmt::format("{}: {}", source_.name, name), why, remedy};
  }

  /// Lists the elements by their identifiers. Throws if some are nested too deeply.
  void index_elements() {
    std::size_t depth = 0;
    for (xml_node element = root(); element;) {
      if (depth > most_nested) {
        throw InvalidArgument(source_.name,
                              fmt::format("its elements are nested more than {} deep", most_nested),
                              "save it with fewer levels of nodes");
      }
      if (const pugi::xml_attribute id = element.attribute("id"))
        elements_.emplace(id.value(), element);
      if (element.first_child()) {
        element = element.first_child();
        ++depth;
        continue;
      }
      for (; !element.next_sibling() && depth > 0; --depth) element = element.parent();
      element = element.next_sibling();
    }
  }

  double metres_per_unit() const {
    const xml_node unit = root().child("asset").child("unit");
    const pugi::xml_attribute meter = unit.attribute("meter");
    if (!meter) return 1.0;  // the default of COLLADA
    const auto length = real_number(meter.value());
    if (length && std::isfinite(*length) && *length > 0.0) return *length;
    throw bad(unit, "its meter is no positive number", "write metres per unit, such as 0.001");
  }

  /// Returns the element that a reference in this file names. Throws unless it is of that kind.
  xml_node target(xml_node reference, const char* kind) const {
    const pugi::xml_attribute link =
        reference.attribute(reference.attribute("url") ? "url" : "source");
    const std::string_view name = link.value();
    const auto found = elements_.find(name.substr(std::min<std::size_t>(1, name.size())));
    const bool is_here = name.starts_with('#') && found != elements_.end();
    if (is_here && found->second.name() == std::string_view(kind)) return found->second;
    if (!reference) throw bad(fmt::format("it refers to no {}", kind));
    throw bad(reference, fmt::format("it refers to '{}', which is no {} of this file",
                                     name.substr(0, 80), kind));
  }

  /// Adds the nodes in a scene or a node.
  void add_nodes(xml_node parent, const Affine3d& transform, std::size_t depth) {
    assembly_.enter_node(depth);
    Affine3d own = transform;
    for (const xml_node child : parent.children()) {
      const std::string_view name = child.name();
      append_transform(child, own);
      if (name == "node") add_nodes(child, own, depth + 1);
      if (name == "instance_node") add_nodes(target(child, "node"), own, depth + 1);
      if (name == "instance_geometry") add_instance(target(child, "geometry"), own);
      if (name == "instance_controller") ++controllers_;
    }
  }

  void append_transform(xml_node element, Affine3d& transform) const {
    const std::string_view name = element.name();
    if (name == "translate") transform.translate(Eigen::Vector3d(numbers(element, 3).data()));
    if (name == "scale") transform.scale(Eigen::Vector3d(numbers(element, 3).data()));
    if (name == "rotate") {
      const std::vector<double> r = numbers(element, 4);
      const Eigen::Vector3d axis(r.data());
      if (axis.norm() == 0.0) return;
      transform.rotate(Eigen::AngleAxisd(r[3] * std::numbers::pi / 180.0, axis.normalized()));
    }
    if (name == "matrix") {
      const std::vector<double> rows = numbers(element, 16);
      transform =
          transform *
          Affine3d(Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(rows.data()));
    }
    if (name == "skew" || name == "lookat") {
      throw bad(element, "this transform is not read", "save the node with a matrix");
    }
  }

  std::vector<double> numbers(xml_node element, std::size_t count) const {
    std::vector<double> all = real_numbers(element);
    if (all.size() == count && std::ranges::all_of(all, [](double x) { return std::isfinite(x); }))
      return all;
    throw bad(element, fmt::format("it has no {} finite numbers", count));
  }

  /// Converts the numbers of an element. Throws if a word is no number.
  std::vector<double> real_numbers(xml_node element) const {
    std::vector<double> all;
    for_each_word(element, [&](std::string_view word) {
      const auto number = real_number(word);
      if (!number) throw bad(element, fmt::format("'{}' is no number", word.substr(0, 40)));
      all.push_back(*number);
    });
    return all;
  }

  std::vector<std::uint32_t> whole_numbers(xml_node element) const {
    std::vector<std::uint32_t> all;
    for_each_word(element, [&](std::string_view word) {
      const auto number = whole_number(word);
      if (!number) throw bad(element, fmt::format("'{}' is no index", word.substr(0, 40)));
      all.push_back(*number);
    });
    return all;
  }

  /// Adds a geometry as a node places it.
  void add_instance(xml_node element, const Affine3d& transform) {
    const auto [at, is_new] = geometries_.try_emplace(element);
    if (is_new) at->second = geometry(element);
    const Geometry& geometry = at->second;
    lines_ += geometry.lines;
    assembly_.add(geometry.mesh, transform);
  }

  Geometry geometry(xml_node element) const {
    Geometry result;
    const xml_node mesh = element.child("mesh");
    if (!mesh) throw bad(element, "it has no <mesh>", "save it as a mesh");
    add_vertices(mesh, result.mesh);
    Polygons polygons;
    for (const xml_node primitive : mesh.children()) {
      const std::string_view name = primitive.name();
      if (name == "lines" || name == "linestrips") ++result.lines;
      if (name == "triangles" || name == "polylist" || name == "polygons" || name == "trifans" ||
          name == "tristrips") {
        add_primitive(primitive, result.mesh, polygons);
      }
    }
    polygons.triangulate(result.mesh);
    return result;
  }

  void add_vertices(xml_node mesh, body::TriangleMesh& to) const {
    const xml_node vertices = mesh.child("vertices");
    const xml_node input = vertices.find_child_by_attribute("input", "semantic", "POSITION");
    if (!input) return;  // Without vertices, all indices are out of range.
    const xml_node accessor = target(input, "source").child("technique_common").child("accessor");
    const std::vector<double> all = real_numbers(target(accessor, "float_array"));
    const std::size_t stride = accessor.attribute("stride").as_ullong(1);
    const std::size_t offset = accessor.attribute("offset").as_ullong(0);
    const std::size_t count = accessor.attribute("count").as_ullong(0);
    if (stride < 3 || offset > all.size() || count > (all.size() - offset) / stride) {
      throw bad(input.parent(), fmt::format("its positions need {} rows of {} numbers from {} on, "
                                            "but there are {} numbers",
                                            count, stride, offset, all.size()));
    }
    to.vertices.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      to.vertices.emplace_back(all.data() + offset + i * stride);
      if (!to.vertices.back().allFinite()) {
        throw bad(vertices, fmt::format("vertex {}: a coordinate is not a finite number", i));
      }
    }
  }

  /// Adds the faces of a primitive.
  void add_primitive(xml_node primitive, body::TriangleMesh& to, Polygons& polygons) const {
    const std::string_view name = primitive.name();
    if (primitive.child("ph")) {
      throw bad(primitive, "polygons with holes are not read", "save it in triangles");
    }
    const std::vector<std::uint32_t> sizes = whole_numbers(primitive.child("vcount"));
    for (const xml_node list : primitive.children("p")) {
      const std::vector<std::uint32_t> ring = corners(primitive, list, to.vertices.size());
      if (name == "polygons")
        add_polygons({{static_cast<std::uint32_t>(ring.size())}}, ring, primitive, to, polygons);
      if (name == "polylist") add_polygons(sizes, ring, primitive, to, polygons);
      const std::size_t step = name == "triangles" ? 3 : 1;
      if (name == "polygons" || name == "polylist") continue;
      for (std::size_t i = 0; i + 2 < ring.size(); i += step) {
        std::array triangle{ring[i], ring[i + 1], ring[i + 2]};
        if (name == "trifans") triangle[0] = ring[0];
        if (name == "tristrips" && i % 2 == 1) std::swap(triangle[1], triangle[2]);
        to.triangles.push_back(triangle);
      }
    }
  }

  void add_polygons(const std::vector<std::uint32_t>& sizes, const std::vector<std::uint32_t>& ring,
                    xml_node primitive, body::TriangleMesh& to, Polygons& polygons) const {
    std::size_t at = 0;
    for (const std::uint32_t size : sizes) {
      if (size < 3 || size > ring.size() - at) {
        throw bad(primitive, fmt::format("a face has {} corners; it needs 3 at least, and {} are "
                                         "left in the list",
                                         size, ring.size() - at));
      }
      polygons.add(std::span(ring).subspan(at, size), to);
      at += size;
    }
  }

  /// Returns the vertices of the corners in a list, which also has the indices of normals.
  std::vector<std::uint32_t> corners(xml_node primitive, xml_node list,
                                     std::size_t vertices) const {
    std::size_t stride = 1, offset = 0;
    for (const xml_node input : primitive.children("input")) {
      const std::size_t own = input.attribute("offset").as_uint(0);
      stride = std::max(stride, own + 1);
      if (input.attribute("semantic").value() == std::string_view("VERTEX")) offset = own;
    }
    const std::vector<std::uint32_t> all = whole_numbers(list);
    std::vector<std::uint32_t> result;
    for (std::size_t i = offset; i < all.size(); i += stride) {
      if (all[i] >= vertices) {
        throw bad(primitive, fmt::format("it refers to vertex {}, but there are {} vertices, from "
                                         "0 on",
                                         all[i], vertices));
      }
      result.push_back(all[i]);
    }
    return result;
  }

  void add_notes() {
    if (lines_ > 0) {
      content_.notes.push_back(
          fmt::format("{} of its primitives are lines, and are left out", lines_));
    }
    if (controllers_ > 0) {
      content_.notes.push_back(
          fmt::format("its {} skins and morph targets are left out", controllers_));
    }
  }

  const Source& source_;
  pugi::xml_document document_;
  std::unordered_map<std::string_view, xml_node> elements_;
  std::map<xml_node, Geometry> geometries_;
  Assembly assembly_;
  Content content_;
  std::uint64_t lines_ = 0, controllers_ = 0;
};

}  // namespace

Content read_collada(const Source& source) { return ColladaReader(source).read(); }

}  // namespace twrench::mesh
