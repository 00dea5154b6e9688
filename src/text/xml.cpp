#include "text/xml.h"

#include "text/escape.h"

namespace twrench::text {
namespace {

std::string_view reference_of(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

/// U+FFFE and U+FFFF are not characters (XML 1.0, 2.2).
bool is_noncharacter(std::string_view rest) {
  return rest.starts_with("\xEF\xBF\xBE") || rest.starts_with("\xEF\xBF\xBF");
}

}  // namespace

std::string escape_xml(std::string_view text) {
  const std::string shown = escape(text);
  std::string result;
  for (std::string_view rest = shown; !rest.empty();) {
    const bool is_allowed = !is_noncharacter(rest);
    const std::string_view reference = reference_of(rest.front());
    if (!is_allowed) {
      result += rest[2] == '\xBE' ? "\\ufffe" : "\\uffff";
    } else if (reference.empty()) {
      result += rest.front();
    } else {
      result += reference;
    }
    rest.remove_prefix(is_allowed ? 1 : 3);
  }
  return result;
}

}  // namespace twrench::text
