#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "draw/film_renderer.h"
#include "film/frames_output.h"
#include "film/pipeline.h"
#include "gl/backend.h"
#include "scene/scene.h"
#include "timeline/film_timeline.h"
#include "video/encoder.h"
#include "video/frame_range.h"
#include "video/text_tracks.h"

namespace twrench::film {

/// Returns the default number of threads that compress frames: half the processors, at most eight.
/// Drawing and the encoder use the other half; more threads would only compete with them for time
/// and cache. Drawing in software keeps one or two processors busy (docs/scaling.md), and each
/// thread has a frame in memory.
int default_job_count();

/// The video of a run.
struct VideoOutput {
  /// A file, or "-" for standard output.
  std::filesystem::path path;
  video::Container container = video::Container::mp4;
  /// Whether the flips become chapters.
  bool chapters = true;
  /// Effort and quality of the encoder.
  video::Quality quality = {};

  bool is_streamed() const { return path == "-"; }
};

/// The settings of a run: what it draws and where it writes.
struct RenderSettings {
  /// Folder of the PNG frames and their manifest; nothing if none are written.
  std::optional<std::filesystem::path> frames_folder;
  /// The video; nothing if none is written.
  std::optional<VideoOutput> video;
  /// The frames to draw, as video::parse_frame_range() reads them; all of them if empty.
  std::string range;
  /// The part of those frames that this run draws.
  video::Shard shard;
  /// How the run treats existing frames and an existing video.
  Reuse reuse = Reuse::none;
  /// Number of threads that compress frames, at least 1.
  int jobs = default_job_count();
  gl::BackendChoice backend;
  /// The files that the caller has read for the scene, besides those that the scene names.
  std::vector<std::filesystem::path> inputs;
  /// Ends the run with an error when another thread sets it to true; may be null.
  const std::atomic<bool>* stop = nullptr;
};

/// A run that draws the frames of a scene, and writes them and the video. Use it only on the thread
/// that created it.
class RenderJob {
 public:
  /// Opens OpenGL and the outputs. All errors that can be detected in advance are thrown here,
  /// before the first frame: InvalidArgument, MotionError, GlError, EncoderError, FileError and
  /// OverwriteError as FileList and the stages throw them, and SpaceError. Synthesises and encodes
  /// the sound.
  RenderJob(const scene::Scene& scene, RenderSettings settings);

  /// Returns the number of frames of the run.
  std::size_t size() const { return frames_.size(); }

  /// Returns which OpenGL is used instead of the requested one, and why; usually empty.
  const std::string& note() const { return opened_.note; }

  /// Returns warnings about the sound; usually none.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Draws and writes all frames, and completes the video. `progress` may be empty. Throws as the
  /// stages do; the frames written until then are recorded in the manifest.
  void run(const ProgressCallback& progress);

  /// Records the frames that are complete, and returns their number; nothing if the run writes no
  /// frames. For a TerminationAction: may be called on another thread, under hold_termination().
  std::optional<std::size_t> record_frames();

  /// Returns how long the stages have been busy so far.
  const StageTimes& times() const { return times_; }

 private:
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  StageTimes times_;
  const scene::Scene scene_;
  const RenderSettings settings_;
  /// Kept until the end, because waiting for its child to end would delay the first frame.
  std::optional<gl::BackendTrial> gl_trial_;
  std::optional<timeline::FilmTimeline> timeline_;  ///< Like the next two, set when constructed.
  gl::OpenedContext opened_;
  std::optional<draw::FilmRenderer> renderer_;
  std::vector<std::string> warnings_;
  std::vector<video::FrameRecord> frames_;  ///< Each is complete when its drawing begins.
  std::optional<FramesOutput> output_;
  std::unique_ptr<video::VideoEncoder> encoder_;
  std::unique_ptr<video::TextTrackFiles> text_tracks_;
  video::FrameSequence* sequence_ = nullptr;
};

}  // namespace twrench::film
