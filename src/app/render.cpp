#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/pipeline.h"
#include "app/scene_options.h"
#include "app/version.h"
#include "gl/context.h"
#include "movie/frame_range.h"
#include "render/renderer.h"
#include "scene/scene_json.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;

struct Options {
  explicit Options(CLI::App& command);

  SceneOptions scene;
  std::string video;
  std::string frames_dir;
  std::string range;
  bool no_video = false;
  bool no_frames = false;
  bool timing = false;
  std::string backend = "auto";
  std::string jobs;
  std::string progress = "auto";
};

void add_film_options(SceneOptions& scene) {
  scene.add("--size", "WxH", "size of the frames, pixels", [](Scene& s, const std::string& text) {
    const Eigen::Vector2d size = parse_size(text, "--size");
    s.film.width = limits::check_whole(limits::pixels, "--size", size.x());
    s.film.height = limits::check_whole(limits::pixels, "--size", size.y());
  });
  scene.add("--background", "COLOR", "#rrggbb, black, gray, white or transparent",
            [](Scene& s, const std::string& text) {
              set_background(s.look, text, "--background");
            });
  scene.add("--samples", "N", "samples a pixel, against jagged edges",
            [](Scene& s, const std::string& text) {
              s.look.samples = limits::check_whole(limits::samples, "--samples",
                                                   parse_number(text, "--samples"));
            });
  scene.add_flag("--bare", "the body alone", [](Scene& s) { s.look.bare = true; });
}

Options::Options(CLI::App& command) : scene(command) {
  scene.add_motion_options();
  add_film_options(scene);
  command.add_option("-o,--output", video, "the video; default out/SCENE.mp4")->type_name("VIDEO");
  command.add_option("--frames-dir", frames_dir, "folder of the PNG frames; default out/SCENE/")
      ->type_name("DIR");
  command.add_option("--frames", range, "draw only these: a-b, a-b:step, commas between")
      ->type_name("RANGE");
  command.add_flag("--no-video", no_video, "PNG frames only");
  command.add_flag("--no-frames", no_frames, "video only");
  command.add_option("--backend", backend, "how OpenGL is reached: auto or osmesa")
      ->check(CLI::IsMember({"auto", "osmesa"}))
      ->capture_default_str();
  command.add_option("--jobs", jobs, "threads that compress frames; default: one a processor")
      ->type_name("N");
  command.add_option("--progress", progress, "auto, bar, plain, json or none")
      ->check(CLI::IsMember({"auto", "bar", "plain", "json", "none"}))
      ->capture_default_str();
  command.add_flag("--timing", timing, "say at the end how long each stage was busy");
}

int job_count(const std::string& text) {
  if (text.empty()) return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return limits::check_whole({1, 256}, "--jobs", parse_number(text, "--jobs"));
}

/// The frames to draw, each with its pose at its own time.
std::vector<FrameRecord> posed_frames(const Scene& scene, const std::vector<int>& numbers) {
  std::vector<double> times;
  times.reserve(numbers.size());
  for (const int frame : numbers) times.push_back(scene.film.time_of(frame));
  const FreeBody body = free_body(mass_properties(scene.body).inertia, scene.motion.omega);
  const auto samples =
      trajectory(body, find_method(scene.motion.method), scene.motion.control, times).samples;
  std::vector<FrameRecord> frames(numbers.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].frame = numbers[i];
    frames[i].t = times[i];
    frames[i].X = row_major<9>(samples[i].X);
  }
  return frames;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print_timing(const StageTimes& times, double posing, double seconds, std::size_t frames) {
  const auto ms = [&](double stage_seconds) {
    return 1e3 * stage_seconds / static_cast<double>(frames);
  };
  fmt::print(stderr,
             "busy milliseconds a frame: pose {:.3f}, draw and read {:.1f}, PNG {:.1f}, "
             "encoder {:.1f}; in all {:.1f}\n",
             ms(posing), ms(1e-9 * static_cast<double>(times.draw)),
             ms(1e-9 * static_cast<double>(times.compress)),
             ms(1e-9 * static_cast<double>(times.encode)), ms(seconds));
}

void render(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  if (options.no_video && options.no_frames) {
    throw UsageError("render", "--no-video and --no-frames leave nothing to write");
  }
  const Scene scene = options.scene.scene();
  const int count = scene.frame_count();
  const std::vector<int> numbers =
      parse_frame_range(options.range.empty() ? fmt::format("0-{}", count - 1) : options.range,
                        count);
  Outputs outputs{.jobs = job_count(options.jobs)};

  // Whatever can fail for a reason known beforehand fails here, before the first frame.
  const fs::path video =
      options.video.empty() ? fs::path("out") / (scene.name + ".mp4") : fs::path(options.video);
  const fs::path folder =
      options.frames_dir.empty() ? fs::path("out") / scene.name : fs::path(options.frames_dir);
  std::unique_ptr<VideoEncoder> encoder;
  if (!options.no_video) {
    const VideoFormat format{scene.film.width, scene.film.height, scene.look.transparent ? 4 : 3,
                             scene.film.fps};
    encoder = std::make_unique<VideoEncoder>(video, format);
    outputs.encoder = encoder.get();
  }
  std::vector<FrameRecord> frames = posed_frames(scene, numbers);
  const double posing = seconds_since(start);
  const std::unique_ptr<gl::Context> context = gl::make_osmesa_context();
  Renderer renderer(*context, scene);
  for (FrameRecord& frame : frames) {
    frame.view = row_major<16>(renderer.view());
    frame.projection = row_major<16>(renderer.projection());
  }
  std::unique_ptr<FrameSequence> sequence;
  if (!options.no_frames) {
    Manifest manifest{.version = version,
                      .scene = scene_json(scene),
                      .renderer = renderer.description(),
                      .width = scene.film.width,
                      .height = scene.film.height,
                      .fps = scene.film.fps,
                      .range = format_frame_range(numbers)};
    if (encoder) manifest.encoder = encoder->arguments();
    sequence = std::make_unique<FrameSequence>(folder, std::move(manifest));
    outputs.sequence = sequence.get();
  }

  Progress progress(options.progress, static_cast<int>(frames.size()));
  StageTimes times;
  const auto draw = [&](const FrameRecord& frame) { return renderer.draw(pose_of(frame)); };
  run_pipeline(frames, draw, outputs, progress, times);
  if (sequence) sequence->finish();
  if (encoder) encoder->finish();
  progress.finish();

  const double seconds = seconds_since(start);
  if (options.progress != "none") {
    fmt::print(stderr, "{} frames in {:.1f} s, {:.1f} frames/s", frames.size(), seconds,
               static_cast<double>(frames.size()) / seconds);
    if (sequence) fmt::print(stderr, "; frames in {}", folder.string());
    if (encoder) fmt::print(stderr, "; film {}", video.string());
    fmt::print(stderr, "\n");
  }
  if (options.timing) print_timing(times, posing, seconds, frames.size());
}

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "render", "The main job: simulate, draw every frame, write PNG frames and the video");
  command->footer("Example: twrench render dzhanibekov --size 1280x720 -o flip.mp4");
  const auto options = std::make_shared<Options>(*command);
  command->callback([options] { render(*options); });
}

}  // namespace twrench
