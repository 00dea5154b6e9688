#include "app/terminal/error_report.h"

#include <fmt/format.h>
#include <twrench/motion/error.h>

#include <csignal>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "app/terminal/message.h"
#include "base/words.h"
#include "canvas/font.h"
#include "check/verdict/error.h"
#include "film/error.h"
#include "gl/context.h"
#include "interchange/error.h"
#include "plot/gnuplot.h"
#include "recording/columns/columns.h"
#include "system/error.h"
#include "system/file.h"
#include "video/error.h"
#include "video/frame_range.h"

namespace twrench::app {
namespace {

ExitCode report(ExitCode code, const std::string& message, const std::string& remedy = {}) {
  say("twrench: error: {}\n", message);
  if (!remedy.empty()) say("  {}\n", remedy);
  return code;
}

std::string remedy_for_motion(motion::MotionError::Reason reason) {
  switch (reason) {
    case motion::MotionError::Reason::step_too_long:
      return "take a shorter --step";
    case motion::MotionError::Reason::diverged:
      return "take a shorter --step, or a method that stays on SO(3)";
    case motion::MotionError::Reason::too_many_steps:
      return "take a longer --step or a shorter --duration";
    case motion::MotionError::Reason::out_of_steps:
      return "take a shorter --duration or a larger --tolerance, or --method exact for a rigid "
             "body";
    case motion::MotionError::Reason::step_underflow:
      return "take a larger --tolerance, or a slower motion";
    case motion::MotionError::Reason::stopped:
      return {};
    case motion::MotionError::Reason::too_many_flips:
      break;
  }
  return "give a shorter --duration";
}

std::string remedy_for_frames(const video::FramesError& error) {
  switch (error.reason()) {
    case video::FramesError::Reason::no_manifest:
      return "name the folder that twrench render wrote its frames to";
    case video::FramesError::Reason::contradictory:
      return "render the affected frames again with --overwrite, or remove their manifest";
    case video::FramesError::Reason::missing:
      return "render them, by the same command with --resume or with --frames; or leave them out: "
             "--allow-missing";
    case video::FramesError::Reason::altered:
      break;
  }
  return "render it again: --resume --frames " + video::format_frame_range(error.frames());
}

std::string remedy_for_check(check::CheckError::Reason reason) {
  switch (reason) {
    case check::CheckError::Reason::one_row:
      return "judge a file of several rows, or give the initial state with --omega or --case";
    case check::CheckError::Reason::at_rest:
      return "give --omega 0,0,0 without --fit to judge whether it stays at rest";
    case check::CheckError::Reason::no_fit:
      return "start the fit elsewhere: --fit --omega X,Y,Z";
    case check::CheckError::Reason::no_inertia:
      return "record a motion that wobbles or turns over, such as a toss about the middle axis, or "
             "cut off what is no free motion: --from S --to S";
    case check::CheckError::Reason::stopped:
      break;
  }
  return {};
}

std::string remedy_for_columns(const recording::ColumnError& error) {
  if (!error.suggested().empty()) {
    return "if they are meant, add " + option_text("columns", error.suggested());
  }
  const std::string& ours = error.column();
  return fmt::format("--columns {}=NAME names {}; {}",
                     ours.empty() ? "t=NAME,wx=NAME,wy=NAME,wz" : ours,
                     ours.empty() ? "them" : "it", error.remedy());
}

std::string remedy_for_gl(const gl::GlError& error) {
  switch (error.reason()) {
    case gl::GlError::Reason::egl_device_refused:
      return "choose another --egl-device, or --backend";
    case gl::GlError::Reason::no_osmesa:
      return error.remedy() + ": --backend egl";
    case gl::GlError::Reason::crashed:
      return error.remedy() + ", or choose another --backend";
    case gl::GlError::Reason::forked:
    case gl::GlError::Reason::failed:
      break;
  }
  return error.remedy();
}

/// The error as one of that kind, or null.
template <typename Kind>
const Kind* as(const Error& error) {
  return dynamic_cast<const Kind*>(&error);
}

template <typename Kind>
bool is(const Error& error) {
  return as<Kind>(error) != nullptr;
}

/// The remedy for an error of a run that draws a film; empty for other errors.
std::string remedy_for_run(const Error& error) {
  if (const auto* frames = as<film::ForeignFramesError>(error)) {
    if (frames->unrecorded()) {
      return "choose another folder with --frames-dir; twrench compare OLD NEW --update then adds "
             "its frames to golden images, and --overwrite replaces frames in place";
    }
    return frames->sharded()
               ? "all shards of a video need the same program version, scene and kind of machine; "
                 "use --frames-dir to choose another folder, or --overwrite to replace them"
               : "use --overwrite to replace them, or --frames-dir to choose another folder";
  }
  if (is<film::SpaceError>(error)) {
    return "free some space, or choose another disk, a smaller --size or fewer --frames";
  }
  if (is<film::ThreadError>(error)) {
    return "use fewer --jobs, or raise the limit on processes (ulimit -u)";
  }
  return {};
}

ExitCode exit_code_of(const Error& error) {
  if (is<gl::GlError>(error)) return ExitCode::no_gl;
  if (is<video::EncoderError>(error) || is<plot::PlotError>(error)) return ExitCode::encoder;
  if (is<system::ExistingFileError>(error)) return ExitCode::file;
  return is<system::FileError>(error) ? ExitCode::file : ExitCode::usage;
}

ExitCode report(const Error& error) {
  // As other programs in a pipe, it ends in silence.
  if (is<system::ClosedPipe>(error)) return ExitCode::closed_pipe;
  return report(exit_code_of(error), with_arguments(error.what(), option_text), remedy_for(error));
}

/// How the command could use less memory.
std::string remedy_for_glyph(const canvas::MissingGlyph& error) {
  const std::string font = fmt::format(
      "--font FILE takes a font that has it: fc-list :charset={:x} lists those that are "
      "installed",
      static_cast<std::uint32_t>(error.character()));
  if (error.quantity() != "title") return font;
  return font + "; --title TEXT gives another title, and --hide hud none";
}

std::string remedy_for_memory(bool draws) {
  if (draws) return "use a smaller --size, fewer --samples or fewer --jobs";
  return "close other programs, or raise the limit on memory (ulimit -v)";
}

/// Converts a system error that none of our code expected.
system::FileError refused(const std::system_error& error) {
  const int number = error.code().value();
  if (error.code() == std::errc::resource_unavailable_try_again) {
    return {"cannot start a thread", error.code().message(),
            "raise the limit on processes (ulimit -u, or that of the container)"};
  }
  const auto* at = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
  const bool has_path = at != nullptr && !at->path1().empty();
  return system::file_error(has_path ? "cannot use " + at->path1().string() : "cannot continue",
                            number);
}

bool is_of_the_system(const std::system_error& error) {
  return error.code().category() == std::system_category() ||
         error.code().category() == std::generic_category();
}

}  // namespace

std::string remedy_for(const Error& error) {
  if (const auto* gl = as<gl::GlError>(error)) return remedy_for_gl(*gl);
  if (const auto* columns = as<recording::ColumnError>(error)) return remedy_for_columns(*columns);
  if (!error.remedy().empty()) return with_arguments(error.remedy(), option_text);
  if (const auto* motion = as<motion::MotionError>(error))
    return remedy_for_motion(motion->reason());
  if (const auto* check = as<check::CheckError>(error)) return remedy_for_check(check->reason());
  if (const auto* frames = as<video::FramesError>(error)) return remedy_for_frames(*frames);
  if (const auto* size = as<video::FilmSizeError>(error)) {
    return fmt::format("use --size {}x{}, or --no-video for the frames alone", size->width(),
                       size->height());
  }
  if (const std::string remedy = remedy_for_run(error); !remedy.empty()) return remedy;
  if (is<system::ExistingFileError>(error)) {
    return "--overwrite replaces it, or choose another name";
  }
  if (is<interchange::AccuracyError>(error))
    return "take a larger --max-angle, or a shorter --duration";
  if (const auto* glyph = as<canvas::MissingGlyph>(error)) return remedy_for_glyph(*glyph);
  return {};
}

ExitCode report_current_exception(bool draws) {
  try {
    throw;
  } catch (const Error& error) {
    return report(error);
  } catch (const std::bad_alloc&) {
    return report(ExitCode::internal, "memory: out of memory", remedy_for_memory(draws));
  } catch (const std::system_error& error) {
    if (is_of_the_system(error)) return report(refused(error));
    return report(ExitCode::internal, std::string("internal: ") + error.what());
  } catch (const std::exception& error) {
    return report(ExitCode::internal, std::string("internal: ") + error.what());
  }
}

ExitCode report_termination(const system::TerminationMessage& message) {
  return report(message.signal == SIGINT ? ExitCode::interrupted : ExitCode::terminated,
                message.error, message.remedy);
}

film::PagePictures pictures_or_nothing(const scene::Scene& scene, bool has_article) try {
  return film::page_pictures(scene, has_article, {});
} catch (const gl::GlError& error) {
  warn(fmt::format("the page has no fallback pictures: {}", error.what()));
  return {};
}

}  // namespace twrench::app
