#include "video/manifest_value.h"

#include <cmath>
#include <utility>

#include "system/error.h"

namespace twrench::video {

ManifestValue::ManifestValue(const nlohmann::ordered_json& value, std::string manifest,
                             std::string path)
    : value_(value), manifest_(std::move(manifest)), path_(std::move(path)) {}

void ManifestValue::fail(const std::string& expected) const {
  throw system::FileError("cannot use " + manifest_,
                          fmt::format("{} must be {}", path_.empty() ? "it" : path_, expected));
}

ManifestValue ManifestValue::key(const char* name) const {
  if (!value_.is_object() || !value_.contains(name))
    fail(fmt::format("an object with \"{}\"", name));
  return {value_[name], manifest_, path_.empty() ? name : path_ + "." + name};
}

ManifestValue ManifestValue::item(std::size_t index) const {
  return {value_[index], manifest_, fmt::format("{}[{}]", path_, index)};
}

std::size_t ManifestValue::size_of_array() const {
  if (!value_.is_array()) fail("an array");
  return value_.size();
}

std::string ManifestValue::text() const {
  if (!value_.is_string()) fail("a string");
  return value_.get<std::string>();
}

double ManifestValue::number() const {
  if (!value_.is_number() || !std::isfinite(value_.get<double>())) fail("a number");
  return value_.get<double>();
}

int ManifestValue::integer(int least, int most) const {
  const double number = value_.is_number_integer() ? value_.get<double>() : std::nan("");
  if (!(number >= least && number <= most)) {
    fail(fmt::format("an integer from {} to {}", least, most));
  }
  return static_cast<int>(number);
}

}  // namespace twrench::video
