#include "table/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "system/error.h"
#include "system/file_kind.h"
#include "table/aem_reader.h"
#include "table/aem_xml.h"
#include "table/ardupilot_log.h"
#include "table/csv_reader.h"
#include "table/error.h"
#include "table/input.h"
#include "table/json_reader.h"
#include "table/line_reader.h"
#include "table/npy_reader.h"
#include "table/npz_reader.h"
#include "table/opensim_quaternions.h"
#include "table/stk_attitude.h"
#include "table/utf16.h"
#include "table/vector_cells.h"
#include "table/yaml.h"

namespace twrench::table {
namespace {

/// The remedy for a file of this kind.
std::string remedy_for(std::string_view kind) {
  struct Remedy {
    std::string_view kind, text;
  };
  constexpr std::array<Remedy, 5> remedies{{
      {"compressed by gzip", "unpack it first: gunzip -k FILE"},
      {"compressed by bzip2", "unpack it first: bunzip2 -k FILE"},
      {"compressed by xz", "unpack it first: unxz -k FILE"},
      {"compressed by zstd", "unpack it first: unzstd FILE"},
      {"text in UTF-16, not in UTF-8", "save it as UTF-8: iconv -f UTF-16 -t UTF-8 FILE"},
  }};
  const auto* const found = std::ranges::find(remedies, kind, &Remedy::kind);
  return std::string(found != remedies.end()
                         ? found->text
                         : "CSV, TSV, JSON, AEM and NumPy's .npy and .npz are read");
}

/// Whether the first line has a separator between printable characters. The bytes that identify
/// some kinds of files may then be the name of a column, such as ID3.
bool begins_like_table(std::string_view start) {
  const std::string_view line = start.substr(0, start.find('\n'));
  const auto is_printable = [](char c) { return c >= ' ' && c <= '~'; };
  return line.find(',') != std::string_view::npos && std::ranges::all_of(line, is_printable);
}

/// Whether the text begins like rows in JSON: with an object, or with an array of objects or
/// arrays. A CSV table may begin with a name in brackets.
bool is_json(std::string_view text) {
  text = system::without_byte_order_mark(text);
  const auto take = [&] {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const char c = text.empty() ? '\0' : text.front();
    text.remove_prefix(text.empty() ? 0 : 1);
    return c;
  };
  const char first = take();
  if (first != '[') return first == '{';
  const char second = take();
  return second == '{' || second == '[' || second == ']';
}

std::unique_ptr<Reader> open_format(Input input) {
  std::array<char, 4096> bytes{};
  const std::string_view start(bytes.data(), input.read(0, bytes.data(), bytes.size()));
  if (has_utf16_mark(start)) return open_format(utf8_from_utf16(input));
  if (start.starts_with("\x93NUMPY")) return std::make_unique<NpyReader>(std::move(input));
  if (start.starts_with("PK\x03\x04")) return std::make_unique<NpzReader>(std::move(input));
  if (is_xml(start)) return std::make_unique<AemReader>(aem_from_xml(input), true);
  const auto kind = system::recognized_file_kind(start);
  if (kind && !begins_like_table(start)) {
    throw system::FileError(input.name(), fmt::format("the file is {}", *kind), remedy_for(*kind));
  }
  if (start.find('\0') != std::string_view::npos) {
    throw system::FileError(input.name(), "the file is binary data, or text that is not UTF-8",
                            "CSV, TSV, JSON, AEM and NumPy's .npy and .npz are read");
  }
  if (AemReader::recognizes(start)) return std::make_unique<AemReader>(std::move(input), false);
  if (system::without_byte_order_mark(start).starts_with("CCSDS_")) {
    throw system::FileError(input.name(),
                            "the file is a CCSDS message without attitude ephemerides",
                            "of these, the attitude ephemeris messages (AEM) are read");
  }
  if (is_of_stk(start)) {
    StkTable table = table_of_stk(input);
    return std::make_unique<CsvReader>(std::move(table.input), std::move(table.sequence));
  }
  if (is_of_ardupilot(start)) return std::make_unique<CsvReader>(table_of_ardupilot(input));
  if (is_yaml(start)) return std::make_unique<JsonReader>(json_from_yaml(input), true);
  if (has_quaternion_cells(start)) return std::make_unique<CsvReader>(table_of_quaternions(input));
  if (is_json(start)) return std::make_unique<JsonReader>(std::move(input));
  auto table = table_of_vector_cells(input);
  return std::make_unique<CsvReader>(table ? std::move(*table) : std::move(input));
}

/// The rows of columns in memory.
class ArrayReader : public Reader {
 public:
  ArrayReader(const std::string& name, std::vector<Column> columns, std::size_t rows)
      : columns_(std::move(columns)), rows_(rows) {
    header_.file = name;
    if (rows_ == 0) throw BadTable(name, "it has no rows");
    std::ranges::transform(columns_, std::back_inserter(header_.names), &Column::name);
  }

  void begin_pass(std::span<const std::size_t> columns) override {
    row_ = 0;
    selected_.assign(columns.begin(), columns.end());
  }

  bool next(std::span<Number> numbers) override {
    if (row_ == rows_) return false;
    for (std::size_t i = 0; i < selected_.size(); ++i) {
      const Column& column = columns_[selected_[i]];
      numbers[i] = Number{.value = column.first[static_cast<std::ptrdiff_t>(row_) * column.step]};
    }
    ++row_;
    return true;
  }

  std::string place() const override { return fmt::format("{}: row {}", header_.file, row_); }

 private:
  std::vector<Column> columns_;
  std::size_t rows_, row_ = 0;  ///< all, and those that were read
  std::vector<std::size_t> selected_;
};

/// Returns the reader if its table has columns, but not too many.
std::unique_ptr<Reader> with_columns(std::unique_ptr<Reader> reader) {
  constexpr std::size_t most_columns = 16384;  // as many as the usual spreadsheets have
  const Header& header = reader->header();
  if (header.names.empty()) throw system::FileError(header.file, "its first row is empty");
  if (header.names.size() <= most_columns) return reader;
  throw system::FileError(header.file, fmt::format("it has {} columns, but at most {} are read",
                                                   header.names.size(), most_columns));
}

}  // namespace

std::unique_ptr<Reader> open_table(const std::filesystem::path& path) {
  return with_columns(open_format(Input(path)));
}

std::unique_ptr<Reader> open_table(const std::string& name, std::string_view bytes) {
  return with_columns(open_format(Input(name, bytes)));
}

std::unique_ptr<Reader> open_table(const std::string& name, std::vector<Column> columns,
                                   std::size_t rows) {
  return with_columns(std::make_unique<ArrayReader>(name, std::move(columns), rows));
}

}  // namespace twrench::table
