#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace twrench::system {

/// Returns the bytes in base64 (RFC 4648, section 4), on one line.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace twrench::system
