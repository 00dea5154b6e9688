#include "table/npy_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "system/error.h"

namespace twrench::table {
namespace {

using nlohmann::json;

constexpr std::size_t max_header_bytes = 1 << 16;
constexpr std::uint64_t max_columns = 100'000;
constexpr std::uint64_t max_row_bytes = 1 << 24;

system::FileError bad_npy(const Input& input, const std::string& why,
                          const std::string& remedy = {}) {
  return {input.name(), why, remedy};
}

system::FileError unreadable_header(const Input& input) {
  return bad_npy(input, "the header of this NumPy file cannot be read",
                 "write it again with numpy.save");
}

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    value = value << 8U | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

/// The text of the header, and where the numbers begin.
struct HeaderText {
  std::string text;
  std::uint64_t end;
};

HeaderText read_header_text(const Input& input) {
  constexpr std::size_t magic = 8;  // "\x93NUMPY", the version
  std::array<char, magic + 4> first{};
  const std::size_t got = input.read(0, first.data(), first.size());
  const std::string_view start(first.data(), got);
  if (got < first.size()) throw unreadable_header(input);
  const char version = start[6];
  if (version < 1 || version > 3) {
    throw bad_npy(input, fmt::format("it is a NumPy file of version {}, which is not known",
                                     static_cast<int>(version)));
  }
  const std::size_t size_bytes = version == 1 ? 2 : 4;
  const std::uint64_t size = little_endian(start.substr(magic, size_bytes));
  const std::uint64_t begin = magic + size_bytes;
  if (size > max_header_bytes) throw unreadable_header(input);
  HeaderText header{std::string(static_cast<std::size_t>(size), '\0'), begin + size};
  if (input.read(begin, header.text.data(), header.text.size()) < size) {
    throw unreadable_header(input);
  }
  return header;
}

/// Parses the header, a Python literal that differs from JSON in its brackets and words. Returns
/// null if it cannot be read.
json parse_literal(std::string_view python) {
  std::string text;
  char quote = '\0';
  const auto close = [&](char bracket) {
    if (text.ends_with(',')) text.pop_back();  // Python allows it there
    text += bracket;
  };
  for (std::size_t i = 0; i < python.size(); ++i) {
    const char c = python[i];
    if (quote != '\0') {
      if (c == '\\' && i + 1 < python.size()) {
        if (python[i + 1] != '\'') text += c;
        text += python[++i];
        continue;
      }
      text += c == quote ? "\"" : c == '"' ? "\\\"" : std::string(1, c);
      if (c == quote) quote = '\0';
    } else if (c == '\'' || c == '"') {
      quote = c;
      text += '"';
    } else if (c == '(' || c == '[') {
      text += '[';
    } else if (c == ')' || c == ']') {
      close(']');
    } else if (c == '}') {
      close('}');
    } else if (c == 'T' || c == 'F') {
      text += c == 'T' ? 't' : 'f';  // True, False
    } else if (c != ' ' && c != '\n') {
      text += c;
    }
  }
  json value = json::parse(text, nullptr, false);
  return value.is_discarded() ? json() : value;
}

std::optional<std::vector<std::uint64_t>> read_shape(const json& shape) {
  if (!shape.is_array()) return std::nullopt;
  std::vector<std::uint64_t> sizes;
  for (const json& size : shape) {
    if (!size.is_number_unsigned()) return std::nullopt;
    sizes.push_back(size.get<std::uint64_t>());
  }
  return sizes;
}

/// Lays out the columns of one row, one after another.
class RowLayout {
 public:
  explicit RowLayout(const Input& input) : input_(&input) {}

  const std::vector<NpyColumn>& columns() const { return columns_; }
  std::uint64_t row_bytes() const { return row_bytes_; }

  /// Adds the field, whose type is a text ("<f8") or a list of fields.
  void add(const std::string& name, const json& type, int depth) {
    if (type.is_string()) return add_scalar(name, type.get<std::string>());
    if (!type.is_array() || depth > 8) throw unreadable_header(*input_);
    for (const json& field : type) {
      if (!field.is_array() || field.size() < 2 || field.size() > 3) {
        throw unreadable_header(*input_);
      }
      const std::string full =
          name.empty() ? field_name(field[0]) : name + "." + field_name(field[0]);
      add_array(full, field[1], field.size() == 3 ? field[2] : json::array(), 0, depth + 1);
    }
  }

  /// Adds one field for each element of a sub-array of this shape.
  void add_array(const std::string& name, const json& type, const json& shape, std::size_t axis,
                 int depth) {
    const auto sizes = read_shape(shape.is_number() ? json::array({shape}) : shape);
    if (!sizes || sizes->size() > 4) throw unreadable_header(*input_);
    // Also counts elements without numbers: sizes of 0, and structures without fields.
    if (++elements_ > 2 * max_columns) throw too_wide();
    if (axis == sizes->size()) return add(name, type, depth);
    for (std::uint64_t i = 0; i < (*sizes)[axis]; ++i) {
      add_array(fmt::format("{}[{}]", name, i), type, shape, axis + 1, depth);
    }
  }

 private:
  system::FileError too_wide() const {
    return bad_npy(*input_, fmt::format("it has more than {} columns", max_columns));
  }

  /// A name, or a pair of title and name.
  std::string field_name(const json& name) const {
    const json& text = name.is_array() && name.size() == 2 ? name[1] : name;
    if (!text.is_string()) throw unreadable_header(*input_);
    return text.get<std::string>();
  }

  void add_scalar(const std::string& name, const std::string& type) {
    if (type.find('O') != std::string::npos) {
      throw bad_npy(*input_, "it holds Python objects, which only Python can read",
                    "save it as an array of numbers: array.astype(float)");
    }
    // "<f8"; the characters of "<U5" take 4 bytes each, and "<M8[ns]" has a unit after its size.
    std::uint64_t size = 0;
    const char* end = type.data() + type.size();
    const auto read =
        std::from_chars(type.data() + std::min<std::size_t>(type.size(), 2), end, size);
    if (read.ec != std::errc{} || size > max_row_bytes) throw unreadable_header(*input_);
    columns_.push_back({name, type, row_bytes_, 0});
    row_bytes_ += type[1] == 'U' ? 4 * size : size;
    if (columns_.size() > max_columns || row_bytes_ > max_row_bytes) throw too_wide();
  }

  const Input* input_;
  std::vector<NpyColumn> columns_;
  std::uint64_t row_bytes_ = 0;
  std::uint64_t elements_ = 0;
};

/// Sets the position of each column in the file.
NpyHeader place_columns(const RowLayout& layout, std::uint64_t rows, bool by_columns,
                        std::uint64_t begin) {
  NpyHeader header{layout.columns(), rows};
  for (NpyColumn& column : header.columns) {
    const std::uint64_t size = layout.row_bytes() / header.columns.size();
    column.step = by_columns ? size : layout.row_bytes();
    column.begin = begin + (by_columns ? column.begin * rows : column.begin);
  }
  return header;
}

/// The header of an array, as NumPy writes it.
struct ArrayHeader {
  std::vector<std::uint64_t> shape;
  json type;
  bool fortran_order;
  std::uint64_t end;  ///< where the numbers begin
};

ArrayHeader read_array_header(const Input& input) {
  const HeaderText text = read_header_text(input);
  const json header = parse_literal(text.text);
  if (!header.is_object() || !header.contains("descr") || !header.contains("shape")) {
    throw unreadable_header(input);
  }
  const auto shape = read_shape(header["shape"]);
  if (!shape) throw unreadable_header(input);
  const auto order = header.find("fortran_order");
  return {*shape, header["descr"], order != header.end() && *order == json(true), text.end};
}

/// Throws unless the numbers take `size` bytes at most.
void require_rows(const Input& input, const RowLayout& layout, std::uint64_t rows,
                  std::uint64_t size) {
  if (layout.row_bytes() == 0) throw bad_npy(input, "it has no columns");
  if (rows <= size / layout.row_bytes()) return;
  throw bad_npy(
      input,
      fmt::format("it is cut off: {} rows of {} bytes are due, but only {} bytes are there", rows,
                  layout.row_bytes(), size),
      "write it again");
}

/// Exchanges the positions of columns that are stored with the first index fastest, as they are
/// named with the last one fastest.
void transpose(std::vector<NpyColumn>& columns, std::span<const std::uint64_t> shape) {
  const std::vector<NpyColumn> stored = columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::uint64_t rest = i, place = 0;
    std::vector<std::uint64_t> indices(shape.size());
    for (std::size_t k = shape.size(); k-- > 0; rest /= shape[k]) indices[k] = rest % shape[k];
    for (std::size_t k = shape.size(); k-- > 0;) place = place * shape[k] + indices[k];
    columns[i].begin = stored[static_cast<std::size_t>(place)].begin;
  }
}

}  // namespace

NpyHeader read_npy_header(const Input& input) {
  const auto [shape, type, fortran_order, end] = read_array_header(input);
  const bool is_table = shape.size() == (type.is_array() ? 1 : 2);
  if (!is_table) {
    throw bad_npy(input, fmt::format("the NumPy array has {} dimensions", shape.size()),
                  "rows and columns are wanted: two dimensions, or one of a structured array");
  }
  RowLayout layout(input);
  if (type.is_array()) {
    layout.add("", type, 0);
  } else {
    const std::uint64_t count = shape[1];
    if (count > max_columns) throw bad_npy(input, fmt::format("it has {} columns", count));
    for (std::uint64_t i = 1; i <= count; ++i) layout.add(fmt::format("#{}", i), type, 0);
  }
  require_rows(input, layout, shape.front(), input.size() - end);
  return place_columns(layout, shape.front(), fortran_order && !type.is_array(), end);
}

std::optional<NpyHeader> read_npy_member(const Input& start, std::uint64_t size,
                                         const std::string& name) {
  const auto [shape, type, fortran_order, end] = read_array_header(start);
  const bool has_objects = type.dump().find('O') != std::string::npos;
  if (shape.empty() || has_objects) return std::nullopt;
  RowLayout layout(start);
  const std::vector<std::uint64_t> rest(shape.begin() + 1, shape.end());
  layout.add_array(name, type, json(rest), 0, 0);
  if (size < end) throw unreadable_header(start);
  require_rows(start, layout, shape.front(), size - end);
  if (shape.front() * layout.row_bytes() != size - end) {
    throw bad_npy(
        start,
        fmt::format("{} bytes follow the array", size - end - shape.front() * layout.row_bytes()),
        "write it again with numpy.savez");
  }
  const bool by_columns = fortran_order && !type.is_array();
  NpyHeader header = place_columns(layout, shape.front(), by_columns, end);
  if (by_columns) transpose(header.columns, rest);
  return header;
}

}  // namespace twrench::table
