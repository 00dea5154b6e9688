#pragma once

#include <filesystem>
#include <string>

#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "app/options/video_options.h"
#include "film/render_job.h"

namespace twrench::app {

/// The options of `render`.
struct RenderOptions {
  /// Adds them to the command.
  explicit RenderOptions(CLI::App& command);

  /// Throws InvalidArgument if options contradict each other.
  void require_consistent() const;

  /// Returns the scene, at most video::widest_animation wide if the video is an animated image and
  /// no size is given. Throws as SceneOptions::scene().
  scene::Scene scene_to_draw() const;

  /// Returns what to write, where, and how. Throws InvalidArgument, and OverwriteError if the video
  /// would replace a file that the scene comes from.
  film::RenderSettings settings(const scene::Scene& of) const;

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

 private:
  /// Returns whether an option, not only the scene, asks for sound.
  bool requires_sound() const;
  video::Container container() const;
  /// Returns the folder of the frames without --frames-dir: DIR/NAME for a video DIR/NAME.ENDING.
  std::filesystem::path default_frames_folder(const scene::Scene& of) const;

  const CLI::App& command_;
};

}  // namespace twrench::app
