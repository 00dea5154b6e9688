#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "image/area.h"
#include "image/frame.h"
#include "image/image.h"
#include "image/yuv.h"
#include "system/child_process.h"
#include "system/error.h"
#include "system/pending_file.h"
#include "video/codec.h"

namespace twrench::video {

/// The size, rate and container of a video.
struct VideoFormat {
  /// Width in pixels, even.
  int width = 0;
  /// Height in pixels, even.
  int height = 0;
  /// Frames per second.
  double fps = 0.0;
  /// Container of the video.
  Container container = Container::mp4;
  /// Whether frames are RGBA and the container keeps their alpha.
  bool transparent = false;
  /// Whether the output is a pipe or another file that is not seekable.
  bool streamed = false;

  bool has_alpha() const { return transparent && keeps_alpha(container); }
};

/// Returns ffmpeg's arguments except the output file: from raw frames on its standard input (as
/// Yuv420::bytes() provides them, or RGBA with alpha) to what codec_arguments() describes, tagged
/// BT.709. Throws InvalidArgument for odd sizes, which yuv420p does not allow, and for an invalid
/// rate.
std::vector<std::string> encoder_arguments(const VideoFormat& format);

/// Encodes a one-frame video with the same arguments; call it before the first frame is drawn.
/// Throws EncoderError if ffmpeg or ffprobe is missing, fails or hangs, and InvalidArgument as
/// encoder_arguments() does.
void require_encoder(const VideoFormat& format, system::Patience patience = {});

/// A video being encoded by an ffmpeg process that is fed frames. The output appears under its name
/// when the video is complete, and not at all otherwise. If ffmpeg exhausts the patience, it is
/// killed and encoding fails.
class VideoEncoder {
 public:
  /// `output` is a file, or "-" for standard output; the video is streamed to that, to devices and
  /// to pipes. `identity` becomes the video's comment. Throws InvalidArgument as
  /// encoder_arguments() does, FileError if the output is not writable or another process is
  /// writing it, and EncoderError if ffmpeg is missing.
  VideoEncoder(const std::filesystem::path& output, const VideoFormat& format,
               const std::string& identity = {}, system::Patience patience = {});

  /// Adds a frame, which must have the video's size, and be RGBA if the video has alpha. Otherwise
  /// RGBA is composited over black. Throws EncoderError if ffmpeg failed.
  void write(const image::Image& frame);

  /// The two halves of write(). A frame equals its static background outside its damaged areas:
  /// after other frames with that background, only they and those of an earlier one are converted.
  void convert(const image::Frame& frame) { convert(frame.image, frame.damage, frame.background); }
  void write_converted();

  /// Completes the video and verifies that it matches what was written. Throws EncoderError if
  /// ffmpeg failed or the video does not match, and FileError.
  void finish();

 private:
  using Background = std::shared_ptr<const image::StaticBands>;

  void convert(const image::Image& frame, std::span<const image::Area> damage,
               const Background& background);
  [[noreturn]] void fail();
  void require_whole() const;

  VideoFormat format_;
  /// Name of the output, for messages.
  std::string name_;
  system::PendingFile file_;
  std::vector<std::string> command_;
  system::ChildProcess
      ffmpeg_;  // declared after the file, so that it is killed before the file is removed
  /// An RGBA frame composited over black.
  image::Image opaque_;
  /// RGBA, for a video with alpha.
  std::vector<std::uint8_t> with_alpha_;
  /// A frame in ffmpeg's format, and its damaged areas relative to the static background.
  struct Converted {
    explicit Converted(const VideoFormat& format)
        : planes(format.width, format.height), damage{{0, 0, format.width, format.height}} {}
    image::Yuv420 planes;
    std::vector<image::Area> damage;
    Background background;
  };
  std::array<Converted, 2> converted_;  ///< One is filled while the other is read.
  std::size_t current_ = 0;
  std::int64_t frames_ = 0;  ///< Number of frames written.
};

}  // namespace twrench::video
