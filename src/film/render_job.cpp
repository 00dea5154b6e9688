#include "film/render_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <iterator>
#include <utility>

#include "image/png.h"
#include "motion/visible_error.h"
#include "scene/reading_speed.h"
#include "scene/scene_json.h"
#include "sound/motion_track.h"
#include "system/child_process.h"
#include "system/error.h"
#include "system/file.h"
#include "system/output.h"
#include "system/processors.h"
#include "video/codec.h"
#include "video/frame_range.h"
#include "video/sound_track.h"
#include "video/video_file.h"

namespace twrench::film {
namespace {

/// A narration and the shot that it starts with.
struct Narration {
  const scene::Shot& shot;
  double start;  ///< In s of film.
};

std::vector<Narration> narrations_of(const scene::Scene& film) {
  std::vector<Narration> narrations;
  const std::vector<int> first = scene::first_frames(film);
  for (std::size_t i = 0; i < film.shots.size(); ++i) {
    const scene::Shot& shot = film.shots[i];
    if (shot.narration.is_given()) narrations.push_back({shot, first[i] / film.film.fps});
  }
  return narrations;
}

/// Returns the length of the narration in s. Throws FileError about the shot.
double length_of_narration(const scene::Shot& shot) {
  try {
    return video::sound_length(shot.narration.path);
  } catch (const system::FileError& error) {
    throw system::FileError(shot.place + ".narration", error.what(), error.remedy());
  }
}

double length_of(const scene::Scene& film) { return film.frame_count() / film.film.fps; }

/// s. A film with sound may not be longer.
constexpr double longest_film = 12 * 3600;

void require_length(const scene::Scene& film) {
  if (length_of(film) <= longest_film) return;
  throw InvalidArgument("sound",
                        fmt::format("the film lasts {:.0f} s, and one with sound at most {} s",
                                    length_of(film), longest_film),
                        "leave the sound out, or take a greater speed or a shorter duration");
}

void require_consecutive(const std::vector<int>& frames) {
  if (frames.back() - frames.front() == static_cast<int>(frames.size()) - 1) return;
  throw InvalidArgument("sound", "the film has sound, so its frames must follow each other",
                        "select one range a-b, or write the frames alone, without a video");
}

/// Returns whether the film has a sound file, narration, or the sound of its motion.
bool has_sound(const scene::Scene& film) {
  return film.film.audio.is_given() || film.film.sound == scene::Sound::motion ||
         !narrations_of(film).empty();
}

/// Throws InvalidArgument if the film has a sound file or the sound of its motion and the container
/// has no sound.
void require_sound_container(const scene::Scene& film, video::Container container) {
  const video::OutputFormat& format = video::output_format(container);
  const bool is_motion = film.film.sound == scene::Sound::motion;
  if (format.sound != nullptr || !(is_motion || film.film.audio.is_given())) return;
  throw InvalidArgument(is_motion ? "sound" : "audio", fmt::format("{} has no sound", format.label),
                        fmt::format("leave the sound out, or choose {}",
                                    video::listed(video::format_texts(&video::OutputFormat::ending,
                                                                      &video::OutputFormat::sound),
                                                  "or")));
}

/// Returns a warning for each narration that is longer than its shot. Throws InvalidArgument if one
/// would end after the film, and as video::sound_length() does.
std::vector<std::string> check_narration(const scene::Scene& film) {
  constexpr double round_off = 1e-3;
  std::vector<std::string> warnings;
  for (const auto& [shot, start] : narrations_of(film)) {
    const double length = length_of_narration(shot);
    const double room = *shot.scene.length, left = length_of(film) - start;
    if (length <= room + round_off) continue;
    if (std::isinf(length)) {
      throw InvalidArgument(shot.place + ".narration",
                            shot.narration.file + " does not state its length",
                            "convert it to WAV, FLAC, MP3 or Opus");
    }
    const std::string what = fmt::format("lasts {:.2f} s", length);
    if (length > left + round_off) {
      throw InvalidArgument(shot.place + ".narration",
                            fmt::format("{} {}, but the film ends {:.2f} s after its start",
                                        shot.narration.file, what, left),
                            "make the shot longer, or the narration shorter");
    }
    warnings.push_back(fmt::format("{}.narration: {} {}, but the shot {:.2f} s", shot.place,
                                   shot.narration.file, what, room));
  }
  return warnings;
}

/// Returns the encoded sound of the frames of a film; null if it has none, or an animated image
/// would only have narration. Throws InvalidArgument if the frames are not consecutive, and as
/// video::SoundTrack and sound::MotionTrack do.
std::shared_ptr<const video::SoundTrack> sound_track(const scene::Scene& film,
                                                     const std::vector<int>& frames,
                                                     video::Container container,
                                                     system::Patience patience) {
  if (!has_sound(film) || video::output_format(container).sound == nullptr) return nullptr;
  require_length(film);
  require_consecutive(frames);
  const double fps = film.film.fps;
  video::SoundMix mix{.files = {},
                      .begin = frames.front() / fps,
                      .end = (frames.back() + 1) / fps,
                      .film_length = length_of(film)};
  if (film.film.audio.is_given()) mix.files.push_back({film.film.audio.path});
  for (const auto& [shot, start] : narrations_of(film)) {
    mix.files.push_back({shot.narration.path, start});
  }
  std::optional<sound::MotionTrack> motion;
  if (film.film.sound == scene::Sound::motion) {
    motion.emplace(film, patience.stop);
    mix.motion = [&](const auto& sink) { motion->play(mix.begin, mix.end, sink); };
  }
  return std::make_shared<video::SoundTrack>(mix, container, patience);
}

namespace fs = std::filesystem;

/// Throws OverwriteError if an output of the run is one of its inputs or another output.
void require_separate_files(const scene::Scene& scene, const RenderSettings& settings) {
  system::FileList files;
  for (const fs::path& input : settings.inputs) files.add_input(input);
  for (const fs::path& input : scene::input_files(scene)) files.add_input(input);
  if (settings.video) {
    files.add_output(settings.video->path);
    for (const fs::path& track :
         video::text_track_files(settings.video->path, settings.video->container)) {
      files.add_output(track);
    }
  }
  if (settings.frames_folder)
    files.add_outputs(*settings.frames_folder, video::is_in_frames_folder);
}

/// The visible errors at the end of each shot.
std::vector<std::string> visible_errors(const timeline::FilmTimeline& timeline) {
  std::vector<std::string> errors;
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    if (i + 1 < timeline.size() && timeline.shot(i + 1) == timeline.shot(i)) continue;
    const timeline::Solution& solution = timeline.solutions(timeline.shot(i)).front();
    if (solution.recording) continue;
    std::string error = motion::visible_error(solution.body, *solution.method,
                                              timeline.frame(i).state.solutions.front().sample);
    if (!error.empty()) errors.push_back(std::move(error));
  }
  return errors;
}

/// A matrix in row-major order.
template <std::size_t count, typename Matrix>
std::array<double, count> row_major(const Matrix& matrix) {
  std::array<double, count> values;
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    values[static_cast<std::size_t>(i)] = matrix(i / matrix.cols(), i % matrix.cols());
  }
  return values;
}

/// The record of a frame, with the pose of its first motion.
video::FrameRecord record_of(const timeline::FilmFrame& frame, const timeline::FlipsSoFar& flips,
                             const picture::Camera& camera) {
  const timeline::FrameState& state = frame.state;
  video::FrameRecord record;
  record.frame = state.frame;
  record.t = state.solutions.front().sample.t;
  record.shot = static_cast<int>(frame.shot);
  record.flips = flips.count;
  record.last_flip = flips.last;
  record.X = row_major<9>(state.solutions.front().sample.X);
  record.view = row_major<16>(camera.view);
  record.projection = row_major<16>(camera.projection);
  return record;
}

std::vector<int> asked_frames(const scene::Scene& scene, const std::string& range) {
  const int count = scene.frame_count();
  const std::string all = "0-" + std::to_string(count - 1);
  return video::parse_frame_range(range.empty() ? all : range, count);
}

video::VideoFormat video_format(const scene::Scene& scene, const VideoOutput& video) {
  return {.width = scene.film.width,
          .height = scene.film.height,
          .fps = scene.film.fps,
          .container = video.container,
          .transparent = scene.look.transparent,
          .streamed = video.is_streamed(),
          .quality = video.quality};
}

system::Patience patience_of(const RenderSettings& settings) { return {.stop = settings.stop}; }

/// Tests the encoder in the background, which takes about as long as creating the OpenGL context.
std::future<void> try_encoder(const RenderSettings& settings, const scene::Scene& scene) {
  if (!settings.video) return {};
  const video::VideoFormat format = video_format(scene, *settings.video);
  video::encoder_arguments(format);  // throws for an invalid format
  return std::async(std::launch::async, [format, patience = patience_of(settings)] {
    video::require_encoder(format, patience);
  });
}

/// Opens the encoder, which starts while its test finishes. A missing folder is created only after
/// the test has passed, so that none is left behind on failure.
std::unique_ptr<video::VideoEncoder> open_encoder(const RenderSettings& settings,
                                                  const scene::Scene& scene,
                                                  const std::string& identity,
                                                  const video::TextTracks& tracks,
                                                  std::shared_ptr<const video::SoundTrack> sound,
                                                  std::future<void> trial) {
  const fs::path& path = settings.video->path;
  std::error_code failed;
  if (path.has_parent_path() && !fs::exists(path.parent_path(), failed)) {
    trial.get();
    system::make_folder(path.parent_path());
  }
  auto encoder = std::make_unique<video::VideoEncoder>(path, video_format(scene, *settings.video),
                                                       identity, tracks.chapters,
                                                       patience_of(settings), std::move(sound));
  if (trial.valid()) trial.get();
  return encoder;
}

video::Manifest manifest_of(const RenderSettings& settings, const scene::Scene& scene,
                            const draw::FilmRenderer& renderer, const std::vector<int>& asked) {
  video::Manifest manifest;
  manifest.version = TWRENCH_VERSION;
  manifest.scene = scene::scene_json(scene);
  manifest.font = renderer.typeface_digest();
  manifest.renderer = renderer.description();
  manifest.width = scene.film.width;
  manifest.height = scene.film.height;
  manifest.fps = scene.film.fps;
  manifest.range = video::format_frame_range(asked);
  manifest.shard = settings.shard;
  if (settings.video) {
    const video::VideoFormat format = video_format(scene, *settings.video);
    manifest.encoder = video::encoder_arguments(format);
    manifest.quality = video::chosen_quality(format);
  }
  return manifest;
}

/// Reads a frame that --resume keeps; without its image if no video needs it.
image::Frame read_frame(const fs::path& path, bool has_video) {
  if (!has_video) return {{}, {}, false};
  image::Image image = image::read_png(path);
  const image::Area all{0, 0, image.width, image.height};
  return {std::move(image), {all}, false};
}

/// The video file that the run writes, if any.
std::optional<fs::path> video_file(const RenderSettings& settings) {
  if (!settings.video || settings.video->is_streamed()) return std::nullopt;
  return settings.video->path;
}

PlannedOutput planned_output(const RenderSettings& settings, const scene::Scene& scene,
                             const std::optional<FramesOutput>& frames, std::size_t count) {
  PlannedOutput planned;
  planned.frame_pixels = double(scene.film.width) * scene.film.height;
  if (frames) {
    planned.frames_folder = frames->folder();
    planned.new_frames = frames->count_without_file();
  }
  planned.film = video_file(settings);
  if (planned.film) planned.film_frames = count;
  return planned;
}

/// The captions and chapters of a video of the timeline's frames; an animated image has none.
video::TextTracks text_tracks_of(const scene::Scene& scene, const timeline::FilmTimeline& timeline,
                                 const VideoOutput& video) {
  video::TextTracks tracks;
  if (video::is_animated_image(video.container)) return tracks;
  tracks.captions = video::cues_of(timeline.size(), scene.film.fps, [&](std::size_t i) {
    return timeline::scene_of_shot(scene, timeline.shot(i)).caption.value_or("");
  });
  if (!video.chapters) return tracks;
  tracks.chapters = video::chapters_of(timeline.size(), scene.film.fps, [&](std::size_t i) {
    const auto [count, last] = timeline.flips(i);
    return video::chapter_title(count, last);
  });
  return tracks;
}

}  // namespace

int default_job_count() {
  return static_cast<int>(std::clamp(system::processor_count() / 2, 1U, 8U));
}

RenderJob::RenderJob(const scene::Scene& scene, RenderSettings settings)
    : scene_(scene), settings_(std::move(settings)) {
  require_separate_files(scene_, settings_);
  const std::vector<int> asked = asked_frames(scene_, settings_.range);  // of all shards
  const std::vector<int> numbers = video::frames_of_shard(asked, settings_.shard);
  if (settings_.video) {
    require_sound_container(scene_, settings_.video->container);
    const bool has_sound = video::output_format(settings_.video->container).sound != nullptr;
    if (has_sound) warnings_ = check_narration(scene_);
  }
  std::ranges::move(scene::hasty_captions(scene_), std::back_inserter(warnings_));
  gl_trial_.emplace(settings_.backend);  // forks, so do it before there are threads
  std::future<void> encoder_trial = try_encoder(settings_, scene_);
  {
    const Timed timed(times_.pose);
    timeline_.emplace(scene_, numbers, settings_.stop);
  }
  std::ranges::move(visible_errors(*timeline_), std::back_inserter(warnings_));
  opened_ = gl::open_context(*gl_trial_);
  renderer_.emplace(*opened_.context, scene_);
  if (const auto& warning = renderer_->caption_warning()) warnings_.push_back(*warning);
  frames_.resize(numbers.size());

  const video::Manifest manifest = manifest_of(settings_, scene_, *renderer_, asked);
  const std::string identity = video::video_identity(manifest, numbers);
  std::vector<std::string> replaceable{identity};
  if (settings_.reuse == Reuse::resume && has_sound(scene_)) {  // it adds sound to the same film
    replaceable.push_back(video::silent_video_identity(manifest, numbers));
  }
  const std::optional<fs::path> file = video_file(settings_);
  if (file && settings_.reuse != Reuse::overwrite) video::require_replaceable(*file, replaceable);
  if (settings_.frames_folder) {
    output_.emplace(*settings_.frames_folder, manifest, numbers, settings_.reuse);
  }
  if (!frames_.empty()) {
    const timeline::FilmFrame first = timeline_->frame(0);
    renderer_->camera(*timeline_, first);  // fails now, if OpenGL cannot draw it
    require_space(planned_output(settings_, scene_, output_, frames_.size()),
                  [&] { return renderer_->draw(*timeline_, first).image; });
  }

  if (settings_.video) {
    const auto tracks = text_tracks_of(scene_, *timeline_, *settings_.video);
    auto sound = sound_track(scene_, numbers, settings_.video->container, patience_of(settings_));
    encoder_ = open_encoder(settings_, scene_, identity, tracks, std::move(sound),
                            std::move(encoder_trial));
    // While the encoder waited for another run to end, that run may have written the video.
    if (file && settings_.reuse != Reuse::overwrite) video::require_replaceable(*file, replaceable);
    text_tracks_ = std::make_unique<video::TextTrackFiles>(
        settings_.video->path, settings_.video->container, tracks, replaceable,
        settings_.reuse == Reuse::overwrite);
  }
  if (output_) sequence_ = &output_->open();
}

void RenderJob::run(const ProgressCallback& progress) {
  const auto begin = [&](std::size_t index) {
    const timeline::FilmFrame frame = timeline_->frame(index);
    const picture::Camera camera = renderer_->camera(*timeline_, frame);
    frames_[index] = record_of(frame, timeline_->flips(index), camera);
    const auto kept = output_ ? output_->kept(frames_[index]) : std::nullopt;
    if (!kept) return renderer_->begin(*timeline_, frame, camera);
    const fs::path file = output_->folder() / kept->file;
    return image::PendingFrame{[] {}, [=, this] { return read_frame(file, encoder_ != nullptr); }};
  };
  run_pipeline(frames_, {begin, renderer_->frames_ahead()},
               {sequence_, encoder_.get(), settings_.jobs, start_}, progress, times_);
  if (sequence_ != nullptr) sequence_->finish();
  if (encoder_) encoder_->finish();
  if (text_tracks_) text_tracks_->finish();
}

std::optional<std::size_t> RenderJob::record_frames() {
  if (sequence_ == nullptr) return std::nullopt;
  sequence_->finish();
  return sequence_->count(frames_);
}

}  // namespace twrench::film
