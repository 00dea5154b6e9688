#include <twrench/base/error.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace twrench {
namespace {

/// Maximum length of a part of a message in bytes, a few lines of a terminal.
constexpr std::size_t longest_part = 1000;
/// A remedy may be longer, because it may list the allowed values.
constexpr std::size_t longest_remedy = 2000;
/// Maximum length of a quotation in letters. Users recognise their input by that much of it.
constexpr std::ptrdiff_t longest_quotation = 80;
/// Marks the place of the omitted text.
constexpr std::string_view mark = "\u2026";

bool continues_character(char byte) {  // in UTF-8
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

bool begins_character(char byte) { return !continues_character(byte); }

std::string without_middle(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t begin = (most - mark.size()) / 2, end = text.size() - begin;
  while (begin > 0 && continues_character(text[begin])) --begin;
  while (end < text.size() && continues_character(text[end])) ++end;
  return text.substr(0, begin).append(mark).append(text, end);
}

/// Returns where a letter of the text begins; the first is number 0.
std::size_t letter_at(const std::string& text, std::ptrdiff_t number) {
  std::size_t at = 0;
  while (continues_character(text[at]) || number-- > 0) ++at;
  return at;
}

/// Returns a quoted text without its middle if it is long. A path stays as it is, because the user
/// must find the file.
std::string short_quotation(const std::string& text) {
  const bool is_path = text.find('/') != std::string::npos;
  const std::ptrdiff_t letters = std::ranges::count_if(text, begins_character);
  if (is_path || letters <= longest_quotation) return text;
  constexpr std::ptrdiff_t kept = (longest_quotation - 1) / 2;  // at either end
  return text.substr(0, letter_at(text, kept))
      .append(mark)
      .append(text, letter_at(text, letters - kept));
}

/// Shortens the texts between single quotation marks. A mark within a word is an apostrophe, and
/// the edges of the text are like spaces.
std::string with_short_quotations(const std::string& text) {
  const auto is_one_of = [&](std::string_view neighbours, std::size_t at) {
    return at >= text.size() || neighbours.find(text[at]) != std::string_view::npos;
  };
  std::string result;
  std::size_t written = 0;
  for (std::size_t open = 0; (open = text.find('\'', open)) != std::string::npos; ++open) {
    if (!is_one_of(" (", open - 1)) continue;
    std::size_t close = text.find('\'', open + 1);
    while (close != std::string::npos && !is_one_of(" ,.:;?)", close + 1)) {
      close = text.find('\'', close + 1);
    }
    if (close == std::string::npos) break;
    result.append(text, written, open + 1 - written);
    result += short_quotation(text.substr(open + 1, close - open - 1));
    written = open = close;
  }
  return result.append(text, written);
}

std::string printable(const std::string& text, std::size_t most) {
  std::string result = without_middle(text, most);
  for (std::size_t at = 0; (at = result.find('\0', at)) != std::string::npos;) {
    result.replace(at, 1, "\\x00");
  }
  return result;
}

std::string printable_message(const std::string& text) {
  return printable(with_short_quotations(text), longest_part);
}

}  // namespace

Error::Error(const std::string& what, const std::string& why, const std::string& remedy)
    : std::runtime_error(printable_message(what) + ": " + printable_message(why)),
      // A remedy may quote options to repeat, which must be whole.
      remedy_(printable(remedy, longest_remedy)) {}

Error::~Error() = default;
InvalidArgument::~InvalidArgument() = default;
OutOfRange::~OutOfRange() = default;

std::string Error::quoted(const std::string& what) { return printable_message(what); }

}  // namespace twrench
