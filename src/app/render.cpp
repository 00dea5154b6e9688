#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/interruption.h"
#include "app/pipeline.h"
#include "app/scene_options.h"
#include "app/version.h"
#include "base/file.h"
#include "gl/context.h"
#include "image/png.h"
#include "movie/earlier_run.h"
#include "movie/frame_range.h"
#include "render/renderer.h"
#include "scene/names.h"
#include "scene/scene_json.h"
#include "timeline/timeline.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;

/// A matrix row by row.
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
  std::string video;
  std::string frames_dir;
  std::string range;
  bool no_video = false;
  bool no_frames = false;
  bool resume = false;
  bool overwrite = false;
  bool timing = false;
  std::string backend = "auto";
  std::string jobs;
  std::string progress = "auto";
};

void add_film_options(SceneOptions& scene) {
  scene.add("--theme", "NAME", "studio, paper or space",
            [](Scene& s, const std::string& text) { s.look.theme = theme_of(text, "--theme"); });
  scene.add("--size", "WxH", "size of the frames, pixels", [](Scene& s, const std::string& text) {
    const Eigen::Vector2d size = parse_size(text, "--size");
    s.film.width = limits::check_whole(limits::pixels, "--size", size.x());
    s.film.height = limits::check_whole(limits::pixels, "--size", size.y());
  });
  scene.add(
      "--background", "COLOR", "#rrggbb, black, gray, white or transparent",
      [](Scene& s, const std::string& text) { set_background(s.look, text, "--background"); });
  scene.add("--samples", "N", "samples a pixel, against jagged edges",
            [](Scene& s, const std::string& text) {
              s.look.samples = limits::check_whole(limits::samples, "--samples",
                                                   parse_number(text, "--samples"));
            });
  scene.add("--motion-blur", "N", "poses that a frame is the mean of",
            [](Scene& s, const std::string& text) {
              s.look.motion_blur = limits::check_whole(limits::motion_blur, "--motion-blur",
                                                       parse_number(text, "--motion-blur"));
            });
}

void add_overlay_options(SceneOptions& scene) {
  scene.add("--view", "NAME", "what to see: wrench, momentum, poinsot or quad",
            [](Scene& s, const std::string& text) { s.overlay.view = view_of(text, "--view"); });
  scene.add("--compare", "M1,M2,...", "methods side by side, four at most",
            [](Scene& s, const std::string& text) {
              s.overlay.compare = compared_methods(parse_words(text), "--compare");
            });
  scene.add("--show", "LIST",
            "add: floor, axes, momentum, omega, trail, plane, labels, hud, components, sphere, "
            "poinsot",
            [](Scene& s, const std::string& text) {
              for (const std::string& word : parse_words(text)) {
                s.overlay.show.insert(feature_of(word, "--show"));
              }
            });
  scene.add("--hide", "LIST", "the same, to leave out", [](Scene& s, const std::string& text) {
    for (const std::string& word : parse_words(text)) {
      s.overlay.show.erase(feature_of(word, "--hide"));
    }
  });
  scene.add_flag("--bare", "the body alone", [](Scene& s) { s.overlay.show.clear(); });
  scene.add("--trail-point", "X,Y,Z", "whose trail is drawn: cm, in the axes of the parts",
            [](Scene& s, const std::string& text) {
              s.overlay.trail_point = limits::check(limits::coordinate, "--trail-point",
                                                    parse_vector(text, "--trail-point"));
            });
  scene.add("--trail-length", "S", "seconds of motion that a trail covers",
            [](Scene& s, const std::string& text) {
              s.overlay.trail_length = limits::check(limits::trail_length, "--trail-length",
                                                     parse_number(text, "--trail-length"));
            });
  scene.add("--font", "NAME", "sans, mono, or a font file",
            [](Scene& s, const std::string& text) { s.overlay.font = text; });
}

void add_camera_options(SceneOptions& scene) {
  scene.add_number("--azimuth", "A", "of the camera, from z towards x, rad", limits::angle,
                   [](Scene& s) -> double& { return s.camera.azimuth; });
  scene.add_number("--elevation", "E", "of the camera, rad", limits::elevation,
                   [](Scene& s) -> double& { return s.camera.elevation; });
  scene.add_number("--distance", "F", "of the camera; at 1 the body just fits", limits::distance,
                   [](Scene& s) -> double& { return s.camera.distance; });
  scene.add_number("--orbit", "W", "how fast the camera goes around, rad per second of film",
                   limits::angle, [](Scene& s) -> double& { return s.camera.orbit; });
  scene.add_number("--field-of-view", "A", "the smaller angle of the view, rad",
                   limits::angle_of_view,
                   [](Scene& s) -> double& { return s.camera.field_of_view; });
}

Options::Options(CLI::App& command) : scene(command) {
  scene.add_motion_options();
  add_film_options(scene);
  add_overlay_options(scene);
  add_camera_options(scene);
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
  Progress::add_option(command, progress);
  command.add_flag("--resume", resume, "keep the frames there that are whole and of this film");
  command.add_flag("--overwrite", overwrite, "draw anew, over the frames of another film");
  command.add_flag("--timing", timing, "say at the end how long each stage was busy");
}

int job_count(const std::string& text) {
  if (text.empty()) return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return limits::check_whole({1, 256}, "--jobs", parse_number(text, "--jobs"));
}

/// The frames to draw, each with its pose at its own time; of the first take.
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

fs::path video_path(const Options& options, const Scene& scene) {
  return options.video.empty() ? fs::path("out") / (scene.name + ".mp4") : fs::path(options.video);
}

fs::path frames_folder(const Options& options, const Scene& scene) {
  return options.frames_dir.empty() ? fs::path("out") / scene.name : fs::path(options.frames_dir);
}

VideoFormat video_format(const Options& options, const Scene& scene) {
  return {scene.film.width, scene.film.height, scene.film.fps,
          container_of(video_path(options, scene)), scene.look.transparent};
}

/// The encoder, known to work; null with --no-video.
std::unique_ptr<VideoEncoder> open_encoder(const Options& options, const Scene& scene) {
  if (options.no_video) return nullptr;
  require_encoder(video_format(options, scene));
  const fs::path path = video_path(options, scene);
  if (path.has_parent_path()) make_folder(path.parent_path());
  return std::make_unique<VideoEncoder>(path, video_format(options, scene));
}

Manifest manifest_of(const Options& options, const Scene& scene, const Renderer& renderer) {
  Manifest manifest;
  manifest.version = version;
  manifest.scene = scene_json(scene);
  manifest.renderer = renderer.description();
  manifest.width = scene.film.width;
  manifest.height = scene.film.height;
  manifest.fps = scene.film.fps;
  if (!options.no_video) manifest.encoder = encoder_arguments(video_format(options, scene));
  return manifest;
}

/// Throws where a run would write over frames that it does not know to be of the same film.
void refuse_to_destroy(const Options& options, const fs::path& folder, const EarlierRun& earlier,
                       const Manifest& film) {
  if (options.resume || options.overwrite || !earlier.exists()) return;
  if (earlier.manifest() != nullptr && same_film(*earlier.manifest(), film)) return;
  const char* why = earlier.manifest() == nullptr
                        ? "has frames without a manifest that could be read"
                        : "has frames of another scene, size, renderer or version";
  throw UsageError(
      folder.string(), why,
      "--overwrite draws over them, --resume keeps what fits, --frames-dir goes elsewhere");
}

/// The folder of frames, its manifest begun with what earlier runs of the same film left.
std::unique_ptr<FrameSequence> open_sequence(const fs::path& folder, Manifest film,
                                             const EarlierRun& earlier,
                                             const std::vector<int>& numbers) {
  std::vector<int> range = numbers;
  std::vector<FrameRecord> others;
  if (earlier.manifest() != nullptr && same_film(*earlier.manifest(), film)) {
    for (const FrameRecord& record : earlier.manifest()->frames) {
      if (!std::ranges::binary_search(numbers, record.frame)) others.push_back(record);
    }
    for (const FrameRecord& record : others) range.push_back(record.frame);
    std::ranges::sort(range);
  }
  film.range = format_frame_range(range);
  auto sequence = std::make_unique<FrameSequence>(folder, std::move(film));
  for (const FrameRecord& record : others) sequence->keep(record);
  return sequence;
}

[[noreturn]] void throw_interrupted(int signal, std::size_t done, std::size_t total) {
  throw Error(signal == SIGINT ? ExitCode::interrupted : ExitCode::terminated, "render",
              fmt::format("interrupted by {} after {} of {} frames, which are whole",
                          signal == SIGINT ? "SIGINT" : "SIGTERM", done, total),
              "the same command with --resume goes on");
}

void print_summary(const Options& options, const Scene& scene, std::size_t frames, double seconds) {
  if (options.progress == "none") return;
  std::string text = fmt::format("{} frames in {:.1f} s, {:.1f} frames/s", frames, seconds,
                                 static_cast<double>(frames) / seconds);
  if (!options.no_frames) text += "; frames in " + frames_folder(options, scene).string();
  if (!options.no_video) text += "; film " + video_path(options, scene).string();
  fmt::print(stderr, "{}\n", text);
}

/// The frame from the folder, where it is whole and --resume asks for it, or else drawn.
Picture picture_of(const FrameRecord& frame, const Outputs& outputs, const EarlierRun* earlier,
                   const fs::path& folder, const std::function<Image()>& draw) {
  if (earlier != nullptr) {
    if (const auto record = earlier->intact(frame)) {
      outputs.sequence->keep(*record);
      return {outputs.encoder != nullptr ? read_png(folder / record->file) : Image(), false};
    }
  }
  return {draw(), true};
}

void render(const Options& options) {
  Interruption interruption;
  const auto start = std::chrono::steady_clock::now();
  if (options.no_video && options.no_frames) {
    throw UsageError("render", "--no-video and --no-frames leave nothing to write");
  }
  const Scene scene = options.scene.scene();
  const int count = scene.frame_count();
  const std::string all = fmt::format("0-{}", count - 1);
  const std::vector<int> numbers =
      parse_frame_range(options.range.empty() ? all : options.range, count);
  const int jobs = job_count(options.jobs);

  // Whatever can fail for a reason known beforehand fails here, before the first frame.
  const std::unique_ptr<gl::Context> context = gl::make_osmesa_context();
  const auto posing = std::chrono::steady_clock::now();
  const Timeline timeline(scene, numbers);
  const double posing_seconds = seconds_since(posing);
  Renderer renderer(*context, scene, timeline.takes());
  const std::vector<FrameRecord> frames = frame_records(timeline, renderer);
  const Manifest film = manifest_of(options, scene, renderer);
  const fs::path folder = frames_folder(options, scene);
  const EarlierRun earlier(folder);
  if (!options.no_frames) refuse_to_destroy(options, folder, earlier, film);
  const auto encoder = open_encoder(options, scene);
  const auto sequence = options.no_frames ? nullptr : open_sequence(folder, film, earlier, numbers);
  const bool reuse = options.resume && sequence && earlier.manifest() != nullptr &&
                     same_film(*earlier.manifest(), film);

  Progress progress(options.progress);
  StageTimes times;
  const Outputs outputs{sequence.get(), encoder.get(), jobs};
  const auto draw = [&](const FrameRecord& frame) {
    const auto index = static_cast<std::size_t>(&frame - frames.data());
    return picture_of(frame, outputs, reuse ? &earlier : nullptr, folder,
                      [&] { return renderer.draw(timeline.moment(index)).image; });
  };
  const auto stop = [&] { return interruption.arrived().has_value(); };
  const std::size_t done = run_pipeline(frames, draw, stop, outputs, progress, times);
  if (sequence) sequence->finish();
  progress.finish();
  if (done < frames.size()) throw_interrupted(*interruption.arrived(), done, frames.size());
  if (encoder) encoder->finish();
  const double seconds = seconds_since(start);
  print_summary(options, scene, frames.size(), seconds);
  if (options.timing) print_timing(times, posing_seconds, seconds, frames.size());
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
