#include <twrench/base/error.h>

#include <cstddef>
#include <string_view>

namespace twrench {
namespace {

/// Maximum length of a part of a message in bytes, a few lines of a terminal.
constexpr std::size_t longest_part = 1000;
/// A remedy may be longer, because it may list the allowed values.
constexpr std::size_t longest_remedy = 2000;

bool continues_character(char byte) {  // in UTF-8
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

std::string without_middle(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  constexpr std::string_view mark = " ... ";
  std::size_t begin = (most - mark.size()) / 2, end = text.size() - begin;
  while (begin > 0 && continues_character(text[begin])) --begin;
  while (end < text.size() && continues_character(text[end])) ++end;
  return text.substr(0, begin).append(mark).append(text, end);
}

std::string printable(const std::string& text, std::size_t most) {
  std::string result = without_middle(text, most);
  for (std::size_t at = 0; (at = result.find('\0', at)) != std::string::npos;) {
    result.replace(at, 1, "\\x00");
  }
  return result;
}

}  // namespace

Error::Error(const std::string& what, const std::string& why, const std::string& remedy)
    : std::runtime_error(printable(what, longest_part) + ": " + printable(why, longest_part)),
      remedy_(printable(remedy, longest_remedy)) {}

Error::~Error() = default;
InvalidArgument::~InvalidArgument() = default;
OutOfRange::~OutOfRange() = default;

std::string Error::quoted(const std::string& what) { return printable(what, longest_part); }

}  // namespace twrench
