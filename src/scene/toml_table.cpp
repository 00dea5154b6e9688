#include "scene/toml_table.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/words.h"
#include "scene/fields.h"

namespace twrench::scene {
namespace {

using nlohmann::ordered_json;

// Each returns the value of a node. Throws InvalidArgument about `what` if the value has another
// form.

double number(const toml::node& node, const std::string& what) {
  // Not value<double>(), which returns nothing for an integer that no double represents exactly.
  if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
  if (const auto* real = node.as_floating_point()) return real->get();
  throw InvalidArgument(what, "must be a number");
}

ordered_json numbers(const toml::node& node, std::size_t count, const std::string& what) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() != count) {
    throw InvalidArgument(what, fmt::format("must be an array of {} numbers", count));
  }
  ordered_json values = ordered_json::array();
  for (const toml::node& entry : *array) values.push_back(number(entry, what));
  return values;
}

ordered_json vectors(const toml::node& node, const std::string& what) {
  if (!node.is_array()) throw InvalidArgument(what, "must be an array of arrays of 3 numbers");
  ordered_json values = ordered_json::array();
  for (const toml::node& entry : *node.as_array()) values.push_back(numbers(entry, 3, what));
  return values;
}

std::string text(const toml::node& node, const char* form, const std::string& what) {
  if (!node.is_string()) throw InvalidArgument(what, form);
  return node.as_string()->get();
}

ordered_json texts(const toml::node& node, const std::string& what) {
  static constexpr const char* form = "must be an array of strings";
  if (!node.is_array()) throw InvalidArgument(what, form);
  ordered_json values = ordered_json::array();
  for (const toml::node& entry : *node.as_array()) values.push_back(text(entry, form, what));
  return values;
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// The parser's message "Error while parsing string: unexpected character", in the words of other
/// messages. One contains the name of a macro.
std::string reason_of(std::string_view description) {
  if (contains(description, "TOML_MAX_NESTED_VALUES")) {
    return fmt::format("arrays and tables are nested more than {} deep", TOML_MAX_NESTED_VALUES);
  }
  constexpr std::string_view beginning = "Error while parsing ";
  if (!description.starts_with(beginning)) return std::string(description);
  return fmt::format("cannot read this {}", description.substr(beginning.size()));
}

std::string remedy_for(std::string_view description) {
  if (contains(description, "TOML_MAX_NESTED_VALUES")) return "";
  if (contains(description, "cannot redefine")) return "remove one of the two";
  if (contains(description, "end-of-file")) return "complete it";
  return "a line is KEY = VALUE or [TABLE]; a text is in quotes";
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& source,
                       const std::string& remedy) {
  try {
    return toml::parse(text, source);
  } catch (const toml::parse_error& error) {
    throw InvalidArgument(fmt::format("{}:{}", source, error.source().begin.line),
                          reason_of(error.description()),
                          remedy.empty() ? remedy_for(error.description()) : remedy);
  }
}

std::string TomlTable::place(const std::string& key) const {
  const toml::node* node = table_.get(key);
  const auto line = (node != nullptr ? node->source() : table_.source()).begin.line;
  const bool both = !path_.empty() && !key.empty();
  return fmt::format("{}:{}: {}{}{}", source_, line, path_, both ? "." : "", key);
}

std::string TomlTable::place(const std::string& sub_table, const std::string& key) const {
  const std::string path = path_.empty() ? sub_table : path_ + "." + sub_table;
  const auto* table = table_.get_as<toml::table>(sub_table);
  const bool has_key = table != nullptr && table->contains(key);
  return TomlTable(has_key ? *table : table_, source_, path).place(key);
}

const toml::node* TomlTable::find(const std::string& key) {
  known_.insert(key);
  return table_.get(key);
}

std::optional<ordered_json> TomlTable::value(const std::string& key, ValueForm::Kind kind) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  switch (kind) {
    case ValueForm::Kind::number:
    case ValueForm::Kind::integer:
      return number(*node, place(key));
    case ValueForm::Kind::rate:
      if (node->is_string()) return node->as_string()->get();
      return number(*node, place(key));
    case ValueForm::Kind::vector:
      return numbers(*node, 3, place(key));
    case ValueForm::Kind::quaternion:
      return numbers(*node, 4, place(key));
    case ValueForm::Kind::size:
      return numbers(*node, 2, place(key));
    case ValueForm::Kind::text:
      return text(*node, "must be a string", place(key));
    case ValueForm::Kind::texts:
      return texts(*node, place(key));
    case ValueForm::Kind::vectors:
      return vectors(*node, place(key));
    case ValueForm::Kind::flag:
      if (!node->is_boolean()) throw InvalidArgument(place(key), "must be true or false");
      return node->as_boolean()->get();
  }
  return std::nullopt;
}

std::optional<std::vector<std::array<double, 2>>> TomlTable::number_or_pairs(
    const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (node->is_number()) return std::vector{std::array{0.0, number(*node, place(key))}};
  if (!node->is_array()) {
    throw InvalidArgument(place(key), "must be a number or an array of pairs of numbers");
  }
  std::vector<std::array<double, 2>> pairs;
  for (const toml::node& entry : *node->as_array()) {
    pairs.push_back(numbers(entry, 2, place(key)).get<std::array<double, 2>>());
  }
  return pairs;
}

std::optional<Eigen::Matrix3d> TomlTable::matrix(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* rows = node->as_array();
  const auto is_row = [](const toml::node& row) {
    return row.is_array() && row.as_array()->size() == 3;
  };
  if (rows == nullptr || rows->size() != 3 || !std::ranges::all_of(*rows, is_row)) {
    throw InvalidArgument(place(key), "must be an array of three rows of three numbers",
                          "give [[Ixx, Ixy, Ixz], [Ixy, Iyy, Iyz], [Ixz, Iyz, Izz]]");
  }
  Eigen::Matrix3d matrix;
  for (Eigen::Index i = 0; i < 3; ++i) {
    matrix.row(i) = to_vector(numbers((*rows)[static_cast<std::size_t>(i)], 3, place(key)));
  }
  return matrix;
}

ordered_json TomlTable::required(const std::string& key, ValueForm::Kind kind) {
  if (auto found = value(key, kind)) return *found;
  throw InvalidArgument(place(key), "is missing");
}

Eigen::Vector3d TomlTable::vector(const std::string& key, const limits::Limit& limit,
                                  const Eigen::Vector3d& otherwise) {
  const auto found = value(key, ValueForm::Kind::vector);
  return found ? limits::check(limit, place(key), to_vector(*found)) : otherwise;
}

double TomlTable::required_number(const std::string& key, const limits::Limit& limit) {
  return limits::check(limit, place(key), required(key, ValueForm::Kind::number).get<double>());
}

Eigen::Vector3d TomlTable::required_vector(const std::string& key, const limits::Limit& limit) {
  return limits::check(limit, place(key), to_vector(required(key, ValueForm::Kind::vector)));
}

std::string TomlTable::required_text(const std::string& key) {
  return required(key, ValueForm::Kind::text).get<std::string>();
}

void TomlTable::table(const std::string& key, const std::function<void(TomlTable&)>& read) {
  if (const toml::node* node = find(key)) {
    if (!node->is_table()) throw InvalidArgument(place(key), "must be a table");
    TomlTable sub(*node->as_table(), source_, path_.empty() ? key : path_ + "." + key);
    read(sub);
    sub.finish();
  }
}

void TomlTable::tables(const std::string& key, const std::function<void(TomlTable&)>& read) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  if (!node->is_array_of_tables()) {
    throw InvalidArgument(place(key), fmt::format("must be an array of tables, [[{}]]", key));
  }
  std::size_t index = 0;
  for (const toml::node& entry : *node->as_array()) {
    const std::string name = path_.empty() ? key : path_ + "." + key;
    TomlTable sub(*entry.as_table(), source_, fmt::format("{}[{}]", name, index++));
    read(sub);
    sub.finish();
  }
}

void TomlTable::finish() const {
  for (const auto& [key, node] : table_) {
    const std::string name(key.str());
    if (known_.contains(name)) continue;
    const std::vector<std::string> candidates(known_.begin(), known_.end());
    throw unknown_name(fmt::format("{}:{}: {}", source_, key.source().begin.line,
                                   path_.empty() ? "top level" : path_),
                       name, candidates);
  }
}

}  // namespace twrench::scene
