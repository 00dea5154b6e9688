#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::system {

/// Encodes the bytes in base64 (RFC 4648, section 4), on one line.
std::string base64(std::span<const std::uint8_t> bytes);

/// Decodes base64. Returns nothing if the text is not valid, including its padding to a multiple of
/// four characters.
std::optional<std::vector<std::uint8_t>> bytes_of_base64(std::string_view text);

}  // namespace twrench::system
