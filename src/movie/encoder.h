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

struct VideoFormat {
  int width = 0;     ///< pixels, even
  int height = 0;    ///< pixels, even
  double fps = 0.0;  ///< frames per second
  Container container = Container::mp4;
  bool transparent = false;  ///< frames are RGBA, and the container is to keep their alpha
  bool streamed = false;     ///< to a pipe, or another thing that cannot be gone back in

  bool has_alpha() const { return transparent && keeps_alpha(container); }
};

/// ffmpeg's arguments, but for the output file: from raw frames at its standard input, as
/// Yuv420::bytes() gives them or with alpha RGBA, to what codec_arguments() says, tagged BT.709.
/// Throws UsageError for odd sizes, which yuv420p cannot have, and a rate that is not one.
std::vector<std::string> encoder_arguments(const VideoFormat& format);

/// Encodes a film of one frame with those very arguments, to be called before the first frame is
/// drawn. Throws EncoderError when ffmpeg or ffprobe is missing, cannot do it or hangs, UsageError
/// as encoder_arguments.
void require_encoder(const VideoFormat& format,
                     ChildProcess::Time patience = ChildProcess::default_patience);

/// A film in the making: an ffmpeg that is fed frames. The output appears under its name when the
/// film is complete, and not at all when it never is. An ffmpeg that takes nothing for the length
/// of our patience is killed, and has failed.
class VideoEncoder {
 public:
  /// `output` is a file, or "-" for standard output; to that, and to devices and pipes, the film is
  /// streamed. `identity` becomes the film's comment. Throws UsageError as encoder_arguments,
  /// FileError when the output cannot be written to or another process is writing it, EncoderError
  /// when ffmpeg is missing.
  VideoEncoder(const std::filesystem::path& output, const VideoFormat& format,
               const std::string& identity = {},
               ChildProcess::Time patience = ChildProcess::default_patience);

  /// Adds a frame, which must have the film's size, and RGBA where it is to have alpha. Where it is
  /// not, RGBA is shown over black. Throws EncoderError when ffmpeg failed.
  void write(const Image& frame);

  /// The two halves of write(). The frame may be told to be the film's still background outside the
  /// areas `changed`: then, after the first frame, only those and those before are converted.
  void convert(const Image& frame);
  void convert(const Image& frame, std::span<const Area> changed);
  void write_converted();

  /// Completes the film, and looks whether it is what was written. Throws EncoderError when ffmpeg
  /// failed or the film is another, FileError.
  void finish();

 private:
  [[noreturn]] void fail();
  void require_whole() const;

  VideoFormat format_;
  std::string name_;  ///< of the output, for messages
  PendingFile file_;
  std::vector<std::string> command_;
  ChildProcess ffmpeg_;                   // after the file: killed before the file is removed
  Image opaque_;                          ///< an RGBA frame over black
  std::vector<std::uint8_t> with_alpha_;  ///< RGBA, for a film that keeps alpha
  /// A frame as ffmpeg takes it, and where it is not the still background.
  struct Converted {
    explicit Converted(const VideoFormat& format)
        : planes(format.width, format.height), changed{{0, 0, format.width, format.height}} {}
    Yuv420 planes;
    std::vector<Area> changed;
  };
  std::array<Converted, 2> converted_;  ///< one is made while the other is read
  std::size_t current_ = 0;
  std::int64_t frames_ = 0;  ///< written
};

}  // namespace twrench
