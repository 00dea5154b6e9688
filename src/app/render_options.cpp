#include "app/render_options.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/arguments.h"
#include "app/progress.h"
#include "scene/limits.h"

namespace twrench::app {
namespace {

namespace fs = std::filesystem;

void add_backend_options(CLI::App& command, gl::BackendChoice& choice) {
  command
      .add_option_function<std::string>(
          "--backend",
          [&choice](const std::string& name) { choice.backend = gl::backend_named(name); },
          "OpenGL backend: auto, osmesa or egl")
      ->check(one_of("--backend", gl::backend_names()))
      ->type_name("NAME")
      ->default_str("auto");
  command.add_option("--egl-device", choice.egl_device, "EGL device: its number, or software")
      ->type_name("N");
}

}  // namespace

RenderOptions::RenderOptions(CLI::App& command) : scene(command) {
  scene.add_motion_options();
  scene.add_picture_options();
  video.add_to(command, "out/SCENE.mp4");
  command.add_option("--frames-dir", frames_dir, "folder of the PNG frames")
      ->type_name("DIR")
      ->default_str("out/SCENE/");
  command
      .add_option("--frames", range, "draw only these frames: a-b or a-b:step, separated by commas")
      ->type_name("RANGE");
  command
      .add_option_function<std::string>(
          "--shard",
          [this](const std::string& text) {
            shard = video::parse_shard(text);
            no_video = true;
          },
          "draw part i of n of the frames into a folder shared by all n; no video (see encode)")
      ->type_name("i/n");
  command.add_flag("--no-video", no_video, "write PNG frames only");
  command.add_flag("--no-frames", no_frames, "write the video only");
  add_backend_options(command, backend);
  command.add_option("--jobs", jobs, "threads that compress frames")
      ->type_name("N")
      ->default_str("half the processors");
  Progress::add_option(command, progress);
  command.add_flag("--resume", resume,
                   "keep existing frames that are intact and belong to this video");
  command.add_flag("--overwrite", overwrite,
                   "replace frames and videos of other scenes or settings");
  command
      .add_flag("--timing{text}", timing,
                "report how long each stage was busy; --timing=json for programs")
      ->check(one_of("--timing", {"text", "json"}));
}

void RenderOptions::require_consistent() const {
  if (no_video && no_frames) {
    throw InvalidArgument("render", "--no-video and --no-frames together leave nothing to write");
  }
  if (resume && overwrite) {
    throw InvalidArgument("render", "--resume keeps frames and --overwrite replaces them",
                          "give one of the two");
  }
  if (no_video && !video.output.empty()) {
    throw InvalidArgument(
        "render", "with --no-video or --shard, no video is written to --output",
        "once all frames are drawn: twrench encode FRAMES_DIR -o " + video.output);
  }
  if (!no_video) video.require_free_output(progress);
  if (backend.backend == gl::Backend::osmesa && backend.egl_device) {
    throw InvalidArgument("--egl-device", "OSMesa has none", "use --backend egl, or leave it out");
  }
}

film::RenderSettings RenderOptions::settings(const scene::Scene& of) const {
  film::RenderSettings settings;
  const fs::path out = "out";
  if (!no_frames)
    settings.frames_folder = frames_dir.empty() ? out / of.name : fs::path(frames_dir);
  if (!no_video) {
    const fs::path path = video.output.empty() ? out / (of.name + ".mp4") : fs::path(video.output);
    settings.video = film::VideoOutput{path, video.container(path)};
    if (!video.is_streamed()) scene.require_not_input(path);
  }
  settings.range = range;
  settings.shard = shard;
  settings.reuse = overwrite ? film::Reuse::overwrite
                   : resume  ? film::Reuse::resume
                             : film::Reuse::none;
  if (!jobs.empty()) {
    settings.jobs = scene::limits::check_whole({1, 256}, "--jobs", parse_number(jobs, "--jobs"));
  }
  settings.backend = backend;
  return settings;
}

}  // namespace twrench::app
