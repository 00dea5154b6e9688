#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include "video/frame_range.h"

namespace twrench::video {
namespace {

TEST(Shard, IsReadAsItIsWritten) {
  EXPECT_EQ(parse_shard("3/10"), (Shard{3, 10}));
  EXPECT_EQ(format_shard({3, 10}), "3/10");
  EXPECT_TRUE(parse_shard("1/1").is_whole());
  for (const char* none : {"", "/", "3", "3/", "/3", "0/3", "4/3", "-1/3", "1/0", "1/-1", "a/3",
                           "1/3 ", " 1/3", "1/3/5", "1/100001", "1/99999999999", "+1/3"}) {
    EXPECT_THROW(parse_shard(none), InvalidArgument) << none;
  }
}

TEST(Shard, AllTogetherAreTheWholeInOrder) {
  for (const int frame_count : {0, 1, 7, 100}) {
    std::vector<int> frames;
    for (int i = 0; i < frame_count; ++i) frames.push_back(10 + 3 * i);
    for (const int count : {1, 2, 7, 9}) {
      std::vector<int> together;
      for (int index = 1; index <= count; ++index) {
        const std::vector<int> part = frames_of_shard(frames, {index, count});
        EXPECT_LE(static_cast<int>(part.size()), frame_count / count + 1);
        EXPECT_GE(static_cast<int>(part.size()), frame_count / count);
        together.insert(together.end(), part.begin(), part.end());
      }
      EXPECT_EQ(together, frames);
    }
  }
}

TEST(Shard, HasAManifestOfItsOwn) {
  EXPECT_EQ(manifest_file_name({}), "manifest.json");
  EXPECT_EQ(manifest_file_name({3, 10}), "manifest.0003-of-0010.json");
  EXPECT_EQ(manifest_file_name({12345, 100000}), "manifest.12345-of-100000.json");
  for (const char* name : {"manifest.json", "manifest.0003-of-0010.json", "manifest.1-of-2.json"}) {
    EXPECT_TRUE(is_manifest_name(name)) << name;
  }
  for (const char* name : {"manifest", "manifest..json", "manifest.0003-of-0002.json", "x.json",
                           ".manifest.json.12-0.tmp", "manifest.3.json", "manifest.json.json"}) {
    EXPECT_FALSE(is_manifest_name(name)) << name;
  }
}

}  // namespace
}  // namespace twrench::video
