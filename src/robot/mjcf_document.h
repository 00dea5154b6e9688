#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "robot/xml_file.h"

namespace twrench::robot {

/// An element with the file that it is in.
struct Element {
  const XmlFile* file = nullptr;
  pugi::xml_node node = {};

  std::string_view name() const { return node.name(); }
  std::string place() const { return file->place(node); }
  InvalidArgument bad(const std::string& why, const std::string& remedy = {}) const {
    return file->bad(node, why, remedy);
  }
};

/// An MJCF file with the files that it includes.
class MjcfDocument {
 public:
  /// Throws as children() does.
  explicit MjcfDocument(const XmlFile& file);

  /// Returns the elements of the root, such as <worldbody>.
  const std::vector<Element>& sections() const { return sections_; }

  /// Returns the elements in an element, with those of included files instead of <include>. Call it
  /// once for each element. Throws InvalidArgument about an <include> without a file or of a file
  /// that was included before, and as XmlFile does.
  std::vector<Element> children(const Element& parent);

  /// Returns whether the element is in the file itself.
  bool is_own(const Element& element) const { return element.file == &file_; }

  /// Returns the files that were included.
  std::vector<std::filesystem::path> included() const;

 private:
  void append_children(const Element& parent, std::vector<Element>& children);
  const XmlFile& include(const Element& element);

  const XmlFile& file_;
  std::deque<XmlFile> included_;
  /// How deep the roots of the files are in the whole document.
  std::map<const XmlFile*, std::size_t> depths_;
  std::vector<Element> sections_;
};

/// Elements that have an attribute, by its name.
using AttributeMap = std::map<std::string, Element, std::less<>>;

/// A class of defaults.
struct MjcfClass {
  AttributeMap geom, mesh;
  /// The sizes of geoms, which elements replace from the first on, as far as they state them.
  Eigen::Vector3d geom_size = Eigen::Vector3d::Zero();
};

/// The classes of defaults of an MJCF file.
class MjcfDefaults {
 public:
  /// Reads a <default> of the root and those in it. Throws InvalidArgument about a class without a
  /// name or with that of another.
  void read(MjcfDocument& document, const Element& section);

  /// Returns a class, the outermost one if the name is empty. Throws InvalidArgument about the
  /// element, with the nearest name, if there is none.
  const MjcfClass& find(const Element& element, const std::string& name) const;

 private:
  void read_into(MjcfDocument& document, const Element& section, const std::string& name);

  std::string outermost_ = "main";
  std::map<std::string, MjcfClass> classes_{{"main", {}}};
};

/// Replaces the sizes from the first on with those of the element.
void read_size(const Element& geom, Eigen::Vector3d& size);

/// The attributes of an element, and those of its class that it lacks.
class Attributes {
 public:
  explicit Attributes(const Element& own) : own_(own) {}
  Attributes(const Element& own, const AttributeMap& defaults) : own_(own), defaults_(&defaults) {}

  const Element& own() const { return own_; }

  /// Returns the element that states the attribute; nothing if there is none.
  std::optional<Element> holder(const char* attribute) const;

  /// Returns its text, empty if there is none.
  std::string_view text(const char* attribute) const;
  bool is_true(const char* attribute) const { return text(attribute) == "true"; }
  /// Returns its finite numbers. Throws InvalidArgument if they are others.
  std::optional<double> number(const char* attribute) const;
  std::optional<Eigen::Vector3d> vector(const char* attribute) const;

 private:
  Element own_;
  const AttributeMap* defaults_ = nullptr;
};

}  // namespace twrench::robot
