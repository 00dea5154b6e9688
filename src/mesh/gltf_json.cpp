#include "mesh/gltf_json.h"

#include <fmt/format.h>

#include <cmath>

namespace twrench::mesh {

system::FileError GltfValue::bad(const std::string& why) const {
  return {"cannot read " + *file_, fmt::format("its {} {}", place_.empty() ? "JSON" : place_, why)};
}

std::optional<GltfValue> GltfValue::find(const char* key) const {
  if (!json_->is_object()) throw bad("is no object");
  const auto found = json_->find(key);
  if (found == json_->end()) return {};
  return GltfValue(*this, *found, place_.empty() ? key : place_ + "." + key);
}

GltfValue GltfValue::at(const char* key) const {
  if (auto found = find(key)) return *std::move(found);
  throw bad(fmt::format("has no '{}'", key));
}

std::size_t GltfValue::size() const {
  if (!json_->is_array()) throw bad("is no array");
  return json_->size();
}

GltfValue GltfValue::at(std::uint64_t index) const {
  if (index >= size())
    throw bad(fmt::format("has {} entries, but {} is referred to", size(), index));
  return {*this, (*json_)[index], fmt::format("{}[{}]", place_, index)};
}

std::size_t GltfValue::size(const char* key) const {
  const std::optional<GltfValue> list = find(key);
  return list ? list->size() : 0;
}

std::uint64_t GltfValue::whole() const {
  if (!json_->is_number_unsigned()) throw bad("is no whole number");
  return json_->get<std::uint64_t>();
}

double GltfValue::number() const {
  if (!json_->is_number()) throw bad("is no number");
  return json_->get<double>();
}

bool GltfValue::boolean() const {
  if (!json_->is_boolean()) throw bad("is neither true nor false");
  return json_->get<bool>();
}

const std::string& GltfValue::text() const {
  if (!json_->is_string()) throw bad("is no text");
  return json_->get_ref<const std::string&>();
}

std::vector<double> GltfValue::numbers(std::size_t count) const {
  if (size() != count) throw bad(fmt::format("must have {} numbers", count));
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(at(i).number());
  return values;
}

std::uint64_t GltfValue::whole_or(const char* key, std::uint64_t otherwise) const {
  const std::optional<GltfValue> value = find(key);
  return value ? value->whole() : otherwise;
}

}  // namespace twrench::mesh
