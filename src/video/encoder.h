#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/area.h"
#include "image/frame.h"
#include "image/image.h"
#include "image/yuv.h"
#include "system/child_process.h"
#include "system/descriptor.h"
#include "system/error.h"
#include "system/pending_file.h"
#include "video/animated_image.h"
#include "video/codec.h"
#include "video/sound_track.h"
#include "video/text_tracks.h"

namespace twrench::video {

/// Encodes a one-frame video with the arguments for this format, to find out whether ffmpeg works.
/// Call it before the first frame is drawn. Throws EncoderError if ffmpeg or ffprobe is missing,
/// fails or hangs, and InvalidArgument as encoder_arguments() does.
void require_encoder(const VideoFormat& format, system::Patience patience = {});

/// Encodes a video by feeding its frames to an ffmpeg process. The output appears under its name
/// when the video is complete, and not at all otherwise. If ffmpeg exhausts the patience, it is
/// killed and encoding fails.
class VideoEncoder {
 public:
  /// `output` is a file, or "-" for standard output. The video is streamed to standard output, to
  /// devices and to pipes. `identity` becomes the video's comment, and `chapters` its chapters, if
  /// the container supports them. `sound` may be null; it must be encoded for the container, and
  /// is as long as the video. Throws InvalidArgument as encoder_arguments() does, FileError if
  /// the output is not writable or another process is writing it, and EncoderError if ffmpeg is
  /// missing.
  VideoEncoder(const std::filesystem::path& output, const VideoFormat& format,
               const std::string& identity = {}, const std::vector<Cue>& chapters = {},
               system::Patience patience = {}, std::shared_ptr<const SoundTrack> sound = nullptr);

  /// Adds a frame, which must have the video's size, and be RGBA if the video is transparent,
  /// otherwise RGB. Throws EncoderError if ffmpeg failed.
  void write(const image::Image& frame);

  /// The two halves of write(). A frame equals its static background outside its damaged areas. If
  /// earlier frames had the same background, only these areas and those of an earlier frame are
  /// converted.
  void convert(const image::Frame& frame) { convert(frame.image, frame.damage, frame.background); }
  void write_converted();

  /// Completes the video and verifies its size, number of frames and duration. Throws EncoderError
  /// if ffmpeg failed or the video does not match, and FileError.
  void finish();

 private:
  using Background = std::shared_ptr<const image::Image>;

  void convert(const image::Image& frame, std::span<const image::Area> damage,
               const Background& background);
  Arguments rest_of_command() const;
  void start(Arguments command);
  /// The second pass of an animated image with a palette.
  void draw_in_palette();
  /// Returns whether the video keeps the next frame.
  bool is_kept() const { return frames_ % step_ == 0; }
  [[noreturn]] void fail();
  void require_whole() const;

  const VideoFormat format_;
  const std::int64_t step_;  ///< One of this many frames is kept.
  const std::string identity_;
  const system::Patience patience_;
  /// Name of the output, for messages.
  const std::string name_;
  std::optional<system::MemoryFile> chapters_;
  const std::shared_ptr<const SoundTrack> sound_;
  system::PendingFile file_;
  std::optional<PalettePasses> passes_;  ///< Set for an animated image with a palette.
  Arguments command_;
  std::unique_ptr<system::ChildProcess>
      ffmpeg_;  // declared after the files, so that it is killed before they are removed
  /// The frame without conversion, for a video that takes RGB or RGBA.
  std::vector<std::uint8_t> rgb_;
  /// A frame in ffmpeg's format, and its damaged areas relative to the static background.
  struct Converted {
    explicit Converted(const VideoFormat& format)
        : planes(format.is_rgb() ? 0 : format.width, format.is_rgb() ? 0 : format.height),
          damage{{0, 0, format.width, format.height}} {}
    image::Yuv420 planes;
    std::vector<image::Area> damage;
    Background background;
  };
  std::array<Converted, 2> converted_;  ///< One is filled while the other is read.
  std::size_t current_ = 0;
  std::int64_t frames_ = 0;  ///< Number of frames written, kept or not.
};

}  // namespace twrench::video
