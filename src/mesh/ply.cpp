#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/enumeration.h"
#include "mesh/formats.h"
#include "mesh/line_reader.h"
#include "mesh/polygon.h"

namespace twrench::mesh {
namespace {

/// The types of numbers in PLY files.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type{};
  /// For a list, the type of its entry count.
  std::optional<PlyType> count_type;
};

/// Items of one kind, such as vertices.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  enum class Format { text, little_endian, big_endian };
  Format format = Format::text;
  std::vector<PlyElement> elements;
};

struct TypeName {
  PlyType type;
  std::string_view name, other_name;
  std::size_t bytes;
};

constexpr std::array type_names{TypeName{PlyType::int8, "char", "int8", 1},
                                TypeName{PlyType::uint8, "uchar", "uint8", 1},
                                TypeName{PlyType::int16, "short", "int16", 2},
                                TypeName{PlyType::uint16, "ushort", "uint16", 2},
                                TypeName{PlyType::int32, "int", "int32", 4},
                                TypeName{PlyType::uint32, "uint", "uint32", 4},
                                TypeName{PlyType::float32, "float", "float32", 4},
                                TypeName{PlyType::float64, "double", "float64", 8}};

static_assert(has_row_for_each(type_names, &TypeName::type));

PlyType read_type(LineReader& lines) {
  const std::string_view word = lines.word();
  for (const TypeName& known : type_names) {
    if (word == known.name || word == known.other_name) return known.type;
  }
  throw lines.bad(fmt::format("{} is no type of PLY", shown(word)));
}

PlyHeader::Format read_format(LineReader& lines) {
  const std::string_view word = lines.word();
  if (word == "ascii") return PlyHeader::Format::text;
  if (word == "binary_little_endian") return PlyHeader::Format::little_endian;
  if (word == "binary_big_endian") return PlyHeader::Format::big_endian;
  throw lines.bad(fmt::format("{} is no format of PLY", shown(word)));
}

PlyElement read_element(LineReader& lines) {
  PlyElement element;
  element.name = lines.word();
  const std::string_view count = lines.word();
  const auto [stop, error] =
      std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (error == std::errc() && stop == count.data() + count.size()) return element;
  throw lines.bad(fmt::format("{} is no number of elements", shown(count)));
}

PlyProperty read_property(LineReader& lines) {
  PlyProperty property;
  LineReader after = lines;
  if (after.word() == "list") {
    lines = after;
    property.count_type = read_type(lines);
  }
  property.type = read_type(lines);
  property.name = lines.word();
  return property;
}

/// Returns the size in bytes of a number of the type in a binary file.
std::size_t size_of(PlyType type) {
  return std::ranges::find(type_names, type, &TypeName::type)->bytes;
}

/// Reads the header and leaves the lines that follow it. Throws system::FileError if it is damaged.
PlyHeader read_ply_header(LineReader& lines) {
  PlyHeader header;
  bool has_format = false;
  lines.next();
  if (lines.word() != "ply") throw lines.bad("a PLY file begins with 'ply'");
  while (lines.next()) {
    const std::string_view keyword = lines.word();
    if (keyword == "end_header") {
      if (has_format) return header;
      throw lines.bad("the header has no 'format' line");
    }
    if (keyword == "format") {
      header.format = read_format(lines);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(lines));
    } else if (keyword == "property") {
      if (header.elements.empty()) throw lines.bad("a property before the first element");
      header.elements.back().properties.push_back(read_property(lines));
    } else if (keyword != "comment" && keyword != "obj_info") {
      throw lines.bad(fmt::format("{} is no keyword of a PLY header", shown(keyword)));
    }
  }
  throw system::FileError(lines.place(), "the file is cut off: its header does not end");
}

system::FileError cut_off(const std::string& name, const std::string& why) {
  return {"cannot read " + name, "it is cut off: " + why};
}

/// Reads the numbers that follow the header, one by one.
class PlyNumbers {
 public:
  /// An item of an element.
  struct Item {
    const PlyElement* element;
    std::uint64_t index;
  };

  PlyNumbers(std::string name, PlyHeader::Format format, LineReader lines)
      : name_(std::move(name)), format_(format), lines_(std::move(lines)), bytes_(lines_.rest()) {}

  bool is_text() const { return format_ == PlyHeader::Format::text; }

  /// Returns the number of unread bytes.
  std::size_t remaining() const { return is_text() ? lines_.rest().size() : bytes_.size(); }

  /// Returns whether more than blanks and line ends of a text follow.
  bool has_more() const {
    if (!is_text()) return !bytes_.empty();
    return lines_.rest().find_first_not_of(" \t\r\n") != std::string_view::npos;
  }

  /// Advances to an item of an element, which in a text file is the next line.
  void begin_item(const PlyElement& element, std::uint64_t index) {
    item_ = {&element, index};
    if (is_text() && !lines_.next()) throw missing_items();
  }

  /// Returns the item that is being read.
  const Item& item() const { return item_; }

  double next(PlyType type) {
    if (is_text()) return lines_.number();
    const std::size_t size = size_of(type);
    if (bytes_.size() < size) throw missing_items();
    const double value = binary(type);
    bytes_.remove_prefix(size);
    return value;
  }

 private:
  system::FileError missing_items() const {
    const PlyElement& element = *item_.element;
    return cut_off(name_, fmt::format("{} of {} '{}' are missing", element.count - item_.index,
                                      element.count, element.name));
  }

  double binary(PlyType type) const {
    const std::endian order =
        format_ == PlyHeader::Format::big_endian ? std::endian::big : std::endian::little;
    switch (type) {
      case PlyType::int8:
        return number_at<std::int8_t>(bytes_, 0, order);
      case PlyType::uint8:
        return number_at<std::uint8_t>(bytes_, 0, order);
      case PlyType::int16:
        return number_at<std::int16_t>(bytes_, 0, order);
      case PlyType::uint16:
        return number_at<std::uint16_t>(bytes_, 0, order);
      case PlyType::int32:
        return number_at<std::int32_t>(bytes_, 0, order);
      case PlyType::uint32:
        return number_at<std::uint32_t>(bytes_, 0, order);
      case PlyType::float32:
        return number_at<float>(bytes_, 0, order);
      case PlyType::float64:
        break;
    }
    return number_at<double>(bytes_, 0, order);
  }

  std::string name_;
  PlyHeader::Format format_;
  LineReader lines_;
  std::string_view bytes_;
  Item item_{};  ///< The item that is being read.
};

/// Returns the number of full intensity in a colour of the type.
double full_color(PlyType type) {
  if (type == PlyType::uint8) return 255.0;
  return type == PlyType::uint16 ? 65535.0 : 1.0;
}

/// Maps the properties of a vertex to x, y, z, red, green and blue.
struct VertexLayout {
  struct Slot {
    std::size_t index;  ///< Index among these six.
    double unit;        ///< Divisor.
  };

  explicit VertexLayout(const PlyElement& vertex) {
    static constexpr std::array<std::string_view, 6> names{"x", "y", "z", "red", "green", "blue"};
    for (const PlyProperty& property : vertex.properties) {
      const auto* const found = std::ranges::find(names, property.name);
      std::optional<Slot>& slot = slots.emplace_back();
      if (found == names.end() || property.count_type) continue;
      const auto index = static_cast<std::size_t>(found - names.begin());
      slot = Slot{index, index < 3 ? 1.0 : full_color(property.type)};
      found_[index] = true;
    }
  }

  bool is_complete() const { return found_[0] && found_[1] && found_[2]; }
  bool has_colors() const { return found_[3] && found_[4] && found_[5]; }

  /// One per property; nothing for an ignored property.
  std::vector<std::optional<Slot>> slots;

 private:
  std::array<bool, 6> found_{};
};

class PlyReader {
 public:
  explicit PlyReader(const Source& source)
      : name_(source.name),
        lines_(source.name, source.bytes),
        header_(read_ply_header(lines_)),
        numbers_(name_, header_.format, lines_) {
    const auto is_vertex = [](const PlyElement& element) { return element.name == "vertex"; };
    const auto vertex = std::ranges::find_if(header_.elements, is_vertex);
    if (vertex == header_.elements.end()) return;
    vertex_count_ = vertex->count;
    if (std::any_of(vertex + 1, header_.elements.end(), is_vertex)) {
      throw system::FileError("cannot read " + name_, "its header has two elements 'vertex'");
    }
  }

  Content read() {
    for (const PlyElement& element : header_.elements) {
      require_room(element);
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_corners(element, &PlyReader::read_ring);
      else if (element.name == "tristrips")
        read_corners(element, &PlyReader::read_strip);
      else
        skip(element);
    }
    polygons_.triangulate(mesh_);
    Content content{.mesh = std::move(mesh_)};
    if (numbers_.has_more()) {
      content.notes.push_back(
          fmt::format("the {} bytes after its last element are left out", numbers_.remaining()));
    }
    return content;
  }

 private:
  /// Throws if the rest of the file is too short for the count in the header, before memory is
  /// allocated.
  void require_room(const PlyElement& element) const {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties) {
      least += numbers_.is_text() ? 2 : size_of(property.count_type.value_or(property.type));
    }
    least = std::max<std::size_t>(least, 1);
    // The last line may lack its line end.
    if (element.count <= (numbers_.remaining() + 1) / least) return;
    throw cut_off(name_,
                  fmt::format("its header says that it has {} of '{}', for which {} bytes do "
                              "not suffice",
                              element.count, element.name, numbers_.remaining()));
  }

  void skip_property(const PlyProperty& property) {
    if (!property.count_type) {
      numbers_.next(property.type);
      return;
    }
    for (std::uint64_t n = count_of(property); n > 0; --n) numbers_.next(property.type);
  }

  void skip(const PlyElement& element) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      numbers_.begin_item(element, i);
      for (const PlyProperty& property : element.properties) skip_property(property);
    }
  }

  std::uint64_t count_of(const PlyProperty& list) {
    const double count = numbers_.next(*list.count_type);
    constexpr double most = std::numeric_limits<std::uint32_t>::max();
    if (count >= 0.0 && count <= most && count == std::floor(count)) {
      return static_cast<std::uint64_t>(count);
    }
    throw system::FileError("cannot read " + name_,
                            fmt::format("a list cannot have {} entries", count));
  }

  void read_vertices(const PlyElement& element) {
    const VertexLayout layout(element);
    if (!layout.is_complete()) {
      throw system::FileError("cannot read " + name_, "its vertices have no x, y and z");
    }
    std::array<double, 6> values{};
    mesh_.vertices.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      numbers_.begin_item(element, i);
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (const auto& slot = layout.slots[p]) {
          values[slot->index] = numbers_.next(element.properties[p].type) / slot->unit;
        } else {
          skip_property(element.properties[p]);
        }
      }
      add_vertex(values, layout.has_colors());
    }
  }

  void add_vertex(const std::array<double, 6>& values, bool has_color) {
    const auto& [x, y, z, red, green, blue] = values;
    mesh_.vertices.emplace_back(x, y, z);
    if (!mesh_.vertices.back().allFinite()) {
      throw InvalidArgument(fmt::format("{}: vertex {}", name_, mesh_.vertices.size() - 1),
                            "a coordinate is not a finite number");
    }
    const auto part = [](double value) {
      return value > 0.0 ? static_cast<float>(std::min(value, 1.0)) : 0.0F;
    };
    if (has_color) mesh_.colors.push_back({part(red), part(green), part(blue)});
  }

  /// Reads the lists of vertices of an element with `read_list`.
  void read_corners(const PlyElement& element, void (PlyReader::*read_list)(const PlyProperty&)) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      numbers_.begin_item(element, i);
      for (const PlyProperty& property : element.properties) {
        const bool has_corners = property.count_type && (property.name == "vertex_indices" ||
                                                         property.name == "vertex_index");
        if (has_corners)
          (this->*read_list)(property);
        else
          skip_property(property);
      }
    }
  }

  void read_ring(const PlyProperty& property) {
    const std::uint64_t count = count_of(property);
    ring_.clear();
    for (std::uint64_t k = 0; k < count; ++k) ring_.push_back(index(numbers_.next(property.type)));
    if (count < 3) throw InvalidArgument(item_place(), "a face has three corners at least");
    polygons_.add(ring_, mesh_);
  }

  /// Reads strips of triangles, separated by -1. Every other triangle of a strip is turned over.
  void read_strip(const PlyProperty& property) {
    ring_.clear();
    for (std::uint64_t n = count_of(property); n > 0; --n) {
      const double number = numbers_.next(property.type);
      if (number == -1.0) {
        ring_.clear();
        continue;
      }
      ring_.push_back(index(number));
      if (ring_.size() < 3) continue;
      const auto* const last = &ring_.back();
      const bool is_turned = ring_.size() % 2 == 0;
      mesh_.triangles.push_back({last[is_turned ? -1 : -2], last[is_turned ? -2 : -1], last[0]});
    }
  }

  std::uint32_t index(double number) const {
    if (number >= 0.0 && number < static_cast<double>(vertex_count_) &&
        number == std::floor(number)) {
      return static_cast<std::uint32_t>(number);
    }
    throw InvalidArgument(
        item_place(), fmt::format("it refers to vertex {}, but there are {} vertices, from 0 on",
                                  number, vertex_count_));
  }

  /// Returns the place of the item for messages: "a.ply: face 7".
  std::string item_place() const {
    return fmt::format("{}: {} {}", name_, numbers_.item().element->name, numbers_.item().index);
  }

  std::string name_;
  LineReader lines_;
  PlyHeader header_;
  PlyNumbers numbers_;
  std::uint64_t vertex_count_ = 0;
  body::TriangleMesh mesh_;
  std::vector<std::uint32_t> ring_;
  Polygons polygons_;
};

}  // namespace

Content read_ply(const Source& source) { return PlyReader(source).read(); }

}  // namespace twrench::mesh
