#include "table/yaml.h"

#include <fmt/format.h>
#include <yaml.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "system/error.h"
#include "table/number_text.h"

namespace twrench::table {
namespace {

/// Whether the line has a key: "x: 0.05", "header:".
bool has_key(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == 0 || colon == std::string_view::npos) return false;
  const bool ends_key = colon + 1 == line.size() || line[colon + 1] == ' ';
  return ends_key && line.substr(0, colon).find_first_of(",;\t ") == std::string_view::npos;
}

/// Writes the values of a document as JSON.
class JsonText {
 public:
  void begin_document() {
    begin_ = text_->size();
    is_scalar_ = true;
  }
  /// A document that is empty or a single value has no row.
  void end_document() {
    if (is_scalar_) text_->resize(begin_);
    if (!is_scalar_) *text_ += '\n';
  }
  void open(char bracket, bool is_object) {
    separate();
    *text_ += bracket;
    levels_.push_back({is_object, 0});
    is_scalar_ = false;
  }
  void close(char bracket) {
    levels_.pop_back();
    *text_ += bracket;
  }
  void add(const std::string& value, bool is_plain) {
    const bool is_key =
        !levels_.empty() && levels_.back().is_object && levels_.back().count % 2 == 0;
    separate();
    const bool is_json = is_plain && !is_key && nlohmann::json::accept(value);
    constexpr auto replace = nlohmann::json::error_handler_t::replace;
    *text_ += is_json ? value : nlohmann::json(value).dump(-1, ' ', false, replace);
  }

  std::shared_ptr<const std::string> text() const { return text_; }

 private:
  struct Level {
    bool is_object;
    std::size_t count;  ///< of keys and values
  };

  void separate() {
    if (levels_.empty()) return;
    Level& level = levels_.back();
    const bool is_value = level.is_object && level.count % 2 == 1;
    if (level.count > 0) *text_ += is_value ? ':' : ',';
    ++level.count;
  }

  std::shared_ptr<std::string> text_ = std::make_shared<std::string>();
  std::vector<Level> levels_;
  std::size_t begin_ = 0;  ///< of the document
  bool is_scalar_ = true;
};

/// The parser of libyaml, and its last event.
class Parser {
 public:
  Parser(const Input& input, const std::string& text) : name_(input.name()) {
    if (yaml_parser_initialize(&parser_) == 0) throw std::bad_alloc();
    yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()),
                                 text.size());
  }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;
  ~Parser() {
    yaml_event_delete(&event_);
    yaml_parser_delete(&parser_);
  }

  const yaml_event_t& next() {
    yaml_event_delete(&event_);
    if (yaml_parser_parse(&parser_, &event_) != 0) return event_;
    const char* const problem = parser_.problem;
    throw system::FileError(
        fmt::format("{}:{}", name_, parser_.problem_mark.line + 1),
        fmt::format("it is no valid YAML: {}", problem == nullptr ? "it ends too early" : problem),
        "if it is cut off, remove its last document");
  }

  system::FileError alias() const {
    return {fmt::format("{}:{}", name_, event_.start_mark.line + 1),
            "it refers to another part of the file, which is not read",
            "write the values out, without * and &"};
  }

 private:
  std::string name_;
  yaml_parser_t parser_{};
  yaml_event_t event_{};
};

std::string value_of(const yaml_event_t& event) {
  const auto& scalar = event.data.scalar;
  return {reinterpret_cast<const char*>(scalar.value), scalar.length};
}

}  // namespace

bool is_yaml(std::string_view start) {
  bool has_mark = false;
  constexpr std::size_t whole = 4096;  // a line at the end may be cut off
  if (start.size() == whole) start = start.substr(0, start.rfind('\n') + 1);
  while (!start.empty()) {
    const std::size_t end = std::min(start.find('\n'), start.size());
    std::string_view line = start.substr(0, end);
    start.remove_prefix(std::min(end + 1, start.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    line = trimmed(line);
    const bool is_mark = line == "---" || line == "-" || line.starts_with("- ");
    has_mark = has_mark || is_mark;
    if (!line.empty() && line.front() != '#' && !is_mark && !has_key(line)) return false;
  }
  return has_mark;
}

Input json_from_yaml(const Input& input) {
  constexpr std::size_t most = std::size_t{64} << 20;
  if (input.size() > most) {
    throw system::FileError(input.name(), "it is YAML of more than 64 MiB",
                            "convert it to CSV, as rostopic echo -p does");
  }
  std::string text(input.size(), '\0');
  input.read(0, text.data(), text.size());
  Parser parser(input, text);
  JsonText json;
  while (true) {
    const yaml_event_t& event = parser.next();
    switch (event.type) {
      case YAML_STREAM_END_EVENT:
        return {input.name(), json.text()};
      case YAML_DOCUMENT_START_EVENT:
        json.begin_document();
        break;
      case YAML_DOCUMENT_END_EVENT:
        json.end_document();
        break;
      case YAML_ALIAS_EVENT:
        throw parser.alias();
      case YAML_SCALAR_EVENT:
        json.add(value_of(event), event.data.scalar.style == YAML_PLAIN_SCALAR_STYLE);
        break;
      case YAML_SEQUENCE_START_EVENT:
        json.open('[', false);
        break;
      case YAML_SEQUENCE_END_EVENT:
        json.close(']');
        break;
      case YAML_MAPPING_START_EVENT:
        json.open('{', true);
        break;
      case YAML_MAPPING_END_EVENT:
        json.close('}');
        break;
      case YAML_NO_EVENT:
      case YAML_STREAM_START_EVENT:
        break;
    }
  }
}

}  // namespace twrench::table
