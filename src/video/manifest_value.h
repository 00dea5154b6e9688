#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace twrench::video {

/// A value of a manifest and its path, such as "frames[3].X", for error messages. Refers to the
/// JSON, which must outlive it. The functions that read a value throw FileError if it has another
/// form.
class ManifestValue {
 public:
  /// `manifest` names the manifest in messages; `path` is empty for the whole of it.
  ManifestValue(const nlohmann::ordered_json& value, std::string manifest, std::string path);

  /// Throws FileError "cannot use MANIFEST: PATH must be EXPECTED".
  [[noreturn]] void fail(const std::string& expected) const;

  const nlohmann::ordered_json& value() const { return value_; }

  /// Returns the value of a key of an object.
  ManifestValue key(const char* name) const;
  /// Returns an item of an array, which must have that index.
  ManifestValue item(std::size_t index) const;
  std::size_t size_of_array() const;

  std::string text() const;
  /// A finite number.
  double number() const;
  int integer(int least, int most) const;
  /// An array of exactly N numbers.
  template <std::size_t N>
  std::array<double, N> numbers() const {
    const auto is_number = [](const nlohmann::ordered_json& item) { return item.is_number(); };
    if (!value_.is_array() || value_.size() != N ||
        !std::all_of(value_.begin(), value_.end(), is_number)) {
      fail(fmt::format("an array of {} numbers", N));
    }
    return value_.get<std::array<double, N>>();
  }

 private:
  const nlohmann::ordered_json& value_;
  std::string manifest_;
  std::string path_;
};

}  // namespace twrench::video
