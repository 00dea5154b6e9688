#include "video/encode_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <future>
#include <memory>
#include <utility>
#include <vector>

#include "image/png.h"
#include "system/bytes.h"
#include "system/error.h"
#include "system/file.h"
#include "system/output.h"
#include "system/processors.h"
#include "video/encoder.h"
#include "video/error.h"
#include "video/frame_range.h"
#include "video/manifest.h"
#include "video/sound_track.h"
#include "video/text_tracks.h"
#include "video/video_file.h"

namespace twrench::video {
namespace {

/// Removes from the manifest the records whose file is missing, and returns the frames of its range
/// that it then lacks.
std::vector<int> missing_frames(Manifest& manifest, const std::filesystem::path& folder) {
  std::erase_if(manifest.frames, [&](const FrameRecord& record) {
    return !std::filesystem::exists(folder / record.file);
  });
  std::vector<int> missing;
  auto record = manifest.frames.begin();
  for (const int frame : parse_frame_range(manifest.range, max_frame_count)) {
    const bool told = record != manifest.frames.end() && record->frame == frame;
    if (!told) missing.push_back(frame);
    record += told ? 1 : 0;
  }
  return missing;
}

[[noreturn]] void throw_missing(const std::filesystem::path& folder,
                                const std::vector<int>& missing) {
  const std::string range = brief_frame_range(missing);
  throw FramesError("cannot encode " + folder.string(), "frames are missing: " + range,
                    FramesError::Reason::missing, missing);
}

/// Reads a frame. Throws FileError if it differs from the frame that was drawn.
image::Image read_frame(const FrameRecord& record, const std::filesystem::path& folder,
                        const Manifest& manifest) {
  constexpr std::size_t longest = 1U << 30U;
  const std::filesystem::path path = folder / record.file;
  const auto png = system::read_regular_file(path, longest);
  if (system::sha256_hex(png) != record.sha256) {
    throw FramesError("cannot use " + path.string(),
                      "its contents do not match the digest in the manifest",
                      FramesError::Reason::altered, {record.frame});
  }
  image::Image image = image::decode_png(png, path.string());
  if (image.width != manifest.width || image.height != manifest.height) {
    throw system::FileError(
        "cannot use " + path.string(),
        fmt::format("it has {}x{} pixels, but the manifest says {}x{}", image.width, image.height,
                    manifest.width, manifest.height));
  }
  return image;
}

/// Throws if only one of the frame and the first frame has alpha.
void require_alpha_as_first(const image::Image& frame, bool transparent,
                            const std::filesystem::path& path) {
  if ((frame.channels == 4) == transparent) return;
  throw system::FileError("cannot use " + path.string(),
                          transparent ? "it has no transparency, but the first frame has"
                                      : "it is transparent, but the first frame is not");
}

/// Reads the frames of a manifest in order, several at once.
class FrameReader {
 public:
  /// The manifest must outlive the reader.
  FrameReader(const Manifest& manifest, std::filesystem::path folder)
      : manifest_(manifest), folder_(std::move(folder)), next_(manifest.frames.begin()) {}

  /// Returns the next frame, or throws as read_frame(). There must be one.
  image::Image next() {
    begin_more();
    image::Image frame = begun_.front().get();
    begun_.pop_front();
    begin_more();
    return frame;
  }

 private:
  void begin_more() {
    for (; begun_.size() < at_once_ && next_ != manifest_.frames.end(); ++next_) {
      begun_.push_back(std::async(std::launch::async, [this, &record = *next_] {
        return read_frame(record, folder_, manifest_);
      }));
    }
  }

  /// At most eight, because no encoder is faster than eight threads, and each keeps a frame in
  /// memory.
  const std::size_t at_once_ = std::min(system::processor_count(), 8U);
  const Manifest& manifest_;
  const std::filesystem::path folder_;
  std::vector<FrameRecord>::const_iterator next_;
  std::deque<std::future<image::Image>> begun_;  ///< declared last, so that they are joined first
};

/// Throws OverwriteError if an output is one of the inputs or another output.
void require_separate_files(const VideoOutput& output, const std::filesystem::path& folder,
                            const Manifest& manifest) {
  system::FileList files;
  for (const auto& path : manifests_in(folder)) files.add_input(path);
  for (const FrameRecord& record : manifest.frames) files.add_input(folder / record.file);
  files.add_input(output.audio);
  files.add_output(output.path);
  for (const auto& track : text_track_files(output.path, output.container)) files.add_output(track);
}

/// The caption of a shot in the manifest's scene, which may come from an untrusted source.
std::string caption_of(const nlohmann::ordered_json& scene, int shot) {
  const nlohmann::ordered_json::json_pointer place(fmt::format("/shot/{}/caption", shot));
  if (!scene.contains(place) || !scene.at(place).is_string()) return "";
  return scene.at(place).get<std::string>();
}

/// The captions and chapters of a video; none for an animated image.
TextTracks text_tracks_of(const Manifest& manifest, const VideoOutput& output) {
  const std::vector<FrameRecord>& frames = manifest.frames;
  TextTracks tracks;
  if (is_animated_image(output.container)) return tracks;
  tracks.captions = cues_of(frames.size(), manifest.fps, [&](std::size_t i) {
    return caption_of(manifest.scene, frames[i].shot);
  });
  if (!output.chapters) return tracks;
  tracks.chapters = chapters_of(frames.size(), manifest.fps, [&](std::size_t i) {
    return chapter_title(frames[i].flips, frames[i].last_flip);
  });
  return tracks;
}

/// Gives the scene of the manifest the sound that the video will have.
void set_sound(Manifest& manifest, const VideoOutput& output) {
  const OutputFormat& format = output_format(output.container);
  if (!output.audio.empty() && format.sound == nullptr) {
    throw InvalidArgument(
        "audio", fmt::format("{} has no sound", format.label),
        "leave it out, or choose " +
            listed(format_texts(&OutputFormat::ending, &OutputFormat::sound), "or"));
  }
  const bool is_replaced = output.leave_sound_out || !output.audio.empty();
  if (!is_replaced && format.sound != nullptr && has_sound(manifest.scene)) {
    throw InvalidArgument("sound", "the scene has sound, which its frames do not contain",
                          "leave the sound out or name a sound file, or resume the run that drew "
                          "the frames, which then makes the video with sound");
  }
  manifest.scene = without_sound(std::move(manifest.scene));
  if (output.audio.empty() || !manifest.scene.is_object()) return;
  nlohmann::ordered_json& film = manifest.scene["film"];
  if (!film.is_object()) film = nlohmann::ordered_json::object();
  film["audio"] = output.audio.string();
}

/// The sound of the video, encoded; null if it has none.
std::shared_ptr<const SoundTrack> sound_of(const Manifest& manifest, const VideoOutput& output) {
  if (output.audio.empty()) return nullptr;
  const double length = double(manifest.frames.size()) / manifest.fps;
  return std::make_shared<SoundTrack>(
      SoundMix{.files = {{output.audio}}, .end = length, .film_length = length}, output.container);
}

VideoFormat format_of(const Manifest& manifest, const VideoOutput& output, bool transparent) {
  VideoFormat format{.width = manifest.width,
                     .height = manifest.height,
                     .fps = manifest.fps,
                     .container = output.container,
                     .transparent = transparent,
                     .quality = output.quality};
  if (is_animated_image(format.container))
    format.scaled_width = output.width.value_or(std::min(format.width, widest_animation));
  return format;
}

}  // namespace

std::vector<int> encode_frames(const std::filesystem::path& folder, const VideoOutput& output,
                               MissingFrames when_missing,
                               const std::function<void(int done, int total)>& progress) {
  Manifest manifest = read_manifests(folder);
  std::vector<int> missing = missing_frames(manifest, folder);
  const bool some_left = !manifest.frames.empty() && when_missing == MissingFrames::leave_out;
  if (!missing.empty() && !some_left) throw_missing(folder, missing);
  require_separate_files(output, folder, manifest);
  set_sound(manifest, output);
  std::vector<int> shown(manifest.frames.size());
  std::ranges::transform(manifest.frames, shown.begin(), &FrameRecord::frame);
  const std::string identity = video_identity(manifest, shown);
  if (!output.overwrite) require_replaceable(output.path, {identity});
  const bool transparent = read_frame(manifest.frames.front(), folder, manifest).channels == 4;
  const VideoFormat format = format_of(manifest, output, transparent);
  require_encoder(format);
  auto sound = sound_of(manifest, output);
  if (output.path.has_parent_path()) system::make_folder(output.path.parent_path());
  const TextTracks tracks = text_tracks_of(manifest, output);
  VideoEncoder encoder(output.path, format, identity, tracks.chapters, {}, std::move(sound));
  // While the encoder waited for another run to end, that run may have written the video.
  if (!output.overwrite) require_replaceable(output.path, {identity});
  TextTrackFiles track_files(output.path, output.container, tracks, {identity}, output.overwrite);
  FrameReader reader(manifest, folder);
  const int total = static_cast<int>(manifest.frames.size());
  for (int done = 0; done < total; progress(++done, total)) {
    const image::Image frame = reader.next();
    require_alpha_as_first(frame, transparent,
                           folder / manifest.frames[static_cast<std::size_t>(done)].file);
    encoder.write(frame);
  }
  encoder.finish();
  track_files.finish();
  return missing;
}

}  // namespace twrench::video
