#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "app/options/video_options.h"
#include "app/terminal/message.h"
#include "app/terminal/progress.h"
#include "base/words.h"
#include "film/pipeline.h"
#include "film/render_job.h"
#include "scene/languages.h"
#include "scene/limits.h"
#include "scene/shown_recording.h"
#include "scene/video_length.h"
#include "system/error.h"
#include "system/termination.h"

namespace twrench::app {
namespace {

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

/// User and system time in milliseconds. A shell may have become this program by exec, and then its
/// time and that of its children are included, so only differences are meaningful.
struct ProcessorTime {
  double own, children;  ///< `children` counts those that have ended.
};

double milliseconds(const film::StageTimes::Counter& counter) {
  return 1e-6 * static_cast<double>(counter.load());
}

double processor_milliseconds(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto ms = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

ProcessorTime processor_time() {
  return {processor_milliseconds(RUSAGE_SELF), processor_milliseconds(RUSAGE_CHILDREN)};
}

/// Returns the timing of a render as one line for users, or with `json` as a JSON object on one
/// line. `seconds` is the total wall time; CPU time is that counted by the system since `before`.
std::string timing_report(const film::StageTimes& times, const ProcessorTime& before,
                          double seconds, std::size_t frames, bool json) {
  const auto count = static_cast<double>(std::max<std::size_t>(frames, 1));
  const std::array<std::pair<const char*, double>, 7> stages{
      {{"pose", milliseconds(times.pose) / count},
       {"draw", milliseconds(times.draw) / count},
       {"composite", milliseconds(times.composite) / count},
       {"convert", milliseconds(times.convert) / count},
       {"compress", milliseconds(times.compress) / count},
       {"write", milliseconds(times.write) / count},
       {"encode", milliseconds(times.encode) / count}}};
  const ProcessorTime now = processor_time();
  const double own = (now.own - before.own) / count;
  const double children = (now.children - before.children) / count;
  if (json) {
    nlohmann::ordered_json report{{"frames", frames},
                                  {"wall_seconds", seconds},
                                  {"first_frame_seconds", 1e-3 * milliseconds(times.first)}};
    auto busy = nlohmann::ordered_json::object();
    for (const auto& [name, ms] : stages) busy[name] = ms;
    report["busy_ms_per_frame"] = busy;
    report["cpu_ms_per_frame"] = {{"twrench", own}, {"children", children}};
    return report.dump();
  }
  std::string text = "busy time per frame, ms: ";
  for (const auto& [name, ms] : stages) text += fmt::format("{} {:.2f}, ", name, ms);
  return text + fmt::format(
                    "wall {:.1f}; CPU {:.1f}, encoder's CPU {:.1f}; first frame "
                    "after {:.0f} ms",
                    1e3 * seconds / count, own, children, milliseconds(times.first));
}

/// Records the complete frames when a signal ends the run, and reports their number to the user.
void end_whole(film::RenderJob& job, system::TerminationMessage& message) {
  message.error = "render: " + message.error;
  const std::optional<std::size_t> complete = job.record_frames();
  if (!complete) {
    message.error += "; the video was not complete";
    return;
  }
  message.error += fmt::format(" after {} of {} frames, which are complete", *complete, job.size());
  message.remedy = "repeat the command with --resume to continue";
}

Summary summary_of(const film::RenderSettings& settings, std::size_t frames, double seconds) {
  Summary summary{frames, seconds, settings.frames_folder, {}};
  if (settings.video) summary.film = settings.video->path;
  return summary;
}

/// Keeps the memory of freed images of this size for later ones. Returning it to the system and
/// fetching it again page by page takes a twentieth of the time of a film with its PNG frames.
void keep_memory_of_pictures(int width, int height) {
  const double picture = 3.0 * width * height;  // Bytes.
  const auto bytes = [](double count) { return static_cast<int>(std::clamp(count, 1e6, 1e9)); };
  // Blocks above the first threshold are mapped and unmapped individually; free memory beyond the
  // second at the end of the heap is returned, which keeps small pictures from accumulating memory.
  ::mallopt(M_MMAP_THRESHOLD, bytes(2 * picture));
  ::mallopt(M_TRIM_THRESHOLD, bytes(8 * picture));
}

void render(const RenderOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const ProcessorTime before = processor_time();
  options.require_consistent();
  const scene::Scene scene = options.scene_to_draw();
  options.scene.require_drawable(scene);
  keep_memory_of_pictures(scene.film.width, scene.film.height);
  const film::RenderSettings settings = options.settings(scene);
  film::RenderJob job(scene, settings);
  const system::TerminationAction on_signal(
      [&](system::TerminationMessage& message) { end_whole(job, message); });

  Progress progress(options.progress);
  progress.note(scene::describe_video(scene));
  const std::string language = scene::note_on_language(scene);
  if (!language.empty()) progress.note(language);
  if (!job.note().empty()) progress.note(job.note());
  for (const std::string& warning : job.warnings()) progress.warn(warning);
  job.run([&](int done, int total) { progress.update(done, total); });
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  progress.summarize(summary_of(settings, job.size(), seconds));
  if (scene.motion.recording && !scene.motion.recording->verdict.empty()) {
    const scene::ShownRecording& recording = *scene.motion.recording;
    progress.note(recording.file + ": " + with_arguments(recording.verdict, option_text));
  }
  if (!options.timing.empty()) {
    const bool json = options.timing == "json" || options.progress == "json";
    say("{}\n", timing_report(job.times(), before, seconds, job.size(), json));
  }
}

/// Also corrects the remedy of an error about an existing video, because --resume excludes
/// --overwrite.
void render_with_remedies(const RenderOptions& options) {
  try {
    render(options);
  } catch (const system::ExistingFileError& error) {
    if (!options.resume) throw;
    throw system::ExistingFileError(
        "--resume", error.what(),
        "--overwrite instead of --resume replaces it, or choose another name");
  }
}

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("render", "Simulate, draw every frame, and write PNG frames and a video");
  command->footer(std::string(about_defaults) +
                  "Captions, fades and a speed that changes: [[shot]] tables of the scene file.\n"
                  "Example: twrench render dzhanibekov --size 1280x720 -o flip.mp4\n"
                  "Exit codes: 3 no OpenGL, 4 no ffmpeg, 130 or 143 interrupted.");
  const auto options = std::make_shared<RenderOptions>(*command);
  command->callback([options] {
    Progress::tell_failure_of([&] { render_with_remedies(*options); }, options->progress);
  });
}

}  // namespace twrench::app
