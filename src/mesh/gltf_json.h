#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "system/error.h"

namespace twrench::mesh {

/// A value in the JSON of a glTF file. It knows its place, which messages quote.
class GltfValue {
 public:
  /// The whole document; it must outlive the value.
  GltfValue(const std::string& file, const nlohmann::json& json) : file_(&file), json_(&json) {}

  /// Returns the place of the value: "nodes[3].mesh".
  const std::string& place() const { return place_; }

  /// Returns the error about this value: "cannot read FILE: PLACE WHY".
  system::FileError bad(const std::string& why) const;

  /// Returns the value under a key of an object; nothing if there is none.
  std::optional<GltfValue> find(const char* key) const;
  GltfValue at(const char* key) const;

  /// Returns the number of entries of an array; throws if the value is not an array.
  std::size_t size() const;
  GltfValue at(std::uint64_t index) const;
  /// Returns the number of entries of the array under a key; 0 if there is none.
  std::size_t size(const char* key) const;

  // The value as the required type; each throws if it is of another type.
  std::uint64_t whole() const;
  double number() const;
  bool boolean() const;
  const std::string& text() const;
  std::vector<double> numbers(std::size_t count) const;

  std::uint64_t whole_or(const char* key, std::uint64_t otherwise) const;

 private:
  GltfValue(const GltfValue& parent, const nlohmann::json& json, std::string place)
      : file_(parent.file_), json_(&json), place_(std::move(place)) {}

  const std::string* file_;
  const nlohmann::json* json_;
  std::string place_;
};

}  // namespace twrench::mesh
