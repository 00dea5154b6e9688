#include "page/packing.h"

#include <zlib.h>

#include <new>

#include "system/bytes.h"

namespace twrench::page {
namespace {

std::vector<std::uint8_t> deflated(const std::vector<std::uint8_t>& bytes) {
  uLongf size = compressBound(bytes.size());
  std::vector<std::uint8_t> result(size);
  if (compress2(result.data(), &size, bytes.data(), bytes.size(), Z_BEST_COMPRESSION) != Z_OK) {
    throw std::bad_alloc();  // with enough room, nothing else can fail
  }
  result.resize(size);
  return result;
}

template <typename Integer>
std::string packed_rows(const std::vector<Integer>& integers, std::size_t width) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(integers.size() * sizeof(Integer));
  for (std::size_t i = 0; i < integers.size(); ++i) {
    const Integer above = i < width ? Integer{0} : integers[i - width];
    const auto difference = static_cast<Integer>(integers[i] - above);
    for (std::size_t k = 0; k < sizeof(Integer); ++k) {
      bytes.push_back(static_cast<std::uint8_t>(difference >> (8 * k)));
    }
  }
  return system::base64(deflated(bytes));
}

}  // namespace

std::string packed(const std::vector<std::uint16_t>& integers, std::size_t width) {
  return packed_rows(integers, width);
}

std::string packed(const std::vector<std::uint32_t>& integers, std::size_t width) {
  return packed_rows(integers, width);
}

}  // namespace twrench::page
