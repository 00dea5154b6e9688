#include "text/escape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/locale/utf.hpp>

namespace twrench::text {
namespace {

struct Range {
  char32_t first, last;
};

/// Control characters, line separators, and invisible format characters (Unicode category Cf):
/// those that change direction, join, separate or tag. U+FFFE and U+FFFF are no characters, and XML
/// does not allow them (XML 1.0, 2.2).
constexpr std::array<Range, 12> unseen{{{0x00, 0x1F},
                                        {0x7F, 0x9F},
                                        {0xAD, 0xAD},
                                        {0x61C, 0x61C},
                                        {0x180E, 0x180E},
                                        {0x200B, 0x200F},
                                        {0x2028, 0x202E},
                                        {0x2060, 0x206F},
                                        {0xFEFF, 0xFEFF},
                                        {0xFFF9, 0xFFFB},
                                        {0xFFFE, 0xFFFF},
                                        {0xE0000, 0xE007F}}};

bool is_unseen(char32_t point) {
  return std::ranges::any_of(
      unseen, [=](const Range& range) { return range.first <= point && point <= range.last; });
}

std::string escape_sequence(char32_t point) {
  if (point == '\n') return "\\n";
  if (point == '\r') return "\\r";
  if (point == '\t') return "\\t";
  const auto code = static_cast<unsigned>(point);
  if (code < 0x80) return fmt::format("\\x{:02x}", code);
  return code > 0xFFFF ? fmt::format("\\U{:08x}", code) : fmt::format("\\u{:04x}", code);
}

}  // namespace

std::string escape(std::string_view text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::string shown;
  while (!text.empty()) {
    auto next = text.begin();
    const char32_t point = Utf8::decode(next, text.end());
    const bool well_formed = boost::locale::utf::is_valid_codepoint(point);
    const auto length = well_formed ? static_cast<std::size_t>(next - text.begin()) : 1;
    if (!well_formed) {
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
    } else if (is_unseen(point)) {
      shown += escape_sequence(point);
    } else {
      shown += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return shown;
}

std::string with_references(std::string_view text, std::string_view markup) {
  constexpr std::string_view all = "&<>\"";
  constexpr std::array references{"&amp;", "&lt;", "&gt;", "&quot;"};
  std::string result;
  for (const char c : text) {
    const bool is_markup = markup.find(c) != std::string_view::npos;
    result += is_markup ? std::string(references.at(all.find(c))) : std::string(1, c);
  }
  return result;
}

std::string escape_xml(std::string_view text) { return with_references(escape(text)); }

}  // namespace twrench::text
