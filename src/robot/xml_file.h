#pragma once

#include <twrench/base/error.h>

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "robot/robot.h"

namespace twrench::robot {

/// The greatest number of a geometry, in m or another unit of SI. No body is larger, and products
/// of such numbers do not overflow.
inline constexpr double largest_number = 1e30;

/// An XML file whose values know their place in its bytes.
class XmlFile {
 public:
  /// Throws system::FileError if the file cannot be read, is longer than 64 MiB, or is damaged, and
  /// InvalidArgument if elements are nested more than 200 deep.
  explicit XmlFile(const std::filesystem::path& file);
  /// The same with the bytes of the file.
  XmlFile(std::string text, const std::filesystem::path& file);
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  pugi::xml_node root() const { return document_.document_element(); }
  /// The bytes of the file.
  const std::string& text() const { return text_; }

  std::size_t line(const pugi::xml_node& node) const;
  /// Returns the place of an element in messages: "robot.urdf:12: inertia".
  std::string place(const pugi::xml_node& node) const;
  /// Returns the error about an element.
  InvalidArgument bad(const pugi::xml_node& node, const std::string& why,
                      const std::string& remedy = {}) const;

  /// Returns the value of an attribute. Throws InvalidArgument if the element lacks it.
  std::string_view required(const pugi::xml_node& node, const char* attribute) const;

  /// Returns the numbers of an attribute, or `count` times 0 if the element lacks it; NaN and
  /// infinity are numbers. Throws InvalidArgument unless there are as many as `count`.
  std::vector<Written> numbers(const pugi::xml_node& node, const char* attribute,
                               std::size_t count) const;
  /// The same for the text of an element.
  std::vector<Written> numbers(const pugi::xml_node& node, std::size_t count) const;
  /// Returns as many numbers as the attribute has, none if the element lacks it.
  std::vector<Written> numbers(const pugi::xml_node& node, const char* attribute) const;

  /// Throws InvalidArgument about the element if the number is not finite or too large.
  void require_in_range(const pugi::xml_node& node, const char* name, double number) const;

  /// Returns three numbers in this range of an attribute; nothing if the element lacks it.
  std::optional<Eigen::Vector3d> vector(const pugi::xml_node& node, const char* attribute) const;
  /// Returns a number in this range of an attribute; nothing if the element lacks it.
  std::optional<double> number(const pugi::xml_node& node, const char* attribute) const;

  /// Returns an attribute with its name and the white space before it; nothing if the element lacks
  /// it.
  std::optional<Span> span_of(const pugi::xml_node& node, const char* attribute) const;

 private:
  /// Returns the bytes of the file from which the parser made the value: it replaces references,
  /// and line ends of two bytes by those of one.
  std::string_view written(const char* value) const;
  std::vector<Written> parse(const pugi::xml_node& node, const std::string& name,
                             const char* value) const;
  std::vector<Written> exactly(std::vector<Written> numbers, const pugi::xml_node& node,
                               const std::string& name, std::size_t count) const;

  std::filesystem::path path_;
  std::string text_;
  /// The bytes in which the parser ends each value with a NUL, and replaces references. A value
  /// begins at the same byte as in the file.
  std::string parsed_;
  std::vector<std::size_t> line_ends_;
  pugi::xml_document document_;
};

}  // namespace twrench::robot
