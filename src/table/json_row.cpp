#include "table/json_row.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "system/error.h"
#include "table/number_text.h"

namespace twrench::table {
namespace {

/// Turns the events of nlohmann's parser into names and cells.
class RowHandler : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit RowHandler(JsonCells& row) : row_(&row) {}

  const std::string& error() const { return error_; }

  bool null() override { return other("null"); }
  bool boolean(bool value) override { return other(value ? "true" : "false"); }
  bool string(string_t& value) override { return other(value); }
  bool binary(binary_t&) override { return false; }
  bool number_integer(number_integer_t value) override { return number(fmt::format("{}", value)); }
  bool number_unsigned(number_unsigned_t value) override {
    return number(fmt::format("{}", value));
  }
  bool number_float(number_float_t, const string_t& text) override { return number(text); }

  bool start_object(std::size_t) override { return open(false); }
  bool start_array(std::size_t) override { return open(true); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    path_.resize(levels_.back().path_size);
    if (levels_.size() > 1) path_ += '.';
    path_ += name;
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::json::exception& exception) override {
    constexpr int number_overflow = 406;
    if (exception.id == number_overflow) {
      error_ = "holds a number that is beyond what a double can hold";
    } else {
      error_ = fmt::format("is no JSON at its byte {}, near '{}'", position, token);
    }
    return false;
  }

 private:
  struct Level {
    bool is_array;
    std::size_t path_size, count;
  };

  /// Completes the path of an element that has no key.
  void name_element() {
    if (levels_.empty() || !levels_.back().is_array) return;
    Level& array = levels_.back();
    path_.resize(array.path_size);
    path_ += levels_.size() == 1 ? fmt::format("#{}", array.count + 1)
                                 : fmt::format("[{}]", array.count);
    ++array.count;
  }

  bool open(bool is_array) {
    name_element();
    levels_.push_back({is_array, path_.size(), 0});
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  bool add(JsonCell cell) {
    name_element();
    row_->names.push_back(path_);
    row_->cells.push_back(std::move(cell));
    return true;
  }

  bool other(const std::string& text) { return add({JsonCell::Kind::other, {}, text}); }

  bool number(const std::string& text) {
    JsonCell cell{JsonCell::Kind::number, {}, {}};
    if (read_number(text, false, cell.number) == Reading::too_large) {
      cell = {JsonCell::Kind::too_large, {}, text};
    }
    return add(std::move(cell));
  }

  JsonCells* row_;
  std::string path_;
  std::vector<Level> levels_;
  std::string error_;
};

}  // namespace

void read_json_row(std::string_view text, const std::string& place, JsonCells& row) {
  row.names.clear();
  row.cells.clear();
  if (!text.starts_with('{') && !text.starts_with('[')) {
    throw system::FileError(place, "the row is neither an object nor an array",
                            "expected an array of rows, each an object or an array");
  }
  RowHandler handler(row);
  if (nlohmann::json::sax_parse(text, &handler)) return;
  throw system::FileError(place, "the row " + handler.error());
}

}  // namespace twrench::table
