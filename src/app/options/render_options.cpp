#include "app/options/render_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/options/arguments.h"
#include "app/options/option_group.h"
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
      ->default_str("auto")
      ->group(heading(OptionGroup::run));
  command.add_option("--egl-device", choice.egl_device, "EGL device: its number, or software")
      ->type_name("N")
      ->group(heading(OptionGroup::run));
}

/// Reduces the film to the size of an animated image, with the same aspect ratio.
void fit_animation(scene::Film& film) {
  if (film.width <= video::widest_animation) return;
  const double height = double(film.height) * video::widest_animation / film.width;
  film.width = video::widest_animation;
  film.height = std::max(static_cast<int>(scene::limits::pixels.low),
                         2 * static_cast<int>(std::lround(height / 2)));
}

}  // namespace

RenderOptions::RenderOptions(CLI::App& command) : scene(command), command_(command) {
  scene.add_motion_options();
  scene.add_recording_options();
  scene.add_length_option();
  scene.add_picture_options();
  CLI::Option* const background = command.get_option("--background");
  background->description(fmt::format(
      "{} ({})", background->get_description(),
      fmt::join(
          video::format_texts(&video::OutputFormat::extension, &video::OutputFormat::keeps_alpha),
          ", ")));
  video.add_to(command, "out/SCENE.mp4");
  command.add_option("--frames-dir", frames_dir, "folder of the PNG frames")
      ->type_name("DIR")
      ->default_str("DIR/NAME/ for -o DIR/NAME.mp4, out/SCENE/ without -o; none for " +
                    video::listed(video::format_texts(&video::OutputFormat::extension,
                                                      &video::OutputFormat::is_animated_image),
                                  "and"))
      ->group(heading(OptionGroup::output));
  command
      .add_option("--frames", range, "draw only these frames: a-b or a-b:step, separated by commas")
      ->type_name("RANGE")
      ->group(heading(OptionGroup::film));
  command
      .add_option_function<std::string>(
          "--shard",
          [this](const std::string& text) {
            shard = video::parse_shard(text);
            no_video = true;
          },
          "draw part i of n of the frames into a folder shared by all n; no video (see encode)")
      ->type_name("i/n")
      ->group(heading(OptionGroup::film));
  command.add_flag("--no-video", no_video, "write PNG frames only")
      ->group(heading(OptionGroup::output));
  command.add_flag("--no-frames", no_frames, "write the video only")
      ->group(heading(OptionGroup::output));
  add_backend_options(command, backend);
  command.add_option("--jobs", jobs, "threads that compress frames")
      ->type_name("N")
      ->default_str("half the processors, at most 8")
      ->group(heading(OptionGroup::run));
  add_progress_option(command, progress);
  command
      .add_flag("--resume", resume, "keep existing frames that are intact and belong to this video")
      ->group(heading(OptionGroup::output));
  command
      .add_flag("--overwrite", overwrite, "replace frames and videos of other scenes or settings")
      ->group(heading(OptionGroup::output));
  command
      .add_flag("--timing{text}", timing,
                "report how long each stage was busy; --timing=json for programs")
      ->check(one_of("--timing", {"text", "json"}))
      ->group(heading(OptionGroup::run));
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
  if (no_video && video.has_quality()) {
    throw InvalidArgument("render", "with --no-video or --shard, no video is encoded",
                          "give --encode and --crf to twrench encode");
  }
  if (no_video && requires_sound()) {
    throw InvalidArgument("render", "with --no-video or --shard, no sound is written",
                          "leave out --audio and --sound; the command that writes the video takes "
                          "them, with --resume");
  }
  if (!no_video) video.require_free_output(progress);
  if (backend.backend == gl::Backend::osmesa && backend.egl_device) {
    throw InvalidArgument("--egl-device", "OSMesa has none", "use --backend egl, or leave it out");
  }
}

bool RenderOptions::requires_sound() const {
  const CLI::Option& sound = *command_.get_option("--sound");
  return command_.count("--audio") > 0 || (sound.count() > 0 && sound.results().back() != "none");
}

video::Container RenderOptions::container() const {
  return video.output.empty() ? video.container("film.mp4") : video.container(video.output);
}

scene::Scene RenderOptions::scene_to_draw() const {
  scene::Scene drawn = scene.scene();
  if (no_video || !video::is_animated_image(container()) || command_.count("--size") > 0)
    return drawn;
  fit_animation(drawn.film);
  for (scene::Shot& shot : drawn.shots) fit_animation(shot.scene.film);
  return drawn;
}

fs::path RenderOptions::default_frames_folder(const scene::Scene& of) const {
  // Standard output and devices have no extension.
  const fs::path file = video.output, name = file.stem();
  const bool is_named = file.has_extension() && name != "." && name != "..";
  return is_named ? file.parent_path() / name : fs::path("out") / of.name;
}

film::RenderSettings RenderOptions::settings(const scene::Scene& of) const {
  film::RenderSettings settings;
  // Frames in the small size of an animated image would block a later render of a video.
  const bool wants_frames =
      no_video || !frames_dir.empty() || !video::is_animated_image(container());
  if (!no_frames && wants_frames)
    settings.frames_folder = frames_dir.empty() ? default_frames_folder(of) : fs::path(frames_dir);
  if (!no_video) {
    const fs::path path =
        video.output.empty()
            ? fs::path("out") / (of.name + video::output_format(container()).extension())
            : fs::path(video.output);
    settings.video =
        film::VideoOutput{path, container(), video.chapters_in(container()), video.quality()};
  }
  for (const std::string& source : scene.sources()) settings.inputs.emplace_back(source);
  settings.range = range;
  settings.shard = shard;
  settings.reuse = overwrite ? film::Reuse::overwrite
                   : resume  ? film::Reuse::resume
                             : film::Reuse::none;
  if (!jobs.empty()) settings.jobs = parse_whole(jobs, "--jobs", {1, 256});
  settings.backend = backend;
  return settings;
}

}  // namespace twrench::app
