#include "app/render_job.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <span>

#include "app/message.h"
#include "app/output_space.h"
#include "app/pipeline.h"
#include "app/version.h"
#include "image/picture_memory.h"
#include "image/png.h"
#include "render/renderer.h"
#include "scene/scene_json.h"
#include "system/file.h"
#include "system/termination.h"
#include "timeline/timeline.h"
#include "video/frame_range.h"
#include "video/video_file.h"

namespace twrench::app {
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

/// The frames to draw, each with the first method's pose at its own time.
std::vector<video::FrameRecord> frame_records(const timeline::Timeline& timeline,
                                              const render::Renderer& renderer) {
  std::vector<video::FrameRecord> frames(timeline.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const timeline::FrameState state = timeline.frame_state(i);
    const render::Camera camera = renderer.camera(state.video_time);
    frames[i].frame = state.frame;
    frames[i].t = state.solutions.front().sample.t;
    frames[i].X = row_major<9>(state.solutions.front().sample.X);
    frames[i].view = row_major<16>(camera.view);
    frames[i].projection = row_major<16>(camera.projection);
  }
  return frames;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Tests the encoder in the background, which takes about as long as creating the OpenGL context.
std::future<void> try_encoder(const RenderOptions& options, const scene::Scene& scene) {
  if (options.no_video) return {};
  video::encoder_arguments(options.video_format(scene));  // throws for an invalid size
  return std::async(std::launch::async,
                    [format = options.video_format(scene)] { video::require_encoder(format); });
}

/// Opens the encoder, tested before; null with --no-video. It starts while the test finishes; a
/// missing folder is created only after the test has passed, so that none is left behind on
/// failure.
std::unique_ptr<video::VideoEncoder> open_encoder(const RenderOptions& options,
                                                  const scene::Scene& scene,
                                                  const std::string& identity,
                                                  std::future<void> trial) {
  if (options.no_video) return nullptr;
  const fs::path path = options.video_path(scene);
  std::error_code failed;
  if (path.has_parent_path() && !fs::exists(path.parent_path(), failed)) {
    trial.get();
    system::make_folder(path.parent_path());
  }
  auto encoder = std::make_unique<video::VideoEncoder>(path, options.video_format(scene), identity);
  if (trial.valid()) trial.get();
  return encoder;
}

video::Manifest manifest_of(const RenderOptions& options, const scene::Scene& scene,
                            const render::Renderer& renderer, const std::vector<int>& asked) {
  video::Manifest manifest;
  manifest.version = version;
  // As it will be read back: its strings may contain invalid UTF-8.
  manifest.scene = nlohmann::ordered_json::parse(scene::scene_json(scene).dump(
      -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  manifest.font = renderer.typeface_digest();
  manifest.renderer = renderer.description();
  manifest.width = scene.film.width;
  manifest.height = scene.film.height;
  manifest.fps = scene.film.fps;
  manifest.range = video::format_frame_range(asked);
  manifest.shard = options.shard;
  if (!options.no_video) manifest.encoder = video::encoder_arguments(options.video_format(scene));
  return manifest;
}

/// Records what remains on disk when a signal ends the run, and reports it to the user.
void end_whole(video::FrameSequence* sequence, std::span<const video::FrameRecord> frames,
               system::TerminationMessage& message) {
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

std::string film_name(const RenderOptions& options, const scene::Scene& scene) {
  return options.video.is_streamed() ? "on standard output" : options.video_path(scene).string();
}

Summary summary_of(const RenderOptions& options, const scene::Scene& scene, std::size_t frames,
                   double seconds) {
  Summary summary{frames, seconds, {}, {}};
  if (!options.no_frames) summary.frames_folder = options.frames_folder(scene);
  if (!options.no_video) summary.film = film_name(options, scene);
  return summary;
}

/// Reads a frame that --resume keeps; without its image if no video needs it.
image::Frame read_frame(const fs::path& path, bool has_video) {
  if (!has_video) return {{}, {}, false};
  image::Image image = image::read_png(path);
  const image::Area all{0, 0, image.width, image.height};
  return {std::move(image), {all}, false};
}

PlannedOutput planned_output(const RenderOptions& options, const scene::Scene& scene,
                             const FramesOutput* frames, std::size_t count) {
  PlannedOutput planned;
  planned.frame_pixels = double(scene.film.width) * scene.film.height;
  if (frames != nullptr) {
    planned.frames_folder = frames->folder();
    planned.new_frames = frames->count_without_file();
  }
  if (options.writes_video_file()) {
    planned.film = options.video_path(scene);
    planned.film_frames = count;
  }
  return planned;
}

}  // namespace

void render_film(const RenderOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  StageTimes times;
  options.require_consistent();
  const scene::Scene scene = options.scene.scene();
  image::keep_memory_of_pictures(scene.film.width, scene.film.height);
  const int count = scene.frame_count();
  const std::string all = fmt::format("0-{}", count - 1);
  const std::vector<int> asked =
      video::parse_frame_range(options.range.empty() ? all : options.range, count);
  const std::vector<int> numbers = video::frames_of_shard(asked, options.shard);
  const int jobs = options.job_count();
  if (options.writes_video_file()) options.scene.require_not_input(options.video_path(scene));

  // Whatever can fail for a reason known in advance fails here, before the first frame.
  std::future<void> trial = try_encoder(options, scene);
  const gl::OpenedContext opened = gl::open_context(options.backend);
  const timeline::Timeline timeline = [&] {
    const Timed timed(times.pose);
    return timeline::Timeline(scene, numbers);
  }();
  render::Renderer renderer(*opened.context, scene, timeline.solutions());
  const std::vector<video::FrameRecord> frames = frame_records(timeline, renderer);
  const video::Manifest manifest = manifest_of(options, scene, renderer, asked);
  const std::string identity = video::video_identity(manifest, numbers);
  if (options.writes_video_file() && !options.overwrite) {
    video::require_replaceable(options.video_path(scene), identity);
  }
  std::optional<FramesOutput> output;
  if (!options.no_frames) {
    output.emplace(options.frames_folder(scene), manifest, numbers, options.reuse());
  }
  if (!frames.empty()) {
    require_space(planned_output(options, scene, output ? &*output : nullptr, frames.size()),
                  [&] { return renderer.draw(timeline.frame_state(0)).image; });
  }
  const auto encoder = open_encoder(options, scene, identity, std::move(trial));
  video::FrameSequence* const sequence = output ? &output->open() : nullptr;
  const system::TerminationAction on_signal(
      [&](system::TerminationMessage& message) { end_whole(sequence, frames, message); });

  Progress progress(options.progress);
  if (!opened.note.empty()) progress.note(opened.note);
  const Outputs outputs{sequence, encoder.get(), jobs, start};
  const auto begin = [&](std::size_t index) {
    const auto kept = output ? output->kept(frames[index]) : std::nullopt;
    if (!kept) return renderer.begin(timeline.frame_state(index));
    return std::async(std::launch::deferred, read_frame, output->folder() / kept->file,
                      encoder != nullptr);
  };
  const auto reuse = [&](image::Frame frame) {
    if (frame.is_new) renderer.reuse(std::move(frame));
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

}  // namespace twrench::app
