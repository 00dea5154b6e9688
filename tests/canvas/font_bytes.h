#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/file.h"

namespace twrench {

/// The file of "sans", from its package.
inline std::vector<std::uint8_t> sans_file() { return read_file(TWRENCH_SANS_FILE, 1 << 24); }

/// Where the table's bytes are in the file.
inline std::span<std::uint8_t> table(std::vector<std::uint8_t>& file, const std::string& tag) {
  const auto number = [&](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8U | file[i];
    return value;
  };
  std::size_t at = 12;
  while (std::string(&file[at], &file[at + 4]) != tag) at += 16;
  return std::span(file).subspan(number(at + 8), number(at + 12));
}

}  // namespace twrench
