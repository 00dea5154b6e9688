#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/child_process.h"
#include "base/file.h"
#include "image/image.h"

namespace twrench {

struct VideoFormat {
  int width = 0;     ///< pixels, even
  int height = 0;    ///< pixels, even
  double fps = 0.0;  ///< frames per second
};

/// ffmpeg's arguments, but for the output file: from raw RGB frames at its standard input to H.264
/// in an MP4, yuv420p, converted to BT.709 limited range and tagged so.
/// Throws UsageError for odd sizes, which yuv420p cannot have, and a rate that is not one.
std::vector<std::string> encoder_arguments(const VideoFormat& format);

/// Encodes a tiny film with those very arguments, to be called before the first frame is drawn.
/// Throws EncoderError when ffmpeg is missing, cannot do it or hangs, UsageError as
/// encoder_arguments.
void require_encoder(const VideoFormat& format,
                     ChildProcess::Time patience = ChildProcess::default_patience);

/// A film in the making: an ffmpeg that is fed frames. The output appears under its name when the
/// film is complete, and not at all when it never is. An ffmpeg that takes nothing for the length
/// of our patience is killed, and has failed.
class VideoEncoder {
 public:
  /// Throws UsageError as encoder_arguments, FileError when the output's folder cannot be written
  /// to, EncoderError when ffmpeg is missing.
  VideoEncoder(const std::filesystem::path& output, const VideoFormat& format,
               ChildProcess::Time patience = ChildProcess::default_patience);

  /// Adds a frame, which must have the film's size. The film has no alpha: RGBA is shown over
  /// black. Throws EncoderError when ffmpeg failed.
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
