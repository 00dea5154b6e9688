#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace twrench::mesh {

/// Returns the number stored at `offset` in the given byte order. The caller checks the bounds.
template <typename Number>
Number number_at(std::string_view bytes, std::size_t offset,
                 std::endian order = std::endian::little) {
  std::array<char, sizeof(Number)> own{};
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::size_t from = order == std::endian::native ? i : own.size() - 1 - i;
    own[i] = bytes[offset + from];
  }
  return std::bit_cast<Number>(own);
}

}  // namespace twrench::mesh
