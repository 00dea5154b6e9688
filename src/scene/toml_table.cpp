#include "scene/toml_table.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest.h"

namespace twrench {

std::string TomlTable::place(const std::string& key) const {
  const toml::node* node = table_.get(key);
  const auto line = (node != nullptr ? node->source() : table_.source()).begin.line;
  return fmt::format("{}:{}: {}{}{}", source_, line, path_, path_.empty() ? "" : ".", key);
}

const toml::node* TomlTable::find(const std::string& key) {
  known_.insert(key);
  return table_.get(key);
}

double TomlTable::number_in(const toml::node& node, const std::string& what) const {
  // Not value<double>(), which returns nothing for an integer that no double represents exactly.
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  if (const auto* real = node.as_floating_point()) return real->get();
  throw UsageError(what, "must be a number");
}

std::vector<double> TomlTable::numbers(const toml::node& node, const std::string& key,
                                       std::size_t count) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() != count) {
    throw UsageError(place(key), fmt::format("must be an array of {} numbers", count));
  }
  std::vector<double> values;
  for (const toml::node& entry : *array) values.push_back(number_in(entry, place(key)));
  return values;
}

void TomlTable::require(const std::string& key) const {
  if (!has(key)) throw UsageError(place(key), "is missing");
}

void TomlTable::number(const std::string& key, const limits::Limit& limit, double& value) {
  if (const toml::node* node = find(key)) {
    value = limits::check(limit, place(key), number_in(*node, place(key)));
  }
}

void TomlTable::whole(const std::string& key, const limits::Limit& limit, int& value) {
  if (const toml::node* node = find(key)) {
    value = limits::check_whole(limit, place(key), number_in(*node, place(key)));
  }
}

void TomlTable::text(const std::string& key, std::string& value) {
  if (const toml::node* node = find(key)) {
    if (!node->is_string()) throw UsageError(place(key), "must be a string");
    value = node->as_string()->get();
  }
}

void TomlTable::vector(const std::string& key, const limits::Limit& limit, Eigen::Vector3d& value) {
  if (const toml::node* node = find(key)) {
    const std::vector<double> v = numbers(*node, key, 3);
    value = limits::check(limit, place(key), Eigen::Vector3d(v[0], v[1], v[2]));
  }
}

void TomlTable::size(const std::string& key, const limits::Limit& limit, int& width, int& height) {
  if (const toml::node* node = find(key)) {
    const std::vector<double> v = numbers(*node, key, 2);
    width = limits::check_whole(limit, place(key), v[0]);
    height = limits::check_whole(limit, place(key), v[1]);
  }
}

double TomlTable::required_number(const std::string& key, const limits::Limit& limit) {
  require(key);
  double value = 0.0;
  number(key, limit, value);
  return value;
}

Eigen::Vector3d TomlTable::required_vector(const std::string& key, const limits::Limit& limit) {
  require(key);
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  vector(key, limit, value);
  return value;
}

std::string TomlTable::required_text(const std::string& key) {
  require(key);
  std::string value;
  text(key, value);
  return value;
}

std::vector<std::string> TomlTable::required_texts(const std::string& key) {
  require(key);
  const toml::array* array = find(key)->as_array();
  if (array == nullptr || (!array->empty() && !array->is_homogeneous(toml::node_type::string))) {
    throw UsageError(place(key), "must be an array of strings");
  }
  std::vector<std::string> texts;
  for (const toml::node& entry : *array) texts.push_back(entry.as_string()->get());
  return texts;
}

void TomlTable::table(const std::string& key, const std::function<void(TomlTable&)>& read) {
  if (const toml::node* node = find(key)) {
    if (!node->is_table()) throw UsageError(place(key), "must be a table");
    TomlTable sub(*node->as_table(), source_, path_.empty() ? key : path_ + "." + key);
    read(sub);
    sub.finish();
  }
}

void TomlTable::tables(const std::string& key, const std::function<void(TomlTable&)>& read) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  if (!node->is_array_of_tables()) {
    throw UsageError(place(key), fmt::format("must be an array of tables, [[{}]]", key));
  }
  std::size_t index = 0;
  for (const toml::node& entry : *node->as_array()) {
    TomlTable sub(*entry.as_table(), source_, fmt::format("{}[{}]", key, index++));
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

}  // namespace twrench
