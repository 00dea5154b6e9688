#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/film_options.h"
#include "app/frames_output.h"
#include "app/message.h"
#include "app/output_space.h"
#include "app/picture_options.h"
#include "app/pipeline.h"
#include "app/scene_options.h"
#include "app/version.h"
#include "base/file.h"
#include "base/processors.h"
#include "base/termination.h"
#include "canvas/font.h"
#include "gl/backend.h"
#include "image/picture_memory.h"
#include "image/png.h"
#include "movie/film_file.h"
#include "movie/frame_range.h"
#include "render/renderer.h"
#include "scene/scene_json.h"
#include "timeline/timeline.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;

/// A matrix in row-major order.
template <std::size_t count, typename Matrix>
std::array<double, count> row_major(const Matrix& matrix) {
  std::array<double, count> values;
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    values[static_cast<std::size_t>(i)] = matrix(i / matrix.cols(), i % matrix.cols());
  }
  return values;
}

struct Options {
  explicit Options(CLI::App& command);

  SceneOptions scene;
  FilmOptions film;
  std::string frames_dir;
  std::string range;
  Shard shard;
  bool is_shard = false;  ///< --shard was given
  bool no_video = false;
  bool no_frames = false;
  bool resume = false;
  bool overwrite = false;
  std::string timing;
  gl::BackendChoice backend;
  std::string jobs;
  std::string progress = "auto";
};

void add_backend_options(CLI::App& command, gl::BackendChoice& choice) {
  using enum gl::Backend;
  const std::map<std::string, gl::Backend> names{
      {"auto", automatic}, {"osmesa", osmesa}, {"egl", egl}};
  command
      .add_option_function<std::string>(
          "--backend",
          [&choice, names](const std::string& name) { choice.backend = names.at(name); },
          "OpenGL backend: auto, osmesa or egl")
      ->check(one_of("--backend", {"auto", "osmesa", "egl"}))
      ->type_name("NAME")
      ->default_str("auto");
  command.add_option("--egl-device", choice.egl_device, "EGL device: its number, or software")
      ->type_name("N");
}

Options::Options(CLI::App& command) : scene(command) {
  scene.add_motion_options();
  add_picture_options(scene);
  film.add_to(command, "out/SCENE.mp4");
  command.add_option("--frames-dir", frames_dir, "folder of the PNG frames (default: out/SCENE/)")
      ->type_name("DIR");
  command
      .add_option("--frames", range, "draw only these frames: a-b or a-b:step, separated by commas")
      ->type_name("RANGE");
  command
      .add_option_function<std::string>(
          "--shard",
          [this](const std::string& text) {
            shard = parse_shard(text);
            is_shard = no_video = true;
          },
          "draw part i of n of the frames into a folder shared by all n; no video (see encode)")
      ->type_name("i/n");
  command.add_flag("--no-video", no_video, "write PNG frames only");
  command.add_flag("--no-frames", no_frames, "write the video only");
  add_backend_options(command, backend);
  command.add_option("--jobs", jobs, "threads that compress frames (default: half the processors)")
      ->type_name("N");
  Progress::add_option(command, progress);
  auto* const keeps = command.add_flag(
      "--resume", resume, "keep existing frames that are intact and belong to this video");
  command
      .add_flag("--overwrite", overwrite, "replace frames and videos of other scenes or settings")
      ->excludes(keeps);
  command
      .add_flag("--timing{text}", timing,
                "report how long each stage was busy; --timing=json for programs")
      ->check(one_of("--timing", {"text", "json"}));
}

/// Drawing and the encoder use the other half of the processors: more jobs would only compete with
/// them for time and cache.
int job_count(const std::string& text) {
  if (text.empty()) return std::max(1, static_cast<int>(processor_count() / 2));
  return limits::check_whole({1, 256}, "--jobs", parse_number(text, "--jobs"));
}

/// The frames to draw, each with the first method's pose at its own time.
std::vector<FrameRecord> frame_records(const Timeline& timeline, const Renderer& renderer) {
  std::vector<FrameRecord> frames(timeline.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Moment moment = timeline.moment(i);
    const Camera camera = renderer.camera(moment.film_time);
    frames[i].frame = moment.frame;
    frames[i].t = moment.instants.front().sample.t;
    frames[i].X = row_major<9>(moment.instants.front().sample.X);
    frames[i].view = row_major<16>(camera.view);
    frames[i].projection = row_major<16>(camera.projection);
  }
  return frames;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

fs::path video_path(const Options& options, const Scene& scene) {
  return options.film.output.empty() ? fs::path("out") / (scene.name + ".mp4")
                                     : fs::path(options.film.output);
}

fs::path frames_folder(const Options& options, const Scene& scene) {
  return options.frames_dir.empty() ? fs::path("out") / scene.name : fs::path(options.frames_dir);
}

VideoFormat video_format(const Options& options, const Scene& scene) {
  return {scene.film.width,       scene.film.height,
          scene.film.fps,         options.film.container(video_path(options, scene)),
          scene.look.transparent, options.film.is_streamed()};
}

/// Tests the encoder in the background, which takes about as long as creating the OpenGL context.
std::future<void> try_encoder(const Options& options, const Scene& scene) {
  if (options.no_video) return {};
  encoder_arguments(video_format(options, scene));  // throws for an invalid size
  return std::async(std::launch::async,
                    [format = video_format(options, scene)] { require_encoder(format); });
}

/// Opens the encoder, tested before; null with --no-video. It starts while the test finishes; a
/// missing folder is created only after the test has passed, so that none is left behind on
/// failure.
std::unique_ptr<VideoEncoder> open_encoder(const Options& options, const Scene& scene,
                                           const std::string& identity, std::future<void> trial) {
  if (options.no_video) return nullptr;
  const fs::path path = video_path(options, scene);
  std::error_code failed;
  if (path.has_parent_path() && !fs::exists(path.parent_path(), failed)) {
    trial.get();
    make_folder(path.parent_path());
  }
  auto encoder = std::make_unique<VideoEncoder>(path, video_format(options, scene), identity);
  if (trial.valid()) trial.get();
  return encoder;
}

Manifest manifest_of(const Options& options, const Scene& scene, const Renderer& renderer,
                     const std::vector<int>& asked) {
  Manifest manifest;
  manifest.version = version;
  // As it will be read back: its strings may contain invalid UTF-8.
  manifest.scene = nlohmann::ordered_json::parse(
      scene_json(scene).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  manifest.font = typeface_digest(load_typeface(scene.overlay.font));
  manifest.renderer = renderer.description();
  manifest.width = scene.film.width;
  manifest.height = scene.film.height;
  manifest.fps = scene.film.fps;
  manifest.range = format_frame_range(asked);
  manifest.shard = options.shard;
  if (!options.no_video) manifest.encoder = encoder_arguments(video_format(options, scene));
  return manifest;
}

/// Records what remains on disk when a signal ends the run, and reports it to the user.
void end_whole(FrameSequence* sequence, std::span<const FrameRecord> frames,
               TerminationMessage& message) {
  message.error = "render: " + message.error;
  if (sequence == nullptr) {
    message.error += "; the video was not complete";
    return;
  }
  sequence->finish();
  message.error += fmt::format(" after {} of {} frames, which are complete",
                               sequence->count(frames), frames.size());
  message.remedy = "repeat the command with --resume to continue";
}

std::string film_name(const Options& options, const Scene& scene) {
  return options.film.is_streamed() ? "on standard output" : video_path(options, scene).string();
}

Summary summary_of(const Options& options, const Scene& scene, std::size_t frames, double seconds) {
  Summary summary{frames, seconds, {}, {}};
  if (!options.no_frames) summary.frames_folder = frames_folder(options, scene);
  if (!options.no_video) summary.film = film_name(options, scene);
  return summary;
}

/// Begins a frame: either drawn, or read from the folder if --resume keeps it.
std::future<Picture> begin_picture(const FrameRecord& frame, FramesOutput* output, bool has_video,
                                   const std::function<PendingFrame()>& begin) {
  const auto kept = output != nullptr ? output->kept(frame) : std::nullopt;
  if (!kept) {
    return std::async(std::launch::deferred, [begun = begin()]() mutable {
      Frame drawn = begun.get();
      return Picture{std::move(drawn.image), true, std::move(drawn.changed)};
    });
  }
  return std::async(std::launch::deferred, [path = output->folder() / kept->file, has_video] {
    return Picture{has_video ? read_png(path) : Image(), false};
  });
}

PlannedOutput planned_output(const Options& options, const Scene& scene, const FramesOutput* frames,
                             std::size_t count) {
  PlannedOutput planned;
  planned.frame_pixels = double(scene.film.width) * scene.film.height;
  if (frames != nullptr) {
    planned.frames_folder = frames->folder();
    planned.new_frames = frames->count_without_file();
  }
  if (!options.no_video && !options.film.is_streamed()) {
    planned.film = video_path(options, scene);
    planned.film_frames = count;
  }
  return planned;
}

Reuse reuse_of(const Options& options) {
  if (options.overwrite) return Reuse::overwrite;
  return options.resume ? Reuse::resume : Reuse::none;
}

/// Throws if options contradict each other.
void check(const Options& options) {
  if (options.no_video && options.no_frames) {
    throw UsageError("render", "--no-video and --no-frames together leave nothing to write");
  }
  if (options.no_video && !options.film.output.empty()) {
    throw UsageError(
        "render", "with --no-video or --shard, no video is written to --output",
        "once all frames are drawn: twrench encode FRAMES_DIR -o " + options.film.output);
  }
  if (!options.no_video) options.film.require_free_output(options.progress);
  if (options.backend.backend == gl::Backend::osmesa && options.backend.egl_device) {
    throw UsageError("--egl-device", "OSMesa has none", "use --backend egl, or leave it out");
  }
}

void render(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  StageTimes times;
  check(options);
  const Scene scene = options.scene.scene();
  keep_memory_of_pictures(scene.film.width, scene.film.height);
  const int count = scene.frame_count();
  const std::string all = fmt::format("0-{}", count - 1);
  const std::vector<int> asked =
      parse_frame_range(options.range.empty() ? all : options.range, count);
  const std::vector<int> numbers = frames_of_shard(asked, options.shard);
  const int jobs = job_count(options.jobs);
  const bool is_file = !options.no_video && !options.film.is_streamed();
  if (is_file) options.scene.require_not_input(video_path(options, scene));

  // Whatever can fail for a reason known in advance fails here, before the first frame.
  std::future<void> trial = try_encoder(options, scene);
  const gl::OpenedContext opened = gl::open_context(options.backend);
  const Timeline timeline = [&] {
    const Timed timed(times.pose);
    return Timeline(scene, numbers);
  }();
  Renderer renderer(*opened.context, scene, timeline.takes());
  const std::vector<FrameRecord> frames = frame_records(timeline, renderer);
  const Manifest manifest = manifest_of(options, scene, renderer, asked);
  const std::string identity = film_identity(manifest, numbers);
  if (is_file && !options.overwrite) {
    require_replaceable(video_path(options, scene), identity);
  }
  std::optional<FramesOutput> output;
  if (!options.no_frames) {
    output.emplace(frames_folder(options, scene), manifest, numbers, reuse_of(options));
  }
  if (!frames.empty()) {
    require_space(planned_output(options, scene, output ? &*output : nullptr, frames.size()),
                  [&] { return renderer.draw(timeline.moment(0)).image; });
  }
  const auto encoder = open_encoder(options, scene, identity, std::move(trial));
  FrameSequence* const sequence = output ? &output->open() : nullptr;
  const TerminationAction on_signal(
      [&](TerminationMessage& message) { end_whole(sequence, frames, message); });

  Progress progress(options.progress);
  if (!opened.note.empty()) progress.note(opened.note);
  const Outputs outputs{sequence, encoder.get(), jobs, start};
  const auto begin = [&](const FrameRecord& frame) {
    const auto index = static_cast<std::size_t>(&frame - frames.data());
    return begin_picture(frame, output ? &*output : nullptr, encoder != nullptr,
                         [&] { return renderer.begin(timeline.moment(index)); });
  };
  const auto reuse = [&](Picture picture) {
    if (picture.changed) renderer.reuse({std::move(picture.image), std::move(*picture.changed)});
  };
  run_pipeline(frames, {begin, renderer.frames_ahead(), reuse}, outputs, progress, times);
  if (sequence != nullptr) sequence->finish();
  progress.finish();
  if (encoder) encoder->finish();
  const double seconds = seconds_since(start);
  progress.summarize(summary_of(options, scene, frames.size(), seconds));
  if (!options.timing.empty()) {
    const bool json = options.timing == "json" || options.progress == "json";
    say("{}\n", timing_report(times, seconds, frames.size(), json));
  }
}

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("render", "Simulate, draw every frame, and write PNG frames and a video");
  command->footer(std::string(about_defaults) +
                  "Example: twrench render dzhanibekov --size 1280x720 -o flip.mp4\n"
                  "Exit codes: 3 no OpenGL, 4 no ffmpeg, 130 or 143 interrupted.");
  const auto options = std::make_shared<Options>(*command);
  command->callback(
      [options] { Progress::tell_failure_of([&] { render(*options); }, options->progress); });
}

}  // namespace twrench
