#include <fmt/format.h>

#include <map>
#include <string>

#include "robot/compiled.h"
#include "robot/formats.h"
#include "robot/mjcf_compiler.h"
#include "robot/mjcf_document.h"
#include "robot/mjcf_geometry.h"

namespace twrench::robot {
namespace {

constexpr const char* one_file =
    "give the file with the bodies itself, or write the model as one file, as MuJoCo's program "
    "does: compile ROBOT.xml WHOLE.xml";

/// Reads the bodies of an MJCF file.
class MjcfReader {
 public:
  MjcfReader(const XmlFile& file, Robot& robot) : file_(file), robot_(robot), document_(file) {}

  void read();

 private:
  /// The surroundings of an element.
  struct Scope {
    std::size_t link;
    /// Whether it is a body, not the world.
    bool is_body = false;
    std::string childclass = {};
    Eigen::Isometry3d body_from_frame = Eigen::Isometry3d::Identity();
  };

  /// The geoms and the inertial of a body, and whether it moves relative to its parent.
  struct Contents {
    std::vector<MjcfGeom> geoms = {};
    std::optional<Inertial> inertial = {};
    bool has_joint = false;
  };

  void read_children(const Element& parent, const Scope& scope, Contents& contents);
  void read_body(const Element& element, const Scope& outer);
  void read_frame(const Element& element, const Scope& outer, Contents& contents);
  void read_geom(const Element& element, const Scope& scope, Contents& contents);
  void read_inertial(const Element& element, const Scope& scope, Contents& contents);
  std::array<Written, 6> entries_of(const Element& element);
  void finish(const Contents& contents, Link& link);
  void set_mass(const Attributes& geom, Geometry& geometry);
  std::string name_of_body(const Element& element);
  bool counts(const Attributes& geom) const;

  const XmlFile& file_;
  Robot& robot_;
  MjcfDocument document_;
  MjcfCompiler compiler_;
  MjcfDefaults defaults_;
  MjcfMeshes meshes_;
  std::map<std::size_t, int> unnamed_;  ///< The number of bodies without a name in a line.
};

void MjcfReader::read() {
  const auto for_each = [&](std::string_view name, const auto& visit) {
    for (const Element& section : document_.sections())
      if (section.name() == name) visit(section);
  };
  for_each("compiler", [&](const Element& e) { read_compiler(e, compiler_, robot_.notes); });
  for_each("default", [&](const Element& e) { defaults_.read(document_, e); });
  for_each("asset", [&](const Element& section) {
    for (const Element& e : document_.children(section))
      if (e.name() == "mesh") read_mjcf_mesh(e, defaults_, compiler_, meshes_, robot_.notes);
  });
  Contents world;
  for_each("worldbody", [&](const Element& e) { read_children(e, {}, world); });
  robot_.name = file_.root().attribute("model").value();
  robot_.mesh_folder = file_.path().parent_path() / compiler_.mesh_folder;
  robot_.compiler = compiler_.settings;
  robot_.others = document_.included();
  for (std::string& fault : hidden_faults(robot_)) robot_.notes.push_back(std::move(fault));
}

void MjcfReader::read_children(const Element& parent, const Scope& scope, Contents& contents) {
  for (const Element& element : document_.children(parent)) {
    const std::string_view name = element.name();
    if (name == "body") {
      read_body(element, scope);
    } else if (name == "frame") {
      read_frame(element, scope, contents);
    } else if (name == "geom" && scope.is_body) {
      read_geom(element, scope, contents);
    } else if (name == "inertial" && scope.is_body) {
      read_inertial(element, scope, contents);
    } else if (name == "joint" || name == "freejoint") {
      contents.has_joint = true;
    } else if (name == "replicate" || name == "attach" || name == "composite" ||
               name == "flexcomp") {
      robot_.notes.push_back(
          fmt::format("{}: <{}> and the bodies that it makes are ignored", element.place(), name));
    }
  }
}

void MjcfReader::read_body(const Element& element, const Scope& outer) {
  if (!document_.is_own(element))
    throw element.bad("it is in an included file, but only bodies of the file itself are read",
                      one_file);
  const std::size_t index = robot_.links.size();
  robot_.links.push_back({.name = name_of_body(element), .line = element.file->line(element.node)});
  if (outer.is_body) robot_.links.back().parent = robot_.links[outer.link].name;
  const std::string childclass = element.node.attribute("childclass").value();
  Contents contents;
  read_children(element, {index, true, childclass.empty() ? outer.childclass : childclass},
                contents);
  if (!contents.has_joint) {
    robot_.links[index].is_fixed = true;
    if (outer.is_body) robot_.links[outer.link].is_fixed = true;
  }
  finish(contents, robot_.links[index]);
}

void MjcfReader::read_frame(const Element& element, const Scope& outer, Contents& contents) {
  Scope scope = outer;
  scope.body_from_frame = outer.body_from_frame * pose_of(Attributes(element), compiler_);
  if (const std::string childclass = element.node.attribute("childclass").value();
      !childclass.empty())
    scope.childclass = childclass;
  read_children(element, scope, contents);
}

void MjcfReader::read_geom(const Element& element, const Scope& scope, Contents& contents) {
  const std::string own = element.node.attribute("class").value();
  const MjcfClass& defaults = defaults_.find(element, own.empty() ? scope.childclass : own);
  contents.geoms.push_back({element, scope.body_from_frame, &defaults});
}

void MjcfReader::read_inertial(const Element& element, const Scope& scope, Contents& contents) {
  const XmlFile& file = *element.file;
  if (!document_.is_own(element))
    throw element.bad("it is in an included file, but only numbers of the file itself are read",
                      one_file);
  if (contents.inertial) throw element.bad("its body has another one", "remove one of them");
  if (!scope.body_from_frame.isApprox(Eigen::Isometry3d::Identity(), 0.0))
    throw element.bad("it is in a <frame> with a pose", "move it out of the <frame>");
  for (const char* attribute : {"pos", "mass"}) file.required(element.node, attribute);
  Inertial inertial;
  inertial.line = file.line(element.node);
  inertial.mass = file.numbers(element.node, "mass", 1).front();
  std::ranges::copy(file.numbers(element.node, "pos", 3), inertial.centre.begin());
  inertial.link_from_inertial = rotation_of(Attributes(element), compiler_);
  inertial.entries = entries_of(element);
  inertial.diagonal = file.span_of(element.node, "diaginertia");
  for (const char* attribute : rotation_attributes)
    if (const auto span = file.span_of(element.node, attribute))
      inertial.rotations.push_back(*span);
  contents.inertial = inertial;
}

std::array<Written, 6> MjcfReader::entries_of(const Element& element) {
  const XmlFile& file = *element.file;
  const auto has = [&](const char* name) { return !element.node.attribute(name).empty(); };
  std::array<Written, 6> entries;
  if (!has("fullinertia")) {
    if (!has("diaginertia"))
      robot_.notes.push_back(element.place() + ": it has neither diaginertia nor fullinertia");
    std::ranges::copy(file.numbers(element.node, "diaginertia", 3), entries.begin());
    return entries;
  }
  if (has("diaginertia") || std::ranges::any_of(rotation_attributes, has)) {
    throw element.bad("fullinertia excludes diaginertia and a rotation",
                      "remove the attributes of one of them");
  }
  std::ranges::copy(file.numbers(element.node, "fullinertia", 6), entries.begin());
  return entries;
}

void MjcfReader::finish(const Contents& contents, Link& link) {
  using FromGeoms = MjcfCompiler::FromGeoms;
  link.inertial = contents.inertial;
  const bool follows = compiler_.from_geoms == FromGeoms::always ||
                       (compiler_.from_geoms == FromGeoms::automatically && !link.inertial);
  link.is_from_geometry = follows && std::ranges::any_of(contents.geoms, [&](const MjcfGeom& geom) {
                            return counts(geom.attributes());
                          });
  for (const MjcfGeom& geom : contents.geoms) {
    auto geometry = geometry_of(geom, meshes_, compiler_, robot_.notes);
    if (!geometry) continue;
    const Attributes attributes = geom.attributes();
    const bool collides = attributes.number("contype").value_or(1.0) != 0.0 ||
                          attributes.number("conaffinity").value_or(1.0) != 0.0;
    geometry->use =
        link.is_from_geometry || collides ? Geometry::Use::collision : Geometry::Use::visual;
    if (link.is_from_geometry) set_mass(attributes, *geometry);
    link.geometries.push_back(std::move(*geometry));
  }
  if (link.is_from_geometry && link.inertial) {
    robot_.notes.push_back(fmt::format(
        "{}:{}: body '{}': inertiafromgeom=\"true\" replaces its <inertial> by that of its geoms",
        file_.path().string(), link.inertial->line, link.name));
  }
}

/// The masses of geoms count only in a body whose mass properties follow from them.
void MjcfReader::set_mass(const Attributes& geom, Geometry& geometry) {
  geometry.mass = geom.number("mass");
  if (!counts(geom)) geometry.mass = 0.0;
  if (!geometry.mass) geometry.density = geom.number("density").value_or(default_density);
  if (geometry.mass.value_or(0.0) < 0.0 || geometry.density.value_or(0.0) < 0.0)
    throw geom.own().bad("its mass or density is negative", "masses are positive");
}

/// Returns whether the geom has a mass and is in one of the groups that make up the mass of bodies.
bool MjcfReader::counts(const Attributes& geom) const {
  const double group = geom.number("group").value_or(0.0);
  const double mass = geom.number("mass").value_or(geom.number("density").value_or(1.0));
  return mass != 0.0 && group >= compiler_.groups[0] && group <= compiler_.groups[1];
}

std::string MjcfReader::name_of_body(const Element& element) {
  const std::string name = element.node.attribute("name").value();
  if (!name.empty()) return name;
  const std::size_t line = element.file->line(element.node);
  const int count = ++unnamed_[line];
  return fmt::format("body at line {}{}", line, count == 1 ? "" : fmt::format(" ({})", count));
}

}  // namespace

void read_mjcf(const XmlFile& file, Robot& robot) { MjcfReader(file, robot).read(); }

}  // namespace twrench::robot
