#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <system_error>

namespace twrench::mesh {

/// Returns the number that the whole word is; nothing if it is none.
template <typename Number>
std::optional<Number> number_of_word(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || stop != word.data() + word.size()) return std::nullopt;
  return value;
}

inline std::optional<double> real_number(std::string_view word) {
  return number_of_word<double>(word);
}

inline std::optional<std::uint32_t> whole_number(std::string_view word) {
  return number_of_word<std::uint32_t>(word);
}

/// Calls a function with each word of a text.
template <typename Function>
void for_each_word(std::string_view text, const Function& function) {
  constexpr std::string_view white_space = " \t\r\n";
  std::size_t begin = text.find_first_not_of(white_space);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(white_space, begin), text.size());
    function(text.substr(begin, end - begin));
    begin = text.find_first_not_of(white_space, end);
  }
}

/// Calls a function with each word of an element's text. Comments may interrupt the text.
template <typename Function>
void for_each_word(const pugi::xml_node& element, const Function& function) {
  for (const pugi::xml_node part : element.children())
    for_each_word(std::string_view(part.value()), function);
}

}  // namespace twrench::mesh
