#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scratch_folder.h"
#include "system/bytes.h"
#include "system/file.h"
#include "video/frame_sequence.h"
#include "video/manifest.h"

namespace twrench::video {
namespace {

constexpr int drawn_frame = 3;

/// A folder with one frame and the manifest that records it.
class EarlierRunTest : public testing::Test {
 protected:
  EarlierRunTest() {
    film.version = "0.1.0";
    film.scene = nlohmann::ordered_json::object();
    film.renderer = "none";
    film.width = film.height = 16;
    film.fps = 25;
    film.range = "0-9";
    record.frame = drawn_frame;
    record.t = 0.12;
    for (std::size_t i = 0; i < 9; ++i) record.X[i] = 0.1 * static_cast<double>(i);
    for (std::size_t i = 0; i < 16; ++i) {
      record.view[i] = 1 + static_cast<double>(i);
      record.projection[i] = 20 + static_cast<double>(i);
    }
    const std::vector<std::uint8_t> picture{1, 2, 3};
    record.file = frame_file_name(drawn_frame);
    record.sha256 = system::sha256_hex(picture);
    system::write_file_atomically(folder / record.file, picture);
    Manifest written = film;
    written.frames = {record};
    system::write_file_atomically(folder / manifest_file_name(film.shard),
                                  format_manifest(written));
  }

  /// Returns whether the frame on disk is kept for a run that wants the record with `change`
  /// applied.
  bool is_kept(const std::function<void(FrameRecord&)>& change) {
    FrameRecord wanted = record;
    change(wanted);
    return EarlierRun(folder.path(), film, {drawn_frame}).intact(wanted).has_value();
  }

  ScratchFolder folder;
  Manifest film;
  FrameRecord record;
};

TEST_F(EarlierRunTest, KeepsAFrameOfTheSameTimePoseAndCamera) {
  EXPECT_TRUE(is_kept([](FrameRecord&) {}));
  EXPECT_FALSE(is_kept([](FrameRecord& wanted) { wanted.frame = 4; })) << "it was not drawn";
}

TEST_F(EarlierRunTest, DrawsAFrameAgainIfAnyNumberOfItsPoseOrCameraDiffers) {
  EXPECT_FALSE(is_kept([](FrameRecord& wanted) { wanted.t = 0.16; }));
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_FALSE(is_kept([i](FrameRecord& wanted) { wanted.X[i] += 1; })) << i;
  }
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_FALSE(is_kept([i](FrameRecord& wanted) { wanted.view[i] += 1; })) << i;
    EXPECT_FALSE(is_kept([i](FrameRecord& wanted) { wanted.projection[i] += 1; })) << i;
  }
}

TEST_F(EarlierRunTest, DrawsAFrameAgainIfItsFileHasChanged) {
  system::write_file_atomically(folder / record.file, std::vector<std::uint8_t>{1, 2, 4});
  EXPECT_FALSE(is_kept([](FrameRecord&) {}));
}

}  // namespace
}  // namespace twrench::video
