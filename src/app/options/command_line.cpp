#include "app/options/command_line.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "base/enumeration.h"

namespace twrench::app {

std::string heading(OptionGroup group) {
  std::string text(enumerator_name(group));
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

OptionGroup group_with(const std::string& text, const std::string& option) {
  const auto found = std::ranges::find(enumerators<OptionGroup>, text, heading);
  if (found != enumerators<OptionGroup>.end()) return *found;
  throw std::logic_error("the option " + option + " names no group");
}

}  // namespace twrench::app
