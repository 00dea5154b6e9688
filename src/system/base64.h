#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::system {

/// Returns the bytes in base64 (RFC 4648, section 4), on one line.
std::string base64(std::span<const std::uint8_t> bytes);

/// Returns the bytes that a text in base64 stands for; nothing where it is no such text, padding to
/// a multiple of four characters included.
std::optional<std::vector<std::uint8_t>> bytes_of_base64(std::string_view text);

}  // namespace twrench::system
