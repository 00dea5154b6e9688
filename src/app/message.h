#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>

namespace twrench {

/// The text on one line and harmless to a terminal: control characters, invisible ones that reorder
/// or hide others, and bytes that are no UTF-8 become \n, \x1b, \u202e. For eyes, not to be read
/// back: a backslash stays as it is.
std::string escape(std::string_view text);

/// A value of a message: text escaped, all else as it is.
template <typename T>
decltype(auto) escape_if_text(const T& value) {
  if constexpr (std::is_convertible_v<const T&, std::string_view>) {
    return escape(value);
  } else {
    return (value);
  }
}

/// The message in fmt's format, in which every text among the values is escaped. The format is
/// ours, and so are its line ends.
template <typename... T>
std::string format_message(fmt::format_string<T...> format, const T&... values) {
  const fmt::string_view checked = format;
  return fmt::format(fmt::runtime(checked), escape_if_text(values)...);
}

/// Writes to standard error. That nobody listens there, or that its disk is full, is no reason to
/// end a run.
void write_message(const std::string& text);

/// Says a message on standard error.
template <typename... T>
void say(fmt::format_string<T...> format, const T&... values) {
  write_message(format_message<T...>(format, values...));
}

/// Says a warning: for people, or for a program that reads JSON, an object on a line.
void warn(const std::string& text, bool as_json = false);

}  // namespace twrench
