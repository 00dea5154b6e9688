#include "app/terminal/error_report.h"

#include <gmock/gmock.h>
#include <twrench/motion/error.h>

#include <string>

#include "canvas/font.h"
#include "gl/context.h"
#include "plot/gnuplot.h"
#include "recording/columns/columns.h"
#include "system/error.h"
#include "video/error.h"

namespace twrench::app {
namespace {

using testing::HasSubstr;

struct Said {
  ExitCode code;
  std::string text;
};

template <typename Thrown>
Said report_of(const Thrown& thrown) {
  testing::internal::CaptureStderr();
  ExitCode code{};
  try {
    throw thrown;
  } catch (...) {
    code = report_current_exception(false);
  }
  return {code, testing::internal::GetCapturedStderr()};
}

TEST(ErrorReport, EachKindOfErrorHasItsExitCode) {
  using enum ExitCode;
  EXPECT_EQ(report_of(InvalidArgument("a", "b")).code, usage);
  EXPECT_EQ(report_of(OutOfRange("a", "b", {2, 0, 1})).code, usage);
  EXPECT_EQ(report_of(motion::MotionError("a", "b", motion::MotionError::Reason::diverged)).code,
            usage);
  EXPECT_EQ(report_of(system::OverwriteError("a", "b")).code, usage);
  EXPECT_EQ(report_of(video::FilmSizeError("a", "b", 2, 2)).code, usage);
  EXPECT_EQ(report_of(canvas::MissingGlyph("a", "b", U'x')).code, usage);
  EXPECT_EQ(report_of(gl::GlError("a", "b")).code, no_gl);
  EXPECT_EQ(report_of(video::EncoderError("a", "b")).code, encoder);
  EXPECT_EQ(report_of(plot::PlotError("a", "b")).code, encoder);
  EXPECT_EQ(report_of(system::FileError("a", "b")).code, file);
  EXPECT_EQ(report_of(video::FramesError("a", "b", video::FramesError::Reason::missing)).code,
            file);
  EXPECT_EQ(report_of(std::runtime_error("a")).code, internal);
}

TEST(ErrorReport, IsALineAndARemedyBelow) {
  EXPECT_EQ(report_of(InvalidArgument("--fps", "is 0", "give more")).text,
            "twrench: error: --fps: is 0\n  give more\n");
  EXPECT_EQ(report_of(InvalidArgument("--fps", "is 0")).text, "twrench: error: --fps: is 0\n");
}

TEST(ErrorReport, RemediesOfMotionsNameTheOptions) {
  using enum motion::MotionError::Reason;
  const auto remedy = [](motion::MotionError::Reason reason) {
    return remedy_for(motion::MotionError("method rk4", "why", reason));
  };
  EXPECT_EQ(remedy(step_too_long), "take a shorter --step");
  EXPECT_THAT(remedy(diverged), HasSubstr("a shorter --step, or a method"));
  EXPECT_EQ(remedy(too_many_steps), "take a longer --step or a shorter --duration");
  EXPECT_EQ(
      remedy(out_of_steps),
      "take a shorter --duration or a larger --tolerance, or --method exact for a rigid body");
  EXPECT_THAT(remedy(step_underflow), HasSubstr("a larger --tolerance"));
  EXPECT_THAT(remedy(too_many_flips), HasSubstr("a shorter --duration"));
}

TEST(ErrorReport, RemediesOfFramesNameTheOptions) {
  using enum video::FramesError::Reason;
  const auto remedy = [](video::FramesError::Reason reason) {
    return remedy_for(video::FramesError("cannot encode f", "why", reason, {3, 4, 5}));
  };
  EXPECT_THAT(remedy(no_manifest), HasSubstr("the folder that twrench render"));
  EXPECT_THAT(remedy(contradictory), HasSubstr("--overwrite"));
  EXPECT_THAT(remedy(missing), HasSubstr("--resume or with --frames"));
  EXPECT_THAT(remedy(missing), HasSubstr("--allow-missing"));
  EXPECT_EQ(remedy(altered), "render it again: --resume --frames 3-5");
}

TEST(ErrorReport, RemediesOfOpenGlNameTheOptions) {
  using enum gl::GlError::Reason;
  EXPECT_EQ(remedy_for(gl::GlError("a", "b", "install it")), "install it");
  EXPECT_EQ(remedy_for(gl::GlError("a", "b", "install it, or use EGL", no_osmesa)),
            "install it, or use EGL: --backend egl");
  EXPECT_EQ(remedy_for(gl::GlError("a", "b", {}, egl_device_refused)),
            "choose another --egl-device, or --backend");
}

TEST(ErrorReport, OtherRemediesThatTakeAnOptionNameIt) {
  EXPECT_EQ(remedy_for(video::FilmSizeError("a", "b", 642, 482)),
            "use --size 642x482, or --no-video for the frames alone");
  EXPECT_THAT(remedy_for(canvas::MissingGlyph("title", "b", U'x')), HasSubstr("--font FILE"));
  EXPECT_THAT(remedy_for(system::ExistingFileError("v.mp4", "b")),
              HasSubstr("--overwrite replaces it"));
  EXPECT_EQ(remedy_for(system::OverwriteError("v.mp4", "b", "rename it")), "rename it");
  EXPECT_EQ(remedy_for(recording::ColumnError("run.csv", "wz", "b", "its columns are: t, p")),
            "--columns wz=NAME names it; its columns are: t, p");
  EXPECT_EQ(remedy_for(recording::ColumnError("run.csv", "wx=x,wy=y,wz=z", "b")),
            "if they are meant, add --columns 'wx=x,wy=y,wz=z'");
  EXPECT_EQ(remedy_for(recording::ColumnError("run.csv", "", "b", "its columns are: t, p")),
            "--columns t=NAME,wx=NAME,wy=NAME,wz=NAME names them; its columns are: t, p");
}

}  // namespace
}  // namespace twrench::app
