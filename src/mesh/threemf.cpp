#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "archive/zip_archive.h"
#include "base/words.h"
#include "mesh/assembly.h"
#include "mesh/formats.h"
#include "mesh/xml_numbers.h"
#include "system/error.h"

namespace twrench::mesh {
namespace {

using Eigen::Affine3d;
using pugi::xml_attribute;
using pugi::xml_node;

/// Bytes of all parts that are read, when unpacked. Their elements take several times as much
/// memory.
constexpr std::size_t most_unpacked = std::size_t{256} << 20U;

/// Elements of a part, each of which takes much more memory than its bytes. The vertices and the
/// triangles of so many bytes are fewer.
constexpr std::ptrdiff_t most_elements = 10'000'000;

/// Without repetition, there are no more triangles in these bytes.
constexpr std::size_t most_triangles =
    most_unpacked / std::string_view("<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>").size();

struct LengthUnit {
  const char* name;
  double length;  ///< cm
};

constexpr std::array length_units{LengthUnit{"micron", 1e-4},    LengthUnit{"millimeter", 0.1},
                                  LengthUnit{"centimeter", 1.0}, LengthUnit{"inch", 2.54},
                                  LengthUnit{"foot", 30.48},     LengthUnit{"meter", 100.0}};

/// Beginnings of the namespaces of extensions that a file may require: parts in several files,
/// which are read, and colours and groups of triangles, which change no shape.
constexpr std::array known_extensions{
    std::string_view("http://schemas.microsoft.com/3dmanufacturing/production/2015/"),
    std::string_view("http://schemas.microsoft.com/3dmanufacturing/material/"),
    std::string_view("http://schemas.microsoft.com/3dmanufacturing/trianglesets/")};

archive::ZipBytes bytes_of(const Source& source) {
  const auto read = [bytes = source.bytes](std::uint64_t offset, char* to, std::size_t length) {
    return offset < bytes.size() ? bytes.copy(to, length, static_cast<std::size_t>(offset)) : 0;
  };
  return {"cannot read " + source.name, source.bytes.size(), read,
          "save it again as 3MF, without a password"};
}

/// A model file in the archive.
struct ModelPart {
  std::string name;
  std::string text;  ///< The parser keeps its values in these bytes.
  pugi::xml_document document = {};
  double unit = 0.0;  ///< cm
  std::unordered_map<std::string_view, xml_node> objects = {};

  xml_node root() const { return document.document_element(); }
};

/// An object as an <item> or a <component> places it.
struct Placed {
  const ModelPart* part = nullptr;
  xml_node object = {};
  Affine3d transform = Affine3d::Identity();
};

/// The content of an <object>: a mesh or other objects.
struct Object {
  /// Not empty if it is no part of the body.
  std::string skipped_type = {};
  body::TriangleMesh mesh = {};
  std::vector<Placed> components = {};
};

class ThreeMfReader {
 public:
  explicit ThreeMfReader(const Source& source)
      : source_(source), archive_(bytes_of(source)), assembly_(source.name, most_triangles) {}

  Content read() {
    root_ = &part(root_name());
    const std::vector<Placed> items = placed_objects(*root_, root_->root().child("build"), "item");
    if (items.empty()) {
      throw bad(*root_, root_->root().child("build"), "there is nothing to build",
                "save it with its objects on the plate");
    }
    for (const Placed& item : items) add(item, Affine3d::Identity(), 0);
    content_.mesh = std::move(assembly_.mesh());
    content_.scale = root_->unit;
    add_notes();
    return std::move(content_);
  }

 private:
  system::FileError damaged(const std::string& part, const std::string& why) const {
    return {fmt::format("cannot read {}: {}", source_.name, part), why, "save it again as 3MF"};
  }

  /// Returns the error about an element, which is named with its identifier.
  InvalidArgument bad(const ModelPart& part, xml_node element, const std::string& why,
                      const std::string& remedy = {}) const {
    const xml_attribute own = element.attribute("id");
    const xml_attribute id = own ? own : element.attribute("objectid");
    const std::string name = element ? fmt::format(": <{}{}>", element.name(), stated(id)) : "";
    return {fmt::format("{}: {}{}", source_.name, part.name, name), why, remedy};
  }

  static std::string stated(xml_attribute attribute) {
    if (!attribute) return "";
    return fmt::format(" {}=\"{}\"", attribute.name(),
                       std::string_view(attribute.value()).substr(0, 80));
  }

  /// Finds a file of the archive. Their names are compared without case.
  const archive::ZipMember* member(std::string_view name) const {
    const std::string wanted = to_lower(name);
    const auto found = std::ranges::find(archive_.members(), wanted,
                                         [](const auto& one) { return to_lower(one.name); });
    return found == archive_.members().end() ? nullptr : &*found;
  }

  std::string unpack(const archive::ZipMember& member) {
    if (member.size > most_unpacked - unpacked_) {
      throw system::FileError(
          "cannot read " + source_.name,
          fmt::format("its models have more than {} bytes when unpacked", most_unpacked),
          "save it with fewer triangles, or as binary STL");
    }
    unpacked_ += static_cast<std::size_t>(member.size);
    // With the byte beyond, the checksum is compared.
    std::string text(static_cast<std::size_t>(member.size) + 1, '\0');
    const std::size_t got = archive_.open(member).read(text.data(), text.size());
    if (got != member.size)
      throw damaged(member.name, fmt::format("it has no {} bytes", member.size));
    text.pop_back();
    return text;
  }

  /// Parses the text in place. Only the five entities of XML are expanded.
  void parse(std::string& text, const std::string& name, pugi::xml_document& document) const {
    if (std::ranges::count(text, '<') > most_elements) {
      throw system::FileError(fmt::format("cannot read {}: {}", source_.name, name),
                              fmt::format("it has more than {} elements", most_elements),
                              "save it with fewer triangles, or as binary STL");
    }
    const pugi::xml_parse_result parsed = document.load_buffer_inplace(text.data(), text.size());
    if (parsed) return;
    throw damaged(name, fmt::format("the XML document is cut off or damaged at byte {}: {}",
                                    parsed.offset, to_lower(parsed.description())));
  }

  /// Returns the name of the file with the build.
  std::string root_name() {
    if (const archive::ZipMember* relations = member("_rels/.rels")) {
      std::string text = unpack(*relations);
      pugi::xml_document document;
      parse(text, relations->name, document);
      for (const xml_node relation : document.document_element().children("Relationship")) {
        if (std::string_view(relation.attribute("Type").value()).ends_with("/3dmodel"))
          return relation.attribute("Target").value();
      }
    }
    throw system::FileError("cannot read " + source_.name, "it is a ZIP archive without a 3D model",
                            "save it in OBJ, STL, PLY, glTF, COLLADA or 3MF");
  }

  /// Returns a model file of the archive, which is read the first time.
  const ModelPart& part(std::string name) {
    if (name.starts_with('/')) name.erase(0, 1);
    const auto [at, is_new] = parts_.try_emplace(to_lower(name));
    ModelPart& part = at->second;
    if (!is_new) return part;
    part.name = name;
    const archive::ZipMember* found = member(name);
    if (!found) {
      throw system::FileError("cannot read " + source_.name,
                              fmt::format("the archive has no file '{}'", name.substr(0, 80)),
                              "save it again as 3MF");
    }
    part.text = unpack(*found);
    parse(part.text, name, part.document);
    if (part.root().name() != std::string_view("model"))
      throw damaged(name, fmt::format("it is no model: its root is <{}>", part.root().name()));
    require_readable(part);
    part.unit = unit_of(part);
    for (const xml_node object : part.root().child("resources").children("object")) {
      if (part.objects.emplace(object.attribute("id").value(), object).second) continue;
      throw bad(part, object, "another object has the same id", "give each object its own");
    }
    return part;
  }

  /// Throws if the file requires an extension that changes shapes and is not read.
  void require_readable(const ModelPart& part) const {
    for (const std::string& prefix :
         words_of(part.root().attribute("requiredextensions").value())) {
      const std::string_view uri = part.root().attribute(("xmlns:" + prefix).c_str()).value();
      const auto is_it = [&](std::string_view known) { return uri.starts_with(known); };
      if (std::ranges::any_of(known_extensions, is_it)) continue;
      throw InvalidArgument(
          fmt::format("{}: {}", source_.name, part.name),
          fmt::format("it needs the extension '{}', which is not read",
                      uri.empty() ? std::string_view(prefix) : uri.substr(0, 120)),
          "save its objects as meshes, without this extension");
    }
  }

  double unit_of(const ModelPart& part) const {
    const xml_attribute unit = part.root().attribute("unit");
    const std::string_view name = unit ? unit.value() : "millimeter";  // the default of 3MF
    const auto* const found = std::ranges::find(length_units, name, &LengthUnit::name);
    if (found != length_units.end()) return found->length;
    std::vector<std::string> names;
    for (const LengthUnit& known : length_units) names.emplace_back(known.name);
    throw unknown_name(fmt::format("{}: {}: unit", source_.name, part.name), name, names);
  }

  /// Adds an object with its components.
  void add(const Placed& placed, const Affine3d& outer, std::size_t depth) {
    assembly_.enter_node(depth);
    const Object& own = object(*placed.part, placed.object);
    if (!own.skipped_type.empty()) {
      ++skipped_[own.skipped_type];
      return;
    }
    const Affine3d transform = outer * placed.transform;
    assembly_.add(own.mesh, transform);
    for (const Placed& component : own.components) add(component, transform, depth + 1);
  }

  /// Returns an object, which is read the first time: it may be repeated any number of times.
  const Object& object(const ModelPart& part, xml_node element) {
    const auto [at, is_new] = objects_.try_emplace(element);
    Object& object = at->second;
    if (!is_new) return object;
    const xml_attribute type = element.attribute("type");
    const std::string_view name = type ? type.value() : "model";
    const xml_node mesh = element.child("mesh"), components = element.child("components");
    if (name != "model" && name != "solidsupport") {
      object.skipped_type = fmt::format("'{}'", name.substr(0, 40));
    } else if (mesh) {
      object.mesh = mesh_of(part, element, mesh);
    } else if (components) {
      object.components = placed_objects(part, components, "component");
    } else {
      throw bad(part, element, "it has neither a mesh nor components", "save it as a mesh");
    }
    return object;
  }

  /// Returns the objects that the children of an element name.
  std::vector<Placed> placed_objects(const ModelPart& from, xml_node parent, const char* kind) {
    std::vector<Placed> all;
    for (const xml_node reference : parent.children(kind)) {
      const ModelPart& in = part_of(from, reference);
      const auto found = in.objects.find(reference.attribute("objectid").value());
      if (found == in.objects.end())
        throw bad(from, reference, "there is no object with this id in " + in.name);
      all.push_back({&in, found->second, transform_of(from, reference)});
      if (in.unit != from.unit) all.back().transform.scale(in.unit / from.unit);
    }
    return all;
  }

  /// Returns the file of the object that an element names. Only the file with the build may name
  /// others, so that files never refer to each other in a circle.
  const ModelPart& part_of(const ModelPart& from, xml_node reference) {
    for (const xml_attribute attribute : reference.attributes()) {
      if (!std::string_view(attribute.name()).ends_with(":path")) continue;
      if (&from == root_) return part(attribute.value());
      throw bad(from, reference, "it refers to another file, which only the first one may do");
    }
    return from;
  }

  /// Returns the transform of an element: twelve numbers, the rows of a matrix that is multiplied
  /// by row vectors from the left.
  Affine3d transform_of(const ModelPart& part, xml_node element) const {
    Affine3d transform = Affine3d::Identity();
    const xml_attribute attribute = element.attribute("transform");
    if (!attribute) return transform;
    std::vector<double> numbers;
    for_each_word(std::string_view(attribute.value()), [&](std::string_view word) {
      numbers.push_back(finite_number(part, element, "its transform", word));
    });
    if (numbers.size() != 12) throw bad(part, element, "its transform has no 12 numbers");
    for (int i = 0; i < 12; ++i) transform(i % 3, i / 3) = numbers[i];
    return transform;
  }

  double finite_number(const ModelPart& part, xml_node element, const std::string& what,
                       std::string_view word) const {
    const auto number = real_number(word);
    if (number && std::isfinite(*number)) return *number;
    throw bad(part, element,
              fmt::format("{} has '{}', which is no finite number", what, word.substr(0, 40)));
  }

  body::TriangleMesh mesh_of(const ModelPart& part, xml_node object, xml_node element) {
    body::TriangleMesh mesh;
    for (const xml_node vertex : element.child("vertices").children("vertex"))
      mesh.vertices.push_back(vertex_of(part, object, vertex, mesh.vertices.size()));
    for (const xml_node triangle : element.child("triangles").children("triangle")) {
      mesh.triangles.push_back({corner_of(part, object, triangle.attribute("v1"), mesh),
                                corner_of(part, object, triangle.attribute("v2"), mesh),
                                corner_of(part, object, triangle.attribute("v3"), mesh)});
    }
    for (const xml_node other : element.children())
      if (std::string_view(other.name()).ends_with("beamlattice")) ++lattices_;
    return mesh;
  }

  Eigen::Vector3d vertex_of(const ModelPart& part, xml_node object, xml_node element,
                            std::size_t index) const {
    const auto coordinate = [&](const char* axis) {
      const std::string_view word = element.attribute(axis).value();
      const auto number = real_number(word);
      if (number && std::isfinite(*number)) return *number;
      return finite_number(part, object, fmt::format("vertex {}: {}", index, axis), word);
    };
    return {coordinate("x"), coordinate("y"), coordinate("z")};
  }

  std::uint32_t corner_of(const ModelPart& part, xml_node object, xml_attribute attribute,
                          const body::TriangleMesh& mesh) const {
    const std::string_view word = attribute.value();
    const auto number = whole_number(word);
    if (number && *number < mesh.vertices.size()) return *number;
    throw bad(part, object,
              fmt::format("triangle {}: it refers to vertex '{}', but there are {} vertices, from "
                          "0 on",
                          mesh.triangles.size(), word.substr(0, 40), mesh.vertices.size()));
  }

  void add_notes() {
    for (const auto& [type, count] : skipped_) {
      content_.notes.push_back(
          fmt::format("{} of its objects are of the type {}, and are left out", count, type));
    }
    if (lattices_ > 0)
      content_.notes.push_back(fmt::format("its {} beam lattices are left out", lattices_));
  }

  const Source& source_;
  archive::ZipArchive archive_;
  std::size_t unpacked_ = 0;
  std::map<std::string, ModelPart> parts_;  ///< by names in lower case
  const ModelPart* root_ = nullptr;
  std::map<xml_node, Object> objects_;
  Assembly assembly_;
  Content content_;
  std::map<std::string, std::uint64_t> skipped_;
  std::uint64_t lattices_ = 0;
};

}  // namespace

Content read_3mf(const Source& source) { return ThreeMfReader(source).read(); }

}  // namespace twrench::mesh
