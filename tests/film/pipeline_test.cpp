#include "film/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>

#include "gl/context.h"
#include "image/png.h"
#include "scratch_folder.h"
#include "system/error.h"

namespace twrench::film {
namespace {

std::vector<video::FrameRecord> numbered_frames(int count) {
  std::vector<video::FrameRecord> frames(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) frames[static_cast<std::size_t>(i)].frame = i;
  return frames;
}

video::Manifest manifest_of(int count) {
  video::Manifest manifest;
  manifest.width = manifest.height = 16;
  manifest.fps = 25;
  manifest.range = "0-" + std::to_string(count - 1);
  return manifest;
}

/// A frame whose first byte is its index.
image::Frame frame_of(std::size_t index) {
  image::Frame frame{image::Image(16, 16, 3), {{0, 0, 16, 16}}};
  frame.image.pixels[0] = static_cast<std::uint8_t>(index);
  return frame;
}

/// Draws frames with `draw` when they are composited.
Drawing drawing(std::function<image::Frame(std::size_t)> draw = frame_of, std::size_t ahead = 0) {
  return {[draw = std::move(draw)](std::size_t frame) {
            return image::PendingFrame{[] {}, [draw, frame] { return draw(frame); }};
          },
          ahead};
}

class PipelineOfThreads : public testing::Test {
 protected:
  static constexpr int count = 40;
  const ScratchFolder folder_;
  const std::vector<video::FrameRecord> frames_ = numbered_frames(count);
  StageTimes times_;
};

TEST_F(PipelineOfThreads, EveryFrameArrivesOnceAsItWasDrawn) {
  for (const int jobs : {1, 4}) {
    const auto frames_folder = folder_ / std::to_string(jobs);
    video::FrameSequence sequence(frames_folder, manifest_of(count));
    run_pipeline(frames_, drawing(), {&sequence, nullptr, jobs}, {}, times_);
    sequence.finish();
    const video::Manifest manifest = video::read_manifest(frames_folder / video::manifest_name);
    ASSERT_EQ(manifest.frames.size(), static_cast<std::size_t>(count));
    for (const video::FrameRecord& frame : manifest.frames) {
      EXPECT_EQ(image::read_png(frames_folder / frame.file).pixels[0], frame.frame);
    }
  }
}

TEST_F(PipelineOfThreads, TheFilmGetsItsFramesInOrder) {
  video::VideoEncoder encoder(folder_ / "film.mp4", {16, 16, 25});
  run_pipeline(frames_, drawing(), {nullptr, &encoder, 1}, {}, times_);
  encoder.finish();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "film.mp4"));
}

TEST_F(PipelineOfThreads, BeginsFramesAheadOfTheOneItEnds) {
  for (const std::size_t ahead : {0U, 1U, 3U}) {
    std::size_t begun = 0, ended = 0;
    const Drawing counted{
        [&](std::size_t frame) {
          EXPECT_EQ(frame, begun);
          ++begun;
          const auto transfer = [&, frame] {
            EXPECT_EQ(frame, ended);
            ++ended;
            EXPECT_EQ(begun, std::min(ended + ahead, frames_.size()));
          };
          return image::PendingFrame{transfer, [frame] { return frame_of(frame); }};
        },
        ahead};
    run_pipeline(frames_, counted, {nullptr, nullptr, 1}, {}, times_);
    EXPECT_EQ(ended, frames_.size());
  }
}

TEST_F(PipelineOfThreads, AFrameThatWasKeptIsNotWritten) {
  video::FrameSequence sequence(folder_.path() / "frames", manifest_of(count));
  const auto draw = [](std::size_t index) {
    image::Frame frame = frame_of(index);
    frame.is_new = index % 2 == 0;
    return frame;
  };
  run_pipeline(frames_, drawing(draw), {&sequence, nullptr, 2}, {}, times_);
  sequence.finish();
  EXPECT_EQ(video::read_manifest(folder_ / "frames/manifest.json").frames.size(), count / 2u);
}

TEST_F(PipelineOfThreads, AnErrorOfTheDrawingEndsTheRun) {
  for (const std::size_t ahead : {0U, 2U}) {
    const auto frames_folder = folder_ / std::to_string(ahead);
    video::FrameSequence sequence(frames_folder, manifest_of(count));
    const auto draw = [](std::size_t frame) {
      if (frame == 7) throw gl::GlError("drawing", "lost");
      return frame_of(frame);
    };
    EXPECT_THROW(run_pipeline(frames_, drawing(draw, ahead), {&sequence, nullptr, 2}, {}, times_),
                 gl::GlError);
    sequence.finish();
    // The frames in flight are complete and recorded.
    EXPECT_EQ(video::read_manifest(frames_folder / video::manifest_name).frames.size(), 7u);
  }
}

TEST_F(PipelineOfThreads, AnErrorOfTheDrawingLosesNoFrameBeforeIt) {
  video::FrameSequence sequence(folder_ / "frames", manifest_of(count));
  const Drawing failing{[](std::size_t frame) {
    if (frame == 7) throw gl::GlError("drawing", "lost");
    return image::PendingFrame{[] {}, [frame] { return frame_of(frame); }};
  }};
  EXPECT_THROW(run_pipeline(frames_, failing, {&sequence, nullptr, 2}, {}, times_), gl::GlError);
  sequence.finish();
  EXPECT_EQ(video::read_manifest(folder_ / "frames" / video::manifest_name).frames.size(), 7u);
}

TEST_F(PipelineOfThreads, DrawsOnOneThreadAndCompositesOnAnother) {
  const auto here = std::this_thread::get_id();
  const Drawing drawing{[&](std::size_t frame) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    const auto transfer = [&] { EXPECT_EQ(std::this_thread::get_id(), here); };
    const auto composite = [&, frame] {
      EXPECT_NE(std::this_thread::get_id(), here);
      return frame_of(frame);
    };
    return image::PendingFrame{transfer, composite};
  }};
  run_pipeline(frames_, drawing, {nullptr, nullptr, 1}, {}, times_);
}

TEST_F(PipelineOfThreads, AnErrorOfTheWritingEndsTheRun) {
  video::FrameSequence sequence(folder_.path() / "frames", manifest_of(count));
  int drawn = 0;
  const auto draw = [&](std::size_t frame) {
    // Renames the folder, because that is atomic: during a removal, other threads could write
    // there.
    if (++drawn == 5) std::filesystem::rename(folder_ / "frames", folder_ / "gone");
    return frame_of(frame);
  };
  EXPECT_THROW(run_pipeline(frames_, drawing(draw), {&sequence, nullptr, 2}, {}, times_),
               system::FileError);
  EXPECT_LT(drawn, count);
}

}  // namespace
}  // namespace twrench::film
