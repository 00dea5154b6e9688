#pragma once

#include <filesystem>
#include <string>

#include "app/command_line.h"
#include "app/frames_output.h"
#include "app/scene_options.h"
#include "app/video_options.h"
#include "gl/backend.h"
#include "video/encoder.h"
#include "video/shard.h"

namespace twrench::app {

/// The options of `render`.
struct RenderOptions {
  /// Adds them to the command.
  explicit RenderOptions(CLI::App& command);

  /// Throws InvalidArgument if options contradict each other.
  void require_consistent() const;

  /// The video file; "-" for standard output.
  std::filesystem::path video_path(const scene::Scene& of) const;
  std::filesystem::path frames_folder(const scene::Scene& of) const;
  video::VideoFormat video_format(const scene::Scene& of) const;
  /// Whether the video is a file.
  bool writes_video_file() const { return !no_video && !video.is_streamed(); }
  /// What to do with frames that are there.
  Reuse reuse() const;
  /// The number of threads that compress frames. Throws InvalidArgument.
  int job_count() const;

  SceneOptions scene;
  VideoOptions video;
  std::string frames_dir;
  std::string range;
  video::Shard shard;
  bool no_video = false;
  bool no_frames = false;
  bool resume = false;
  bool overwrite = false;
  std::string timing;  ///< "text", "json" or empty
  gl::BackendChoice backend;
  std::string jobs;
  std::string progress = "auto";
};

}  // namespace twrench::app
