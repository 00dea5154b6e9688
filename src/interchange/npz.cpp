#include "interchange/npz.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zip.h>

#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <numeric>

namespace twrench::interchange {
namespace {

/// The part of a .npy file before the numbers. Source: NumPy Enhancement Proposal 1, "A Simple File
/// Format for NumPy Arrays", version 1.0.
std::string npy_header(const NamedArray& array) {
  constexpr std::size_t alignment = 64, before = 10;  // bytes of the magic, the version, the size
  constexpr char order = std::endian::native == std::endian::little ? '<' : '>';
  const std::size_t in_row =
      std::accumulate(array.row.begin(), array.row.end(), std::size_t{1}, std::multiplies<>());
  std::vector<std::size_t> shape{array.numbers.size() / in_row};
  shape.insert(shape.end(), array.row.begin(), array.row.end());
  std::string text = fmt::format("{{'descr': '{}f8', 'fortran_order': False, 'shape': ({},), }}",
                                 order, fmt::join(shape, ", "));
  text.append(alignment - 1 - (before + text.size()) % alignment, ' ').append(1, '\n');
  const auto size = static_cast<std::uint16_t>(text.size());
  const char low = static_cast<char>(size & 0xffU), high = static_cast<char>(size >> 8U);
  return std::string("\x93NUMPY\x01") + '\0' + low + high + text;
}

using ZipSource = std::unique_ptr<zip_source_t, decltype(&zip_source_free)>;
using ZipArchive = std::unique_ptr<zip_t, decltype(&zip_discard)>;

/// Adds a member whose bytes must outlive the archive. Nothing but a lack of memory fails.
void add_member(zip_t* archive, const std::string& name, const std::string& bytes) {
  zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  if (source == nullptr) throw std::bad_alloc();
  const zip_int64_t index = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    throw std::bad_alloc();
  }
  const auto member = static_cast<zip_uint64_t>(index);
  constexpr zip_uint16_t first_day = (1U << 5U) | 1U;  // 1 January 1980, the first that ZIP knows
  zip_set_file_compression(archive, member, ZIP_CM_STORE, 0);
  zip_file_set_dostime(archive, member, 0, first_day, 0);
}

std::string bytes_of(zip_source_t* source) {
  zip_stat_t stat;
  if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0) throw std::bad_alloc();
  std::string bytes(stat.size, '\0');
  zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  return bytes;
}

}  // namespace

std::string npz_file(std::span<const NamedArray> arrays) {
  const ZipSource file(zip_source_buffer_create(nullptr, 0, 0, nullptr), zip_source_free);
  if (!file) throw std::bad_alloc();
  ZipArchive archive(zip_open_from_source(file.get(), ZIP_TRUNCATE, nullptr), zip_discard);
  if (!archive) throw std::bad_alloc();
  zip_source_keep(file.get());  // because the archive releases it
  std::vector<std::string> members;
  members.reserve(arrays.size());
  for (const NamedArray& array : arrays) {
    std::string& bytes = members.emplace_back(npy_header(array));
    bytes.append(reinterpret_cast<const char*>(array.numbers.data()),
                 array.numbers.size() * sizeof(double));
    add_member(archive.get(), array.name + ".npy", bytes);
  }
  if (zip_close(archive.get()) != 0) throw std::bad_alloc();
  static_cast<void>(archive.release());
  return bytes_of(file.get());
}

}  // namespace twrench::interchange
