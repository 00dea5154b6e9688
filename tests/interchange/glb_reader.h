#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "interchange/gltf.h"

namespace twrench::interchange {

/// Reads a .glb according to its specification, independently of the code that writes it.
class GlbReader {
 public:
  explicit GlbReader(const std::string& bytes) : bytes_(bytes) {
    EXPECT_EQ(word(0), 0x46546C67U);
    EXPECT_EQ(word(4), 2U);
    EXPECT_EQ(word(8), bytes.size());
    const std::uint32_t length = word(12);
    EXPECT_EQ(word(16), 0x4E4F534AU);
    json = nlohmann::json::parse(bytes.substr(20, length));
    EXPECT_EQ(word(20 + length), json["buffers"][0]["byteLength"]);
    EXPECT_EQ(word(24 + length), 0x004E4942U);
    EXPECT_EQ((20 + length) % 4, 0U);
    buffer_ = 28 + length;
  }

  /// The words of an accessor.
  std::vector<std::uint32_t> words(std::size_t accessor) const {
    const auto& a = json["accessors"][accessor];
    const auto& view = json["bufferViews"][a["bufferView"].get<std::size_t>()];
    const std::size_t components = a["type"] == "SCALAR" ? 1 : a["type"] == "VEC3" ? 3 : 4;
    const auto count = components * a["count"].get<std::size_t>();
    EXPECT_EQ(view["byteLength"], 4 * count);
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < count; ++i)
      found.push_back(word(buffer_ + view["byteOffset"].get<std::size_t>() + 4 * i));
    return found;
  }

  std::vector<float> floats(std::size_t accessor) const {
    EXPECT_EQ(json["accessors"][accessor]["componentType"], 5126);
    std::vector<float> found;
    for (const std::uint32_t word : words(accessor)) found.push_back(std::bit_cast<float>(word));
    return found;
  }

  /// The index of the node with that name.
  std::size_t node(const std::string& name) const {
    std::size_t i = 0;
    while (json["nodes"].at(i)["name"] != name) ++i;
    return i;
  }

  /// The sampler that animates the node.
  nlohmann::json sampler(const std::string& name, const std::string& path) const {
    const auto& animation = json["animations"][0];
    for (const auto& channel : animation["channels"]) {
      if (channel["target"]["node"] == node(name) && channel["target"]["path"] == path)
        return animation["samplers"][channel["sampler"].get<std::size_t>()];
    }
    ADD_FAILURE() << "no channel " << path << " of " << name;
    return {};
  }

  nlohmann::json json;

 private:
  std::uint32_t word(std::size_t at) const {
    std::uint32_t number = 0;
    for (std::size_t i = 4; i-- > 0;)
      number = number << 8U | static_cast<unsigned char>(bytes_.at(at + i));
    return number;
  }

  std::string bytes_;
  std::size_t buffer_ = 0;
};

inline std::string glb_of(const Gltf& gltf) {
  std::string bytes;
  gltf.write_glb([&](std::string_view piece) { bytes += piece; });
  return bytes;
}

}  // namespace twrench::interchange
