#include "canvas/utf8.h"

#include <cstdint>

namespace twrench {
namespace {

constexpr Utf8Character ill_formed{U'\uFFFD', 1};

}  // namespace

Utf8Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return ill_formed;
  char32_t point = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return ill_formed;
    point = point << 6U | (byte(i) & 0x3FU);
  }
  const bool overlong = (length == 3 && point < 0x800) || (length == 4 && point < 0x10000);
  const bool surrogate = point >= 0xD800 && point < 0xE000;
  if (overlong || surrogate || point > 0x10FFFF) return ill_formed;
  return {point, length};
}

std::vector<char32_t> decode_utf8(std::string_view text) {
  std::vector<char32_t> points;
  while (!text.empty()) {
    const auto [point, length] = first_character(text);
    const bool control = point < 0x20 || (point >= 0x7F && point < 0xA0);
    points.push_back(control ? U' ' : point);
    text.remove_prefix(length);
  }
  return points;
}

}  // namespace twrench
