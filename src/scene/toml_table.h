#pragma once

#include <toml++/toml.h>

#include <Eigen/Core>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "scene/limits.h"

namespace twrench {

/// A TOML table that is read key by key into values that already hold their defaults. Every
/// mistake, including a key that is never requested (reported by finish()), is a UsageError that
/// names file, line, key and what is allowed.
class TomlTable {
 public:
  /// `path` names the table in messages: "motion", "part[2]"; empty for the whole file.
  TomlTable(const toml::table& table, std::string source, std::string path)
      : table_(table), source_(std::move(source)), path_(std::move(path)) {}

  bool has(const std::string& key) const { return table_.contains(key); }

  // Each leaves `value` unchanged if the key is absent.
  void number(const std::string& key, const limits::Limit& limit, double& value);
  void whole(const std::string& key, const limits::Limit& limit, int& value);
  void text(const std::string& key, std::string& value);
  void vector(const std::string& key, const limits::Limit& limit, Eigen::Vector3d& value);
  void size(const std::string& key, const limits::Limit& limit, int& width, int& height);

  /// The same for required keys.
  double required_number(const std::string& key, const limits::Limit& limit);
  Eigen::Vector3d required_vector(const std::string& key, const limits::Limit& limit);
  std::string required_text(const std::string& key);
  std::vector<std::string> required_texts(const std::string& key);

  /// Calls `read` with the sub-table if it is present, then finishes it.
  void table(const std::string& key, const std::function<void(TomlTable&)>& read);
  /// Calls `read` for each table of the array if it is present, and finishes each.
  void tables(const std::string& key, const std::function<void(TomlTable&)>& read);

  /// Returns "FILE:LINE: KEY", the start of a message about that key.
  std::string place(const std::string& key) const;

  /// Throws UsageError if the table has a key that was not requested.
  void finish() const;

 private:
  const toml::node* find(const std::string& key);
  double number_in(const toml::node& node, const std::string& what) const;
  std::vector<double> numbers(const toml::node& node, const std::string& key, std::size_t count);
  void require(const std::string& key) const;

  const toml::table& table_;
  std::string source_;
  std::string path_;
  std::set<std::string> known_;
};

}  // namespace twrench
