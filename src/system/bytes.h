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

/// Returns the SHA-256 digest (FIPS 180-4) of the bytes as 64 lower-case hexadecimal digits.
std::string sha256_hex(std::span<const std::uint8_t> bytes);

}  // namespace twrench::system
