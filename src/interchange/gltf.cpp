#include "interchange/gltf.h"

#include <algorithm>
#include <bit>
#include <vector>

namespace twrench::interchange {
namespace {

// Constants of the glTF 2.0 specification.
constexpr int array_buffer = 34962, element_array_buffer = 34963, no_target = 0;
constexpr int component_float = 5126, component_unsigned_int = 5125;
constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A,
                        binary_chunk = 0x004E4942;

/// Appends the bytes of a number, least significant first, as glTF requires on every machine.
void append(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(static_cast<unsigned char>(number >> shift));
  }
}

const char* type_of(std::size_t components) {
  return components == 1 ? "SCALAR" : components == 3 ? "VEC3" : "VEC4";
}

}  // namespace

Gltf::Gltf(const std::string& generator)
    : root_{{"asset", {{"version", "2.0"}, {"generator", generator}}}, {"scene", 0}} {}

std::size_t Gltf::add(const std::string& array, Json object) {
  Json& objects = root_[array];
  objects.push_back(std::move(object));
  return objects.size() - 1;
}

std::size_t Gltf::add_view(std::size_t begin, int target) {
  Json view{{"buffer", 0}, {"byteOffset", begin}, {"byteLength", buffer_.size() - begin}};
  if (target != no_target) view["target"] = target;
  return add("bufferViews", std::move(view));
}

std::size_t Gltf::add_floats(std::span<const float> numbers, std::size_t components, Use use) {
  const std::size_t begin = buffer_.size();
  const std::span<const float> first = numbers.first(components);
  std::vector<float> least(first.begin(), first.end()), greatest = least;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    append(buffer_, std::bit_cast<std::uint32_t>(numbers[i]));
    float& low = least[i % components];
    float& high = greatest[i % components];
    low = std::min(low, numbers[i]);
    high = std::max(high, numbers[i]);
  }
  const std::size_t view = add_view(begin, use == Use::vertices ? array_buffer : no_target);
  return add("accessors", {{"bufferView", view},
                           {"componentType", component_float},
                           {"count", numbers.size() / components},
                           {"type", type_of(components)},
                           {"min", least},
                           {"max", greatest}});
}

std::size_t Gltf::add_indices(std::span<const std::uint32_t> indices) {
  const std::size_t begin = buffer_.size();
  for (const std::uint32_t index : indices) append(buffer_, index);
  return add("accessors", {{"bufferView", add_view(begin, element_array_buffer)},
                           {"componentType", component_unsigned_int},
                           {"count", indices.size()},
                           {"type", "SCALAR"}});
}

void Gltf::write_glb(const std::function<void(std::string_view)>& write) const {
  Json document = root_;
  document["buffers"][0]["byteLength"] = buffer_.size();
  std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.append((4 - text.size() % 4) % 4, ' ');  // chunks end at multiples of four bytes
  const auto json_length = static_cast<std::uint32_t>(text.size());
  const auto binary_length = static_cast<std::uint32_t>(buffer_.size());
  constexpr std::uint32_t header_length = 12, chunk_header_length = 8;
  std::string head;
  for (const std::uint32_t number :
       {magic, version, header_length + 2 * chunk_header_length + json_length + binary_length,
        json_length, json_chunk}) {
    append(head, number);
  }
  std::string binary_head;
  append(binary_head, binary_length);
  append(binary_head, binary_chunk);
  for (const std::string_view piece : {std::string_view(head), std::string_view(text),
                                       std::string_view(binary_head), std::string_view(buffer_)}) {
    write(piece);
  }
}

}  // namespace twrench::interchange
