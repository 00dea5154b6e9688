#include "table/json_cursor.h"

#include <fmt/format.h>

#include "system/error.h"
#include "table/line_reader.h"

namespace twrench::table {
namespace {

constexpr std::size_t json_block_bytes = 1 << 16;

bool is_json_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool ends_scalar(char c) {
  return is_json_space(c) || c == ',' || c == ']' || c == '}' || c == ':';
}

}  // namespace

JsonCursor::JsonCursor(const Input& input) : input_(&input), window_(input) {
  offset_ = byte_order_mark(window_.at(0, 3));
}

std::string JsonCursor::place() const { return fmt::format("{}:{}", input_->name(), line_); }

std::string JsonCursor::place_here() const { return fmt::format("{}:{}", input_->name(), lines_); }

bool JsonCursor::fill() {
  buffer_ = window_.at(offset_, json_block_bytes);
  offset_ += buffer_.size();
  at_ = 0;
  return !buffer_.empty();
}

std::optional<char> JsonCursor::peek() {
  while (has_next()) {
    const char c = buffer_[at_];
    if (!is_json_space(c)) return c;
    take();
  }
  return std::nullopt;
}

void JsonCursor::take() {
  if (!has_next()) return;
  lines_ += buffer_[at_] == '\n' ? 1 : 0;
  ++at_;
}

bool JsonCursor::take_if(char wanted) {
  if (peek() != wanted) return false;
  take();
  return true;
}

void JsonCursor::expect(char wanted) {
  if (take_if(wanted)) return;
  const std::optional<char> found = peek();
  if (!found) {
    throw system::FileError(place_here(), fmt::format("the file ends where '{}' is due", wanted),
                            "it may be cut off: write it again");
  }
  throw system::FileError(place_here(),
                          fmt::format("there is '{}' where '{}' is due in JSON", *found, wanted));
}

void JsonCursor::append_and_take() {
  if (value_.size() == max_bytes) {
    throw system::FileError(place(), fmt::format("the value is longer than {} bytes", max_bytes),
                            "expected an array of rows, each an object or an array");
  }
  value_ += buffer_[at_];
  take();
}

std::string_view JsonCursor::take_value() {
  value_.clear();
  const std::optional<char> first = peek();
  line_ = lines_;
  if (first == '{' || first == '[') {
    take_nested();
  } else if (first == '"') {
    take_string();
  } else {
    take_scalar();
  }
  return value_;
}

void JsonCursor::take_scalar() {
  while (has_next() && !ends_scalar(buffer_[at_])) append_and_take();
}

void JsonCursor::take_string() {
  append_and_take();
  while (has_next()) {
    const char c = buffer_[at_];
    append_and_take();
    if (c == '"') return;
    if (c == '\\' && has_next()) append_and_take();
  }
  throw system::FileError(place(), "the file ends within a string",
                          "it may be cut off: write it again");
}

void JsonCursor::take_nested() {
  int depth = 0;
  while (has_next()) {
    const char c = buffer_[at_];
    if (c == '"') {
      take_string();
      continue;
    }
    append_and_take();
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (depth == 0) return;
    if (depth > max_depth) {
      throw system::FileError(place(), fmt::format("it is nested more than {} deep", max_depth),
                              "expected an array of rows, each an object or an array");
    }
  }
  throw system::FileError(place(), "the file ends within the value that begins here",
                          "it may be cut off: write it again");
}

}  // namespace twrench::table
