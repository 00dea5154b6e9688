#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace twrench::page {

/// Returns integers as text that takes few bytes of a page. Every `width` integers form a row; the
/// differences of each row from the row before are written modulo 2^16 or 2^32, little-endian,
/// deflated (zlib, RFC 1950) and in base64. web/picture/unpacking.js reads it.
std::string packed(const std::vector<std::uint16_t>& integers, std::size_t width);
/// The same for 32-bit integers.
std::string packed(const std::vector<std::uint32_t>& integers, std::size_t width);

}  // namespace twrench::page
