#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "scratch_folder.h"
#include "system/file.h"
#include "video/error.h"
#include "video/frame_range.h"
#include "video/manifest.h"

namespace twrench::video {
namespace {

using ::testing::HasSubstr;

Manifest manifest_of(const std::string& range, const std::string& drawn, Shard shard) {
  Manifest manifest;
  manifest.version = "0.1.0";
  manifest.scene = nlohmann::ordered_json::object();
  manifest.renderer = "none";
  manifest.width = manifest.height = 16;
  manifest.fps = 25;
  manifest.range = range;
  manifest.shard = shard;
  for (const int frame : parse_frame_range(drawn, 100)) {
    FrameRecord record;
    record.frame = frame;
    record.file = frame_file_name(frame);
    record.sha256 = std::string(64, 'a');
    manifest.frames.push_back(record);
  }
  return manifest;
}

void put(const ScratchFolder& scratch, const Manifest& manifest) {
  system::write_file_atomically(scratch / manifest_file_name(manifest.shard),
                                format_manifest(manifest));
}

std::string failure(const ScratchFolder& scratch) {
  try {
    read_manifests(scratch.path());
  } catch (const FramesError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<int> frame_numbers(const Manifest& manifest) {
  std::vector<int> result;
  for (const FrameRecord& record : manifest.frames) result.push_back(record.frame);
  return result;
}

TEST(ManifestFolder, ShardsAreOneFilm) {
  const ScratchFolder scratch;
  put(scratch, manifest_of("0-9", "5-7", {2, 2}));
  put(scratch, manifest_of("0-9", "0-4", {1, 2}));
  put(scratch, manifest_of("4-5,20", "5,20", {}));
  const Manifest all = read_manifests(scratch.path());
  EXPECT_EQ(all.range, "0-9,20");
  EXPECT_EQ(format_frame_range(frame_numbers(all)), "0-7,20");
  EXPECT_TRUE(all.shard.is_whole());
}

TEST(ManifestFolder, OneShardTellsOfTheWholeRange) {
  const ScratchFolder scratch;
  put(scratch, manifest_of("0-9", "0-4", {1, 2}));
  EXPECT_EQ(read_manifests(scratch.path()).range, "0-9") << "the other never began";
}

TEST(ManifestFolder, RefusesAnotherFilmAndSaysWhatIsDifferent) {
  const ScratchFolder scratch;
  put(scratch, manifest_of("0-9", "0-4", {1, 2}));
  Manifest other = manifest_of("0-9", "5-9", {2, 2});
  other.renderer = "another";
  put(scratch, other);
  EXPECT_THAT(failure(scratch), HasSubstr("0002-of-0002.json with manifest.0001-of-0002.json: "
                                          "renderers none and another"));
  other = manifest_of("0-9", "5-9", {2, 2});
  other.scene = {{"name", "x"}};
  put(scratch, other);
  EXPECT_THAT(failure(scratch), HasSubstr("another scene"));
}

TEST(ManifestFolder, RefusesTwoDigestsOfOneFrame) {
  const ScratchFolder scratch;
  put(scratch, manifest_of("0-9", "0-5", {1, 2}));
  Manifest other = manifest_of("0-9", "5-9", {2, 2});
  put(scratch, other);
  EXPECT_EQ(frame_numbers(read_manifests(scratch.path())).size(), 10U) << "twice the same is one";
  other.frames[0].sha256 = std::string(64, 'b');
  put(scratch, other);
  EXPECT_THAT(failure(scratch), HasSubstr("different digests for frame 5"));
}

TEST(ManifestFolder, NeedsAManifest) {
  const ScratchFolder scratch;
  EXPECT_THAT(failure(scratch), HasSubstr("it contains neither manifest.json"));
}

TEST(ManifestFolder, MustBeReadable) {
  const ScratchFolder scratch;
  std::filesystem::create_symlink("loop", scratch / "loop");
  EXPECT_THROW(manifests_in(scratch / "loop"), system::FileError);
  EXPECT_TRUE(manifests_in(scratch / "none").empty());
}

}  // namespace
}  // namespace twrench::video
