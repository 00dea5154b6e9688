#include "mesh/gltf_accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "mesh/binary.h"

namespace twrench::mesh {
namespace {

// glTF's numbers of component types, which are OpenGL's.
constexpr std::uint64_t int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125,
                        float32 = 5126;

std::size_t size_of_component(const GltfValue& type) {
  switch (type.whole()) {
    case int8:
    case uint8:
      return 1;
    case int16:
    case uint16:
      return 2;
    case uint32:
    case float32:
      return 4;
    default:
      throw type.bad("is no type of numbers");
  }
}

std::size_t components_of(const GltfValue& type) {
  static const std::map<std::string, std::size_t> components{
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
  const auto found = components.find(type.text());
  if (found == components.end()) throw type.bad("is no type of elements");
  return found->second;
}

template <typename Number>
double component(std::string_view bytes, std::size_t offset, bool normalized) {
  const auto value = static_cast<double>(number_at<Number>(bytes, offset));
  if (!normalized) return value;
  return std::max(value / static_cast<double>(std::numeric_limits<Number>::max()), -1.0);
}

}  // namespace

GltfElements::GltfElements(const GltfValue& place, const GltfValue& type, std::uint64_t count,
                           std::size_t components, GltfBuffers& buffers)
    : type_(type.whole()), count_(count) {
  const std::size_t size = components * size_of_component(type);
  const GltfView view = buffers.view(place.at("bufferView").whole());
  bytes_ = view.bytes;
  stride_ = view.stride.value_or(size);
  const std::uint64_t offset = place.whole_or("byteOffset", 0);
  const bool has_room = offset <= bytes_.size() &&
                        (count_ == 0 || (bytes_.size() - offset >= size &&
                                         count_ - 1 <= (bytes_.size() - offset - size) / stride_));
  if (!has_room) {
    throw place.bad(fmt::format("goes beyond the {} bytes of its buffer view", bytes_.size()));
  }
  bytes_.remove_prefix(offset);
}

bool GltfElements::is_unsigned() const {
  return type_ == uint8 || type_ == uint16 || type_ == uint32;
}

double GltfElements::at(std::size_t element, std::size_t index, bool is_normalized) const {
  const std::size_t begin = element * stride_;
  switch (type_) {
    case int8:
      return component<std::int8_t>(bytes_, begin + index, is_normalized);
    case uint8:
      return component<std::uint8_t>(bytes_, begin + index, is_normalized);
    case int16:
      return component<std::int16_t>(bytes_, begin + 2 * index, is_normalized);
    case uint16:
      return component<std::uint16_t>(bytes_, begin + 2 * index, is_normalized);
    case uint32:
      return component<std::uint32_t>(bytes_, begin + 4 * index, is_normalized);
    default:
      return static_cast<double>(number_at<float>(bytes_, begin + 4 * index));
  }
}

GltfAccessor::GltfAccessor(const GltfValue& accessor, GltfBuffers& buffers)
    : count_(accessor.at("count").whole()), components_(components_of(accessor.at("type"))) {
  if (const auto normalized = accessor.find("normalized")) is_normalized_ = normalized->boolean();
  const GltfValue type = accessor.at("componentType");
  const auto sparse = accessor.find("sparse");
  if (!sparse || accessor.find("bufferView")) {
    elements_.emplace(accessor, type, count_, components_, buffers);
  }
  if (!sparse) return;
  const GltfValue indices = sparse->at("indices"), values = sparse->at("values");
  const std::uint64_t replaced = sparse->at("count").whole();
  sparse_ = {indices, GltfElements(indices, indices.at("componentType"), replaced, 1, buffers),
             GltfElements(values, type, replaced, components_, buffers)};
  if (!sparse_->indices.is_unsigned()) throw indices.bad("are no whole numbers");
}

void GltfAccessor::require_order() const {
  if (!sparse_) return;
  double least = 0.0;
  for (std::size_t i = 0; i < sparse_->indices.size(); ++i) {
    const double index = sparse_->indices.at(i, 0, false);
    if (index >= static_cast<double>(count_)) {
      throw sparse_->place.bad(
          fmt::format("refers to element {}, but there are {}, from 0 on", index, count_));
    }
    if (index < least) throw sparse_->place.bad("is not in order");
    least = index + 1.0;
  }
}

bool GltfAccessor::is_unsigned() const {
  return (elements_ ? *elements_ : sparse_->values).is_unsigned();
}

std::size_t GltfAccessor::replaced_before(std::size_t element) const {
  std::size_t begin = 0, end = sparse_->indices.size();
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    const bool is_before = sparse_->indices.at(middle, 0, false) < static_cast<double>(element);
    (is_before ? begin : end) = is_before ? middle + 1 : middle;
  }
  return begin;
}

double GltfAccessor::at(std::size_t element, std::size_t index) const {
  if (sparse_) {
    const std::size_t n = replaced_before(element);
    const bool is_replaced = n < sparse_->indices.size() &&
                             sparse_->indices.at(n, 0, false) == static_cast<double>(element);
    if (is_replaced) return sparse_->values.at(n, index, is_normalized_);
  }
  return elements_ ? elements_->at(element, index, is_normalized_) : 0.0;
}

}  // namespace twrench::mesh
