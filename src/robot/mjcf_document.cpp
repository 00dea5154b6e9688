#include "robot/mjcf_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/words.h"

// The format is described at mujoco.readthedocs.io/en/stable/XMLreference.html.

namespace twrench::robot {
namespace {

namespace fs = std::filesystem;

/// Readers visit nested elements recursively.
constexpr std::size_t deepest_include = 100;

/// Adds the attributes of the element. A rotation replaces one of another kind.
void add_attributes(const Element& element, AttributeMap& attributes) {
  constexpr std::array<std::string_view, 4> rotations{"axisangle", "xyaxes", "zaxis", "euler"};
  for (const pugi::xml_attribute& attribute : element.node.attributes()) {
    if (std::ranges::find(rotations, attribute.name()) != rotations.end())
      for (const std::string_view rotation : rotations) attributes.erase(std::string(rotation));
    attributes.insert_or_assign(attribute.name(), element);
  }
}

std::size_t depth_of(pugi::xml_node node) {
  std::size_t depth = 0;
  for (; node.parent(); node = node.parent()) ++depth;
  return depth;
}

}  // namespace

MjcfDocument::MjcfDocument(const XmlFile& file) : file_(file) {
  sections_ = children({&file_, file_.root()});
}

std::vector<Element> MjcfDocument::children(const Element& parent) {
  std::vector<Element> result;
  append_children(parent, result);
  return result;
}

void MjcfDocument::append_children(const Element& parent, std::vector<Element>& children) {
  for (const pugi::xml_node& node : parent.node.children()) {
    if (node.type() != pugi::node_element) continue;
    const Element child{parent.file, node};
    if (child.name() != "include") {
      children.push_back(child);
      continue;
    }
    const XmlFile& file = include(child);
    append_children({&file, file.root()}, children);
  }
}

const XmlFile& MjcfDocument::include(const Element& element) {
  const fs::path path =
      file_.path().parent_path() / fs::path(element.file->required(element.node, "file"));
  const auto is_same = [&](const fs::path& other) {
    return fs::weakly_canonical(other) == fs::weakly_canonical(path);
  };
  const std::vector<fs::path> before = included();
  if (is_same(file_.path()) || std::ranges::any_of(before, is_same)) {
    throw element.bad(fmt::format("'{}' is included already", path.string()),
                      "include each file once, as MuJoCo requires");
  }
  const std::size_t depth = depths_[element.file] + depth_of(element.node);
  if (depth > deepest_include) {
    throw element.bad("included files are nested too deeply", "write the model as one file");
  }
  const XmlFile& file = included_.emplace_back(path);
  depths_[&file] = depth;
  return file;
}

std::vector<fs::path> MjcfDocument::included() const {
  std::vector<fs::path> paths;
  for (const XmlFile& file : included_) paths.push_back(file.path());
  return paths;
}

void MjcfDefaults::read(MjcfDocument& document, const Element& section) {
  if (const std::string name = section.node.attribute("class").value(); !name.empty()) {
    auto outermost = classes_.extract(outermost_);
    outermost.key() = outermost_ = name;
    classes_.insert(std::move(outermost));
  }
  read_into(document, section, outermost_);
}

void MjcfDefaults::read_into(MjcfDocument& document, const Element& section,
                             const std::string& name) {
  MjcfClass& own = classes_[name];
  std::vector<Element> nested;
  for (const Element& element : document.children(section)) {
    if (element.name() == "default") nested.push_back(element);
    const bool is_geom = element.name() == "geom";
    if (!is_geom && element.name() != "mesh") continue;
    add_attributes(element, is_geom ? own.geom : own.mesh);
    if (is_geom) read_size(element, own.geom_size);
  }
  for (const Element& element : nested) {
    const std::string inner(element.file->required(element.node, "class"));
    if (!classes_.emplace(inner, own).second) {
      throw element.bad(fmt::format("class '{}' is defined twice", inner), "rename one of them");
    }
    read_into(document, element, inner);
  }
}

const MjcfClass& MjcfDefaults::find(const Element& element, const std::string& name) const {
  const auto found = classes_.find(name.empty() ? outermost_ : name);
  if (found != classes_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, unused] : classes_) names.push_back(known);
  throw unknown_name(element.place() + ": class", name, names);
}

void read_size(const Element& geom, Eigen::Vector3d& size) {
  const std::vector<Written> numbers = geom.file->numbers(geom.node, "size");
  if (numbers.size() > 3) {
    throw geom.bad(fmt::format("size has {} numbers", numbers.size()), "a geom has at most three");
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
    size[static_cast<Eigen::Index>(i)] = numbers[i].value;
}

std::optional<Element> Attributes::holder(const char* attribute) const {
  if (own_.node.attribute(attribute)) return own_;
  if (defaults_ == nullptr) return std::nullopt;
  const auto found = defaults_->find(attribute);
  return found == defaults_->end() ? std::nullopt : std::optional(found->second);
}

std::string_view Attributes::text(const char* attribute) const {
  const auto element = holder(attribute);
  return element ? element->node.attribute(attribute).value() : "";
}

std::optional<double> Attributes::number(const char* attribute) const {
  const auto element = holder(attribute);
  return element ? element->file->number(element->node, attribute) : std::nullopt;
}

std::optional<Eigen::Vector3d> Attributes::vector(const char* attribute) const {
  const auto element = holder(attribute);
  return element ? element->file->vector(element->node, attribute) : std::nullopt;
}

}  // namespace twrench::robot
