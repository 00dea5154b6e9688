#include "interchange/gltf.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "interchange/glb_reader.h"

namespace twrench::interchange {
namespace {

TEST(Gltf, HasItsNumbersBack) {
  Gltf gltf("test");
  const std::vector<float> vectors{1, 2, 3, -4, 0.5F, 7};
  const std::vector<std::uint32_t> indices{0, 1, 65536};
  EXPECT_EQ(gltf.add_floats(vectors, 3, Gltf::Use::vertices), 0U);
  EXPECT_EQ(gltf.add_indices(indices), 1U);
  const GlbReader glb(glb_of(gltf));
  EXPECT_EQ(glb.floats(0), vectors);
  EXPECT_EQ(glb.words(1), indices);
  EXPECT_EQ(glb.json["accessors"][0]["min"], nlohmann::json({-4, 0.5, 3}));
  EXPECT_EQ(glb.json["accessors"][0]["max"], nlohmann::json({1, 2, 7}));
  EXPECT_EQ(glb.json["asset"]["version"], "2.0");
  EXPECT_EQ(glb.json["asset"]["generator"], "test");
}

// Chunks end at multiples of four bytes, whatever the length of the text.
TEST(Gltf, PadsItsText) {
  for (const char* name : {"", "a", "ab", "abc", "\xff"}) {
    Gltf gltf(name);
    gltf.add_floats(std::vector<float>{1}, 1, Gltf::Use::keys);
    const GlbReader glb(glb_of(gltf));
    EXPECT_EQ(glb.floats(0), std::vector<float>{1});
  }
}

}  // namespace
}  // namespace twrench::interchange
