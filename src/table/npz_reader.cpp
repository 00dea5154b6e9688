#include "table/npz_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "system/error.h"
#include "table/error.h"

namespace twrench::table {
namespace {

constexpr std::string_view array_suffix = ".npy";

/// The bytes of the archive, read from an input that outlives it.
archive::ZipBytes zip_bytes(const Input& input) {
  const auto read = [&input](std::uint64_t offset, char* to, std::size_t length) {
    return input.read(offset, to, length);
  };
  return {input.name(), input.size(), read, "write it again with numpy.savez, without a password"};
}

/// The name of the array in a member.
std::string array_name(const archive::ZipMember& member) {
  return member.name.substr(0, member.name.size() - array_suffix.size());
}

/// Whether numpy.savez numbered the array because it had no name.
bool is_numbered_array(const archive::ZipMember& member) { return member.name.starts_with("arr_"); }

}  // namespace

NpzReader::NpzReader(Input input) : input_(std::move(input)), archive_(zip_bytes(input_)) {
  header_.file = input_.name();
  read_arrays();
  name_columns();
}

void NpzReader::read_arrays() {
  constexpr std::size_t start_bytes = (1 << 16) + 16;  // all that a header may have
  std::vector<char> start(start_bytes);
  std::map<std::uint64_t, int> arrays_of_length;
  bool has_arrays = false;
  for (const archive::ZipMember& member : archive_.members()) {
    if (!member.name.ends_with(array_suffix)) continue;
    has_arrays = true;
    const std::size_t got = archive_.open(member).read(start.data(), start.size());
    const Input first(fmt::format("{}: {}", header_.file, member.name), {start.data(), got});
    auto layout = read_npy_member(first, member.size, array_name(member));
    if (!layout) continue;
    ++arrays_of_length[layout->rows];
    arrays_.push_back({member, std::move(*layout)});
  }
  if (!has_arrays) {
    throw system::FileError(header_.file, "the file is a ZIP archive without NumPy's arrays",
                            "it may be .xlsx: save the table as CSV");
  }
  // Others are parameters, such as three moments.
  for (const auto& [length, count] : arrays_of_length) {
    if (count > 1 || row_count_ == 0) row_count_ = length;
  }
  const bool all_differ =
      std::ranges::all_of(arrays_of_length, [](const auto& one) { return one.second == 1; });
  if (all_differ && !arrays_of_length.empty()) row_count_ = arrays_of_length.rbegin()->first;
  require_no_cut_array();
  std::erase_if(arrays_, [&](const Array& array) { return array.layout.rows != row_count_; });
  if (row_count_ == 0) throw BadTable(header_.file, "it has no rows");
}

/// An array with about as many rows as the times is rather a mistake than a parameter.
void NpzReader::require_no_cut_array() const {
  constexpr std::uint64_t most_parameters = 16;
  for (const Array& array : arrays_) {
    const std::uint64_t rows = array.layout.rows;
    if (rows <= most_parameters || rows == row_count_ || 2 * rows <= row_count_ ||
        rows >= 2 * row_count_)
      continue;
    throw BadTable(header_.file,
                   fmt::format("its array {} has {} rows, but others have {}",
                               array_name(array.member), rows, row_count_),
                   "write arrays with a row for each time, and leave others out");
  }
}

void NpzReader::name_columns() {
  const bool are_numbered = std::ranges::all_of(
      arrays_, [](const Array& array) { return is_numbered_array(array.member); });
  for (std::size_t i = 0; i < arrays_.size(); ++i) {
    const std::vector<NpyColumn>& columns = arrays_[i].layout.columns;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      sources_.push_back({i, k});
      const std::string array = array_name(arrays_[i].member) + ".";
      const bool is_field = columns[k].name.starts_with(array);  // of a structured array
      header_.names.push_back(is_field       ? columns[k].name.substr(array.size())
                              : are_numbered ? fmt::format("#{}", sources_.size())
                                             : columns[k].name);
    }
  }
}

std::size_t NpzReader::open_rows(std::size_t array, std::uint64_t begin, std::size_t row_bytes) {
  Rows rows{array, row_bytes, archive_.open(arrays_[array].member)};
  constexpr std::size_t block_bytes = 1 << 18;
  rows.buffer.resize(std::max(block_bytes, row_bytes));
  while (begin > 0) {
    const auto skipped =
        static_cast<std::size_t>(std::min<std::uint64_t>(begin, rows.buffer.size()));
    rows.stream.read(rows.buffer.data(), skipped);
    begin -= skipped;
  }
  rows_.push_back(std::move(rows));
  return rows_.size() - 1;
}

void NpzReader::begin_pass(std::span<const std::size_t> columns) {
  row_ = 0;
  selected_.clear();
  rows_.clear();
  std::map<std::size_t, std::size_t> rows_of_array;
  for (const std::size_t index : columns) {
    const auto [array, number] = sources_[index];
    const std::vector<NpyColumn>& layout = arrays_[array].layout.columns;
    const NpyColumn& column = layout[number];
    const NpyDecode decode = npy_decoder(header_.file, column);
    const bool by_columns = layout.size() > 1 && column.step == npy_size(column);
    if (by_columns) {
      selected_.push_back({open_rows(array, column.begin, npy_size(column)), 0, decode});
      continue;
    }
    const std::uint64_t begin = layout.front().begin;
    if (!rows_of_array.contains(array)) {
      rows_of_array[array] = open_rows(array, begin, static_cast<std::size_t>(column.step));
    }
    selected_.push_back(
        {rows_of_array[array], static_cast<std::size_t>(column.begin - begin), decode});
  }
}

std::string NpzReader::place() const { return fmt::format("{}: row {}", header_.file, row_); }

/// Moves to the next row.
void NpzReader::advance(Rows& rows) const {
  if (row_ > 0) rows.begin += rows.row_bytes;
  if (rows.end - rows.begin >= rows.row_bytes) return;
  const auto first = rows.buffer.begin();
  std::copy(first + static_cast<std::ptrdiff_t>(rows.begin),
            first + static_cast<std::ptrdiff_t>(rows.end), first);
  rows.end -= rows.begin;
  rows.begin = 0;
  rows.end += rows.stream.read(rows.buffer.data() + rows.end, rows.buffer.size() - rows.end);
  if (rows.end >= rows.row_bytes) return;
  throw system::FileError(fmt::format("{}: {}", header_.file, arrays_[rows.array].member.name),
                          fmt::format("it ends after {} rows", row_),
                          "write it again with numpy.savez");
}

bool NpzReader::next(std::span<Number> numbers) {
  if (row_ == row_count_) return false;
  for (Rows& rows : rows_) advance(rows);
  for (std::size_t i = 0; i < selected_.size(); ++i) {
    const Rows& rows = rows_[selected_[i].rows];
    numbers[i] = selected_[i].decode(rows.buffer.data() + rows.begin + selected_[i].offset);
  }
  ++row_;
  // At the end of a member, its checksum is compared.
  char beyond = 0;
  for (Rows& rows : rows_) {
    if (row_ == row_count_) rows.stream.read(&beyond, 1);
  }
  return true;
}

}  // namespace twrench::table
