#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/child_process.h"
#include "base/pending_file.h"
#include "image/area.h"
#include "image/image.h"
#include "image/yuv.h"
#include "movie/codec.h"

namespace twrench {

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
/// BT.709. Throws UsageError for odd sizes, which yuv420p does not allow, and for an invalid rate.
std::vector<std::string> encoder_arguments(const VideoFormat& format);

/// Encodes a one-frame video with the same arguments; call it before the first frame is drawn.
/// Throws EncoderError if ffmpeg or ffprobe is missing, fails or hangs, and UsageError as
/// encoder_arguments() does.
void require_encoder(const VideoFormat& format,
                     ChildProcess::Time patience = ChildProcess::default_patience);

/// A video being encoded by an ffmpeg process that is fed frames. The output appears under its name
/// when the video is complete, and not at all otherwise. If ffmpeg accepts no data within the time
/// limit, it is killed and encoding fails.
class VideoEncoder {
 public:
  /// `output` is a file, or "-" for standard output; the video is streamed to that, to devices and
  /// to pipes. `identity` becomes the video's comment. Throws UsageError as encoder_arguments()
  /// does, FileError if the output is not writable or another process is writing it, and
  /// EncoderError if ffmpeg is missing.
  VideoEncoder(const std::filesystem::path& output, const VideoFormat& format,
               const std::string& identity = {},
               ChildProcess::Time patience = ChildProcess::default_patience);

  /// Adds a frame, which must have the video's size, and be RGBA if the video has alpha. Otherwise
  /// RGBA is composited over black. Throws EncoderError if ffmpeg failed.
  void write(const Image& frame);

  /// The two halves of write(). With `changed`, the frame equals the static background outside
  /// these damaged areas: after the first frame, only they and those of the previous frame are
  /// converted.
  void convert(const Image& frame);
  void convert(const Image& frame, std::span<const Area> changed);
  void write_converted();

  /// Completes the video and verifies that it matches what was written. Throws EncoderError if
  /// ffmpeg failed or the video does not match, and FileError.
  void finish();

 private:
  [[noreturn]] void fail();
  void require_whole() const;

  VideoFormat format_;
  /// Name of the output, for messages.
  std::string name_;
  PendingFile file_;
  std::vector<std::string> command_;
  ChildProcess ffmpeg_;  // declared after the file, so that it is killed before the file is removed
  /// An RGBA frame composited over black.
  Image opaque_;
  /// RGBA, for a video with alpha.
  std::vector<std::uint8_t> with_alpha_;
  /// A frame in ffmpeg's format, and its damaged areas relative to the static background.
  struct Converted {
    explicit Converted(const VideoFormat& format)
        : planes(format.width, format.height), changed{{0, 0, format.width, format.height}} {}
    Yuv420 planes;
    std::vector<Area> changed;
  };
  std::array<Converted, 2> converted_;  ///< One is filled while the other is read.
  std::size_t current_ = 0;
  std::int64_t frames_ = 0;  ///< Number of frames written.
};

}  // namespace twrench
