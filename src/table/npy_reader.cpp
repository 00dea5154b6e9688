#include "table/npy_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <map>
#include <type_traits>
#include <utility>

#include "system/error.h"
#include "table/error.h"

namespace twrench::table {
namespace {

/// Reads a number of type T in the byte order `endian`.
template <typename T, std::endian endian>
Number decode_number(const char* bytes) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes, raw.size());
  if constexpr (endian != std::endian::native) std::ranges::reverse(raw);
  const T read = std::bit_cast<T>(raw);
  Number number;
  number.value = static_cast<double>(read);
  if constexpr (std::is_integral_v<T>) number.decimals = 0;
  if constexpr (std::is_integral_v<T> && sizeof(T) == 8) {
    const double high = static_cast<double>(read >> 32) * 0x1p32;
    number.rest = (high - number.value) + static_cast<double>(read & 0xFFFFFFFF);
  }
  return number;
}

template <typename T>
void add_decoders(std::map<std::string, NpyDecode>& decoders, const std::string& type) {
  decoders["<" + type] = decode_number<T, std::endian::little>;
  decoders[">" + type] = decode_number<T, std::endian::big>;
  decoders["=" + type] = decode_number<T, std::endian::native>;
  decoders["|" + type] = decode_number<T, std::endian::native>;
}

/// The decoders by NumPy's names of the types.
const std::map<std::string, NpyDecode>& all_decoders() {
  static const std::map<std::string, NpyDecode> all = [] {
    std::map<std::string, NpyDecode> decoders;
    add_decoders<double>(decoders, "f8");
    add_decoders<float>(decoders, "f4");
    add_decoders<std::int8_t>(decoders, "i1");
    add_decoders<std::int16_t>(decoders, "i2");
    add_decoders<std::int32_t>(decoders, "i4");
    add_decoders<std::int64_t>(decoders, "i8");
    add_decoders<std::uint8_t>(decoders, "u1");
    add_decoders<std::uint16_t>(decoders, "u2");
    add_decoders<std::uint32_t>(decoders, "u4");
    add_decoders<std::uint64_t>(decoders, "u8");
    return decoders;
  }();
  return all;
}

}  // namespace

NpyDecode npy_decoder(const std::string& file, const NpyColumn& column) {
  const auto decoder = all_decoders().find(column.type);
  if (decoder != all_decoders().end()) return decoder->second;
  throw BadTable(file,
                 fmt::format("the column '{}' is of NumPy's type '{}', which is not read",
                             column.name, column.type),
                 "save it as numbers: array.astype(float)");
}

std::size_t npy_size(const NpyColumn& column) {
  return static_cast<std::size_t>(column.type.back() - '0');
}

NpyReader::NpyReader(Input input) : input_(std::move(input)), layout_(read_npy_header(input_)) {
  header_.file = input_.name();
  if (layout_.rows == 0) throw BadTable(header_.file, "it has no rows");
  std::ranges::transform(layout_.columns, std::back_inserter(header_.names), &NpyColumn::name);
}

void NpyReader::begin_pass(std::span<const std::size_t> columns) {
  row_ = 0;
  selected_.clear();
  windows_.clear();
  for (const std::size_t index : columns) {
    const NpyColumn& column = layout_.columns[index];
    const NpyDecode decode = npy_decoder(header_.file, column);
    const std::size_t size = npy_size(column);
    // Stored row by row: one window. Stored column by column: one for each.
    const bool by_columns = column.step == size && layout_.columns.size() > 1;
    if (by_columns || windows_.empty()) windows_.emplace_back(input_);
    selected_.push_back({column, size, decode, windows_.size() - 1});
  }
}

std::string NpyReader::place() const { return fmt::format("{}: row {}", header_.file, row_); }

bool NpyReader::next(std::span<Number> numbers) {
  if (row_ == layout_.rows) return false;
  for (std::size_t i = 0; i < selected_.size(); ++i) {
    const Selected& selected = selected_[i];
    const std::uint64_t offset = selected.column.begin + row_ * selected.column.step;
    const std::string_view bytes = windows_[selected.window].at(offset, selected.size);
    numbers[i] = selected.decode(bytes.data());
  }
  ++row_;
  return true;
}

}  // namespace twrench::table
