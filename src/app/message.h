#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace twrench {

/// Says something on standard error, in fmt's format. That nobody listens there, or that its disk
/// is full, is no reason to end a run: fmt::print would throw.
template <typename... T>
void say(fmt::format_string<T...> format, T&&... values) {
  const std::string text = fmt::format(format, std::forward<T>(values)...);
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

}  // namespace twrench
