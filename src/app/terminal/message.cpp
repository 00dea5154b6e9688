#include "app/terminal/message.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace twrench::app {

void write_message(const std::string& text) {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

std::function<void(std::size_t, std::size_t)> progress_lines(const std::string& command,
                                                             const std::string& advice) {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds pause(2);
  return [=, next = Clock::now() + pause](std::size_t done, std::size_t total) mutable {
    if (Clock::now() < next) return;
    next = Clock::now() + pause;
    say("twrench: {}: {} % is done{}\n", command, 100 * done / total, advice);
  };
}

std::string option_text(std::string_view name, std::string_view value) {
  std::string text = "--" + std::string(name);
  std::ranges::replace(text, '_', '-');
  if (value.empty()) return text;
  constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789.,+-/";
  if (value.find_first_not_of(plain) == std::string_view::npos) {
    return text.append(1, ' ').append(value);
  }
  text += " '";  // as a shell quotes it
  for (const char c : value) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + '\'';
}

void warn(const std::string& text, bool as_json) {
  if (as_json) {
    const nlohmann::json line{{"warning", text}};  // ASCII only
    return say("{}\n", line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
  }
  say("twrench: warning: {}\n", text);
}

}  // namespace twrench::app
