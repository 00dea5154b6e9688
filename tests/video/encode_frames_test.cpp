#include "video/encode_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "image/png.h"
#include "run_command.h"
#include "scratch_folder.h"
#include "stub_ffmpeg.h"
#include "system/error.h"
#include "system/file.h"
#include "video/error.h"
#include "video/frame_range.h"
#include "video/frame_sequence.h"

namespace twrench::video {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

image::Image gray(int width, int height, std::size_t level) {
  image::Image image(width, height, 3);
  for (std::uint8_t& value : image.pixels) {
    value = static_cast<std::uint8_t>(level);
  }
  return image;
}

/// Writes the frames `drawn` of a range: frame i has gray level 10 i.
std::filesystem::path draw(const ScratchFolder& scratch, const std::string& range,
                           const std::string& drawn) {
  FrameSequence sequence(scratch / "frames", {.version = "0.1.0",
                                              .scene = nlohmann::ordered_json::object(),
                                              .renderer = "none",
                                              .width = 32,
                                              .height = 16,
                                              .fps = 25,
                                              .encoder = {},
                                              .range = range,
                                              .frames = {}});
  std::vector<FrameRecord> records(100);  // must outlive the sequence's last manifest
  for (const int frame : parse_frame_range(drawn, 100)) {
    FrameRecord& record = records[static_cast<std::size_t>(frame)];
    record.frame = frame;
    sequence.write(record, image::encode_png(gray(32, 16, static_cast<std::size_t>(frame) * 10)));
  }
  sequence.finish();
  return scratch / "frames";
}

std::vector<int> encode_and_count(const std::filesystem::path& folder,
                                  const std::filesystem::path& film) {
  std::vector<int> heard;
  encode_frames(folder, {film}, MissingFrames::refuse,
                [&heard](int done, int) { heard.push_back(done); });
  return heard;
}

/// The error of type `Kind` that stops encoding without leaving a film.
template <typename Kind>
Kind failure(const ScratchFolder& scratch) {
  std::optional<Kind> failure;
  try {
    encode_and_count(scratch / "frames", scratch / "film.mp4");
  } catch (const Kind& error) {
    failure = error;
  }
  EXPECT_FALSE(std::filesystem::exists(scratch / "film.mp4"));
  return failure.value();
}

TEST(EncodeFrames, MakesTheFilmOfTheFramesInOrder) {
  const ScratchFolder scratch;
  draw(scratch, "0-20:5", "0-20:5");
  EXPECT_THAT(encode_and_count(scratch / "frames", scratch / "film.mp4"),
              ElementsAre(1, 2, 3, 4, 5));
  run_command("ffmpeg -v error -i '" + (scratch / "film.mp4").string() +
              "' -f rawvideo -pix_fmt gray '" + (scratch / "film.gray").string() + "'");
  const auto film = system::read_file(scratch / "film.gray", 1'000'000);
  ASSERT_EQ(film.size(), std::size_t{5} * 32 * 16);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(film[k * 32 * 16], 50 * static_cast<int>(k), 2);
  }
}

TEST(EncodeFrames, NamesTheFramesThatWereNeverDrawnOrAreGone) {
  const ScratchFolder scratch;
  draw(scratch, "0-19", "0-4,8-12");
  std::filesystem::remove(scratch / "frames/frame_000010.png");
  const auto error = failure<FramesError>(scratch);
  EXPECT_THAT(error.what(), HasSubstr("frames are missing: 5-7,10,13-19"));
  EXPECT_EQ(error.reason(), FramesError::Reason::missing);
  EXPECT_THAT(error.frames(), ElementsAre(5, 6, 7, 10, 13, 14, 15, 16, 17, 18, 19));
}

TEST(EncodeFrames, LeavesMissingFramesOutWhereItMay) {
  const ScratchFolder scratch;
  const auto frames = draw(scratch, "0-9", "0-4,8");
  std::filesystem::remove(frames / "frame_000002.png");
  const auto film = scratch / "film.mp4";
  EXPECT_THAT(encode_frames(frames, {film}, MissingFrames::leave_out,
                            [](int, int total) { EXPECT_EQ(total, 5); }),
              ElementsAre(2, 5, 6, 7, 9));
  EXPECT_TRUE(std::filesystem::exists(film));
  std::filesystem::remove_all(frames);
  draw(scratch, "0-9", "0");
  std::filesystem::remove(frames / "frame_000000.png");
  EXPECT_THROW(encode_frames(frames, {film}, MissingFrames::leave_out, [](int, int) {}),
               system::FileError)
      << "a film of nothing";
}

TEST(EncodeFrames, RefusesAFileThatIsNotTheOneDrawn) {
  const ScratchFolder scratch;
  draw(scratch, "0-3", "0-3");
  system::write_file_atomically(scratch / "frames/frame_000002.png",
                                image::encode_png(gray(32, 16, 99)));
  const auto error = failure<FramesError>(scratch);
  EXPECT_THAT(error.what(), HasSubstr("frame_000002.png: its contents do not match"));
  EXPECT_EQ(error.reason(), FramesError::Reason::altered);
  EXPECT_THAT(error.frames(), ElementsAre(2));
  EXPECT_THAT(scratch.names(), ElementsAre("frames"));
}

TEST(EncodeFrames, RefusesAFrameOfAnotherSizeThanTheManifestSays) {
  const ScratchFolder scratch;
  draw(scratch, "0", "0");
  const Manifest manifest = read_manifest(scratch / "frames/manifest.json");
  for (const auto& [width, height] : {std::pair{32, 8}, {16, 16}}) {
    const FrameRecord record;
    FrameSequence sequence(scratch / "frames", manifest);
    sequence.write(record, image::encode_png(gray(width, height, 0)));
    sequence.finish();
    EXPECT_THAT(failure<system::FileError>(scratch).what(), HasSubstr("the manifest says 32x16"));
  }
}

TEST(EncodeFrames, RefusesTransparentFramesThatTheContainerCannotKeep) {
  const ScratchFolder scratch;
  draw(scratch, "0-1", "0-1");
  const Manifest manifest = read_manifest(scratch / "frames/manifest.json");
  const auto write = [&](const std::vector<FrameRecord>& records, int first_channels) {
    FrameSequence sequence(scratch / "frames", manifest);
    sequence.write(records[0], image::encode_png(image::Image(32, 16, first_channels)));
    sequence.write(records[1], image::encode_png(image::Image(32, 16, 4)));
    sequence.finish();
  };
  std::vector<FrameRecord> records(2);
  records[1].frame = 1;
  write(records, 4);
  EXPECT_THAT(failure<InvalidArgument>(scratch).remedy(), HasSubstr(".mov or .webm"));
  encode_frames(scratch / "frames", {scratch / "film.mov", Container::mov}, MissingFrames::refuse,
                [](int, int total) { EXPECT_EQ(total, 2); });
  EXPECT_TRUE(std::filesystem::exists(scratch / "film.mov"));
  write(records, 3);
  EXPECT_THAT(failure<system::FileError>(scratch).what(),
              HasSubstr("frame_000001.png: it is transparent, but the first frame is not"));
}

TEST(EncodeFrames, NeedsAManifest) {
  const ScratchFolder scratch;
  EXPECT_THAT(failure<system::FileError>(scratch).what(), HasSubstr("there is no such folder"));
}

TEST(EncodeFrames, KeepsTheFramesWhenFfmpegFails) {
  const ScratchFolder scratch;
  const auto frames = draw(scratch, "0-3", "0-3");
  const StubFfmpeg stub(scratch, "case \"$*\" in *null*) exit 0;; esac; echo dead >&2; exit 1");
  EXPECT_THROW(encode_and_count(frames, scratch / "film.mp4"), EncoderError);
  EXPECT_THAT(scratch.names(), UnorderedElementsAre("bin", "frames"));
  EXPECT_TRUE(std::filesystem::exists(frames / "frame_000003.png"));
}

}  // namespace
}  // namespace twrench::video
