#include "video/frame_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "scratch_folder.h"
#include "system/bytes.h"
#include "system/error.h"
#include "system/file.h"
#include "video/manifest.h"

namespace twrench::video {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

Manifest head(const std::string& range) {
  return {.version = "0.1.0",
          .scene = nlohmann::ordered_json::object(),
          .renderer = "none",
          .width = 16,
          .height = 9,
          .fps = 60,
          .encoder = {},
          .range = range,
          .frames = {}};
}

/// A record that outlives the sequences.
const FrameRecord& record(int frame) {
  static const std::vector<FrameRecord> records = [] {
    std::vector<FrameRecord> result(100);
    for (int i = 0; i < 100; ++i) {
      result[static_cast<std::size_t>(i)].frame = i;
      result[static_cast<std::size_t>(i)].t = i / 10.0;
    }
    return result;
  }();
  return records.at(static_cast<std::size_t>(frame));
}

std::vector<int> numbers(const Manifest& manifest) {
  std::vector<int> result;
  for (const FrameRecord& frame : manifest.frames) {
    result.push_back(frame.frame);
  }
  return result;
}

TEST(FrameSequence, WritesFramesAndTheirManifest) {
  const ScratchFolder scratch;
  const std::vector<std::uint8_t> first{1, 2, 3};
  const std::vector<std::uint8_t> second{4, 5};
  FrameSequence sequence(scratch / "deep/er", head("3-7"));
  sequence.write(record(7), second);
  sequence.write(record(3), first);
  sequence.finish();

  EXPECT_EQ(system::read_file(scratch / "deep/er/frame_000003.png", 10), first);
  EXPECT_EQ(system::read_file(scratch / "deep/er/frame_000007.png", 10), second);
  const Manifest manifest = read_manifest(scratch / "deep/er/manifest.json");
  ASSERT_THAT(numbers(manifest), ElementsAre(3, 7));
  EXPECT_EQ(manifest.frames[1].file, "frame_000007.png");
  EXPECT_EQ(manifest.frames[1].sha256, system::sha256_hex(second));
  EXPECT_EQ(manifest.frames[1].t, 0.7);
}

TEST(FrameSequence, TakesFramesFromManyThreads) {
  constexpr int count = 40;
  const ScratchFolder scratch;
  FrameSequence sequence(scratch.path(), head("0-39"));
  std::vector<std::thread> threads(4);
  for (int k = 0; k < 4; ++k) {
    threads[static_cast<std::size_t>(k)] = std::thread([&sequence, k] {
      for (int frame = count - 1 - k; frame >= 0; frame -= 4) {
        sequence.write(record(frame), std::vector<std::uint8_t>{static_cast<std::uint8_t>(frame)});
      }
    });
  }
  std::for_each(threads.begin(), threads.end(), [](std::thread& thread) { thread.join(); });
  sequence.finish();
  const Manifest manifest = read_manifest(scratch / manifest_name);
  ASSERT_EQ(manifest.frames.size(), std::size_t{count});
  for (int frame = 0; frame < count; ++frame) {
    EXPECT_EQ(manifest.frames[static_cast<std::size_t>(frame)].frame, frame);
  }
}

TEST(FrameSequence, TellsOfItsFramesWhenTheRunFails) {
  const ScratchFolder scratch;
  try {
    FrameSequence sequence(scratch.path(), head("0-9"));
    sequence.write(record(0), {});
    sequence.finish();
    sequence.write(record(1), {});
    throw std::runtime_error("the run fails");
  } catch (const std::runtime_error&) {
  }
  EXPECT_THAT(numbers(read_manifest(scratch / manifest_name)), ElementsAre(0, 1));
}

TEST(FrameSequence, WithoutAFrameTouchesNoManifest) {
  const ScratchFolder scratch;
  system::write_file_atomically(scratch / manifest_name, std::string_view("of another run"));
  { const FrameSequence sequence(scratch.path(), head("0-9")); }
  EXPECT_EQ(system::read_file(scratch / manifest_name, 100).size(), 14U);
}

// Otherwise another run could find frames of unknown origin.
TEST(FrameSequence, HasAManifestBeforeAFrame) {
  const ScratchFolder scratch;
  Manifest shard = head("0-9");
  shard.shard = {2, 3};
  std::filesystem::create_directory(scratch / "frame_000000.png");  // the write fails
  FrameSequence sequence(scratch.path(), shard);
  EXPECT_THROW(sequence.write(record(0), {}), system::FileError);
  EXPECT_TRUE(read_manifest(scratch / "manifest.0002-of-0003.json").frames.empty());
}

TEST(FrameSequence, AFrameThatCannotBeWrittenIsNotTold) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "frame_000001.png");
  {
    FrameSequence sequence(scratch.path(), head("0-9"));
    sequence.write(record(0), {});
    EXPECT_THROW(sequence.write(record(1), {}), system::FileError);
  }
  EXPECT_THAT(numbers(read_manifest(scratch / manifest_name)), ElementsAre(0));
  EXPECT_THAT(scratch.names(),
              UnorderedElementsAre("frame_000000.png", "frame_000001.png", "manifest.json"));
}

TEST(FrameSequence, NeedsAFolder) {
  const ScratchFolder scratch;
  system::write_file_atomically(scratch / "file", std::string_view("x"));
  try {
    const FrameSequence sequence(scratch / "file", head("0-9"));
    FAIL();
  } catch (const system::FileError& error) {
    EXPECT_EQ(error.what(),
              "cannot create the folder " + (scratch / "file").string() + ": Not a directory");
  }
  EXPECT_THROW(FrameSequence(scratch / "file/deeper", head("0-9")), system::FileError);
}

}  // namespace
}  // namespace twrench::video
