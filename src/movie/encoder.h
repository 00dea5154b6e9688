#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/child_process.h"
#include "base/file.h"
#include "image/image.h"
#include "movie/codec.h"

namespace twrench {

struct VideoFormat {
  int width = 0;     ///< pixels, even
  int height = 0;    ///< pixels, even
  double fps = 0.0;  ///< frames per second
  Container container = Container::mp4;
  bool transparent = false;  ///< frames are RGBA, and the container is to keep their alpha

  bool has_alpha() const { return transparent && keeps_alpha(container); }
};

/// ffmpeg's arguments, but for the output file: from raw frames at its standard input, RGB or with
/// alpha RGBA, to what codec_arguments() says, converted to BT.709 limited range and tagged so.
/// Throws UsageError for odd sizes, which yuv420p cannot have, and a rate that is not one.
std::vector<std::string> encoder_arguments(const VideoFormat& format);

/// Encodes a tiny film with those very arguments, to be called before the first frame is drawn.
/// Throws EncoderError when ffmpeg is missing or cannot do it, UsageError as encoder_arguments.
void require_encoder(const VideoFormat& format);

/// A film in the making: an ffmpeg that is fed frames. The output appears under its name when the
/// film is complete, and not at all when it never is.
class VideoEncoder {
 public:
  /// Throws UsageError as encoder_arguments, FileError when the output's folder cannot be written
  /// to, EncoderError when ffmpeg is missing.
  VideoEncoder(const std::filesystem::path& output, const VideoFormat& format);

  /// Adds a frame, which must have the film's size, and RGBA where it is to have alpha. Where it is
  /// not, RGBA is shown over black. Throws EncoderError when ffmpeg failed.
  void write(const Image& frame);

  /// Completes the film. Throws EncoderError when ffmpeg failed, FileError.
  void finish();

 private:
  [[noreturn]] void fail();

  VideoFormat format_;
  PendingFile file_;
  std::vector<std::string> command_;
  ChildProcess ffmpeg_;  // after the file: killed before the file is removed
  std::vector<std::uint8_t> opaque_;
};

}  // namespace twrench
