#include "app/terminal/message.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace twrench::app {

void write_message(const std::string& text) {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

void warn(const std::string& text, bool as_json) {
  if (as_json) {
    const nlohmann::json line{{"warning", text}};  // ASCII only
    return say("{}\n", line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
  }
  say("twrench: warning: {}\n", text);
}

}  // namespace twrench::app
