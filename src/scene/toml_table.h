#pragma once

#include <toml++/toml.h>

#include <Eigen/Core>
#include <array>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/limits.h"
#include "scene/value_form.h"

namespace twrench::scene {

/// Parses the text of `source`. Throws InvalidArgument that names the line of a mistake in the
/// syntax, with `remedy`, or if that is empty with one for the mistake.
toml::table parse_toml(std::string_view text, const std::string& source,
                       const std::string& remedy = {});

/// A TOML table that is read key by key into values that already hold their defaults. Every
/// mistake, including a key that is never requested (reported by finish()), is an InvalidArgument
/// that names the file, the line, the key and the allowed values.
class TomlTable {
 public:
  /// `path` names the table in messages: "motion", "part[2]"; empty for the whole file.
  TomlTable(const toml::table& table, std::string source, std::string path)
      : table_(table), source_(std::move(source)), path_(std::move(path)) {}

  bool has(const std::string& key) const { return table_.contains(key); }

  /// Returns whether the value is a string.
  bool is_text(const std::string& key) const { return table_[key].is_string(); }

  /// Returns the value in the form of `kind`, or nothing if the key is absent.
  std::optional<nlohmann::ordered_json> value(const std::string& key, ValueForm::Kind kind);

  /// Returns the numbers of an array of pairs. A single number x is returned as the pair (0, x).
  /// Nothing if the key is absent.
  std::optional<std::vector<std::array<double, 2>>> number_or_pairs(const std::string& key);

  /// Returns the matrix of three rows, or nothing if the key is absent.
  std::optional<Eigen::Matrix3d> matrix(const std::string& key);

  /// Returns a vector whose components are within `limit`; `otherwise` if the key is absent.
  Eigen::Vector3d vector(const std::string& key, const limits::Limit& limit,
                         const Eigen::Vector3d& otherwise);

  /// Return a required value. Throw InvalidArgument if the key is absent.
  double required_number(const std::string& key, const limits::Limit& limit);
  Eigen::Vector3d required_vector(const std::string& key, const limits::Limit& limit);
  std::string required_text(const std::string& key);

  /// Calls `read` with the sub-table if it is present, then finishes it.
  void table(const std::string& key, const std::function<void(TomlTable&)>& read);
  /// Calls `read` for each table of the array if it is present, and finishes each.
  void tables(const std::string& key, const std::function<void(TomlTable&)>& read);

  /// Returns "FILE:LINE: KEY", the start of a message about that key, or about the table if the key
  /// is empty.
  std::string place(const std::string& key) const;

  /// Returns the place of a key of a sub-table, or of this table if it does not have that key.
  std::string place(const std::string& sub_table, const std::string& key) const;

  /// Throws InvalidArgument if the table has a key that was not requested.
  void finish() const;

 private:
  const toml::node* find(const std::string& key);
  nlohmann::ordered_json required(const std::string& key, ValueForm::Kind kind);

  const toml::table& table_;
  std::string source_;
  std::string path_;
  std::set<std::string> known_;
};

}  // namespace twrench::scene
