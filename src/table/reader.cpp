#include "table/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "system/error.h"
#include "table/csv_reader.h"
#include "table/input.h"
#include "table/json_reader.h"
#include "table/line_reader.h"
#include "table/npy_reader.h"

namespace twrench::table {
namespace {

using namespace std::string_view_literals;

/// An unsupported format, and the remedy.
struct Foreign {
  std::string_view begins, what, remedy;
};

constexpr std::array<Foreign, 9> foreign{{
    {"\x1F\x8B"sv, "is compressed (gzip)", "unpack it first: gunzip -k FILE"},
    {"PK\x03\x04"sv, "is a ZIP archive, as .npz and .xlsx are",
     "unpack the .npy from it, or save the table as CSV"},
    {"BZh"sv, "is compressed (bzip2)", "unpack it first: bunzip2 -k FILE"},
    {"\xFD\x37zXZ\x00"sv, "is compressed (xz)", "unpack it first: unxz -k FILE"},
    {"\x28\xB5\x2F\xFD"sv, "is compressed (zstd)", "unpack it first: unzstd FILE"},
    {"\x89HDF\r\n\x1A\n"sv, "is an HDF5 file", "save the table as CSV or with numpy.save"},
    {"PAR1"sv, "is a Parquet file", "save the table as CSV or with numpy.save"},
    {"\xFF\xFE"sv, "is UTF-16 text", "save it as UTF-8: iconv -f UTF-16 -t UTF-8 FILE"},
    {"\xFE\xFF"sv, "is UTF-16 text", "save it as UTF-8: iconv -f UTF-16 -t UTF-8 FILE"},
}};

/// Whether the text begins like rows in JSON: with an object, or with an array of objects or
/// arrays. A CSV table may begin with a name in brackets.
bool is_json(std::string_view text) {
  text.remove_prefix(byte_order_mark(text));
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
  std::array<char, 512> bytes{};
  const std::string_view start(bytes.data(), input.read(0, bytes.data(), bytes.size()));
  if (start.empty()) throw system::FileError(input.name(), "the file is empty");
  for (const Foreign& format : foreign) {
    if (!start.starts_with(format.begins)) continue;
    throw system::FileError(input.name(), fmt::format("the file {}", format.what),
                            std::string(format.remedy));
  }
  if (start.starts_with("\x93NUMPY")) return std::make_unique<NpyReader>(std::move(input));
  if (start.find('\0') != std::string_view::npos) {
    throw system::FileError(input.name(), "the file is binary data, or text that is not UTF-8",
                            "CSV, TSV, JSON and NumPy's .npy are read");
  }
  if (is_json(start)) return std::make_unique<JsonReader>(std::move(input));
  return std::make_unique<CsvReader>(std::move(input));
}

std::unique_ptr<Reader> open(Input input) {
  constexpr std::size_t most_columns = 16384;  // as many as the usual spreadsheets have
  auto reader = open_format(std::move(input));
  const Header& header = reader->header();
  if (header.names.empty()) throw system::FileError(header.file, "its first row is empty");
  if (header.names.size() <= most_columns) return reader;
  throw system::FileError(header.file, fmt::format("it has {} columns, but at most {} are read",
                                                   header.names.size(), most_columns));
}

}  // namespace

std::unique_ptr<Reader> open_table(const std::filesystem::path& path) { return open(Input(path)); }

std::unique_ptr<Reader> open_table(const std::string& name, std::string_view bytes) {
  return open(Input(name, bytes));
}

}  // namespace twrench::table
