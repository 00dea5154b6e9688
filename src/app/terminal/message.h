#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>

#include "text/escape.h"

namespace twrench::app {

/// Returns a message argument: text escaped, everything else unchanged.
template <typename T>
decltype(auto) escape_if_text(const T& value) {
  if constexpr (std::is_convertible_v<const T&, std::string_view>) {
    return text::escape(value);
  } else {
    return (value);
  }
}

/// Formats a message in fmt's format and escapes every text among the values. The format string is
/// trusted, including its line ends.
template <typename... T>
std::string format_message(fmt::format_string<T...> format, const T&... values) {
  const fmt::string_view checked = format;
  return fmt::format(fmt::runtime(checked), escape_if_text(values)...);
}

/// Writes to standard error. Errors are ignored: a closed or full standard error must not end a
/// run.
void write_message(const std::string& text);

/// Formats a message and writes it to standard error.
template <typename... T>
void say(fmt::format_string<T...> format, const T&... values) {
  write_message(format_message<T...>(format, values...));
}

/// Returns a function that is called with the work that is done and all of it, and that writes a
/// line every two seconds, for work that takes longer: "twrench: study: 40 % is done", followed by
/// the advice.
std::function<void(std::size_t done, std::size_t total)> progress_lines(
    const std::string& command, const std::string& advice = "");

/// Words an argument that a library mentions as an option: "--columns 't=time'".
std::string option_text(std::string_view name, std::string_view value);

/// Writes a warning: plain text, or with `as_json` a JSON object on one line.
void warn(const std::string& text, bool as_json = false);

}  // namespace twrench::app
