// A video drawn by several runs that share a folder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/twrench.h"
#include "run_command.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Every second one of 24 frames is requested.
const std::string sharded_film =
    "render --size 64x36 --fps 10 --duration 14.4 --speed 6 --frames 0-23:2 --progress none ";

std::string decoded(const ScratchFolder& folder, const std::string& video) {
  const std::string sums = (folder / (video + ".md5")).string();
  run_command("ffmpeg -v error -y -i '" + (folder / video).string() + "' -f framemd5 '" + sums +
              "'");
  return text_of(sums);
}

TEST(Shards, AreTheSameFilmInAnyOrderWithAnyJobs) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, sharded_film + "--frames-dir whole -o whole.mp4").code, 0);
  const auto whole = digests(folder / "whole");
  ASSERT_EQ(whole.size(), 12u);
  for (const int count : {1, 3, 5}) {
    const std::string shared = "shared" + std::to_string(count);
    for (int i = count; i >= 1; --i) {  // the last first
      const std::string shard = std::to_string(i) + "/" + std::to_string(count);
      const Outcome run =
          run_twrench(folder, sharded_film + "--frames-dir " + shared + " --shard " + shard +
                                  " --jobs " + std::to_string(1 + i % 3));
      ASSERT_EQ(run.code, 0) << run.err;
    }
    EXPECT_EQ(digests(folder / shared), whole);
    ASSERT_EQ(run_twrench(folder, "encode " + shared + " -o s.mp4 --progress none").code, 0);
    EXPECT_EQ(decoded(folder, "s.mp4"), decoded(folder, "whole.mp4"));
  }
}

TEST(Shards, MayRunAtOnce) {
  const ScratchFolder folder;
  const std::string shard = "\"$TWRENCH\" " + sharded_film + "--frames-dir f --shard ";
  const Outcome run = run_shell(folder, shard + "1/3 & a=$!; " + shard + "2/3 & b=$!; " + shard +
                                            "3/3 && wait $a && wait $b");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run_twrench(folder, "encode f -o s.mp4 --progress none").code, 0);
}

TEST(Shards, ThatAreMissingAreNamed) {
  const ScratchFolder folder;
  for (const char* shard : {"1/4", "3/4"}) {
    ASSERT_EQ(run_twrench(folder, sharded_film + "--frames-dir f --shard " + shard).code, 0);
  }
  const Outcome refused = run_twrench(folder, "encode f -o s.mp4 --progress none");
  EXPECT_EQ(refused.code, 5);
  EXPECT_THAT(refused.err, HasSubstr("frames are missing: 6,8,10,18,20,22"));
  EXPECT_FALSE(fs::exists(folder / "s.mp4"));
  const Outcome allowed = run_twrench(folder, "encode f -o s.mp4 --progress none --allow-missing");
  EXPECT_EQ(allowed.code, 0);
  EXPECT_THAT(allowed.err, HasSubstr("lacks the missing frames 6,8,10,18,20,22"));
}

TEST(Shards, AreGoneOnWithByThemselvesAndByAWholeRun) {
  const ScratchFolder folder;
  for (const char* shard : {"1/2", "2/2"}) {
    ASSERT_EQ(run_twrench(folder, sharded_film + "--frames-dir f --shard " + shard).code, 0);
  }
  const auto before = digests(folder / "f");
  const auto time = fs::last_write_time(folder / "f/frame_000004.png");
  fs::remove(folder / "f/frame_000002.png");
  ASSERT_EQ(run_twrench(folder, sharded_film + "--frames-dir f --resume --shard 1/2").code, 0);
  fs::remove(folder / "f/frame_000022.png");
  ASSERT_EQ(run_twrench(folder, sharded_film + "--frames-dir f --resume --no-video").code, 0);
  EXPECT_EQ(digests(folder / "f"), before);
  EXPECT_EQ(fs::last_write_time(folder / "f/frame_000004.png"), time) << "drawn again";
}

TEST(Shards, RefuseAnotherFilmsFolderEvenToResume) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, sharded_film + "--frames-dir f --shard 1/2").code, 0);
  const std::string other = sharded_film + "--background white --frames-dir f --shard 2/2 ";
  const Outcome run = run_twrench(folder, other + "--resume");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("manifest.0001-of-0002.json"));
  ASSERT_EQ(run_twrench(folder, other + "--overwrite").code, 0);
  EXPECT_FALSE(fs::exists(folder / "f/manifest.0001-of-0002.json")) << "its frames are going";
}

TEST(Shards, MakeNoVideo) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, sharded_film + "--shard 1/2 -o a.mp4").code, 2);
  EXPECT_EQ(run_twrench(folder, sharded_film + "--shard 3/2").code, 2);
  EXPECT_EQ(run_twrench(folder, sharded_film + "--shard 1/2 --no-frames").code, 2);
  ASSERT_EQ(run_twrench(folder, sharded_film + "--shard 1/20").code, 0)
      << "it has no frame to draw";
  EXPECT_FALSE(fs::exists(folder / "out/dzhanibekov.mp4"));
}

}  // namespace
}  // namespace twrench
