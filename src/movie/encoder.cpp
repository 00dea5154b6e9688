#include "movie/encoder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/error.h"

namespace twrench {
namespace {

/// fps as the fraction that ffmpeg takes, the simplest within 1e-9 of it: 60 is 60/1, 59.94 is
/// 2997/50 (continued fractions).
std::string rational(double fps) {
  constexpr double largest = 1e6;
  if (!(fps >= 1e-3 && fps <= 1e3)) {
    throw UsageError(fmt::format("fps {}", fps), "a film has 0.001 to 1000 frames per second");
  }
  double p = 1, q = 0, p_before = 0, q_before = 1, rest = fps;
  while (true) {
    const double whole = std::floor(rest);
    p_before = std::exchange(p, whole * p + p_before);
    q_before = std::exchange(q, whole * q + q_before);
    const bool close = std::abs(p / q - fps) <= 1e-9 * fps;
    if (close || std::max(p, q) > largest) {
      return fmt::format("{:.0f}/{:.0f}", p, q);
    }
    rest = 1.0 / (rest - whole);
  }
}

/// The words of a text that has a space between any two.
std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

ChildProcess start(const std::vector<std::string>& command) {
  try {
    return ChildProcess(command);
  } catch (const std::system_error& error) {
    const std::string why =
        error.code().value() == ENOENT ? "it was not found in PATH" : error.code().message();
    throw EncoderError("cannot start ffmpeg", why, "install it: apt-get install ffmpeg");
  }
}

std::vector<std::string> ffmpeg_command(std::vector<std::string> arguments,
                                        std::initializer_list<std::string> output) {
  arguments.insert(arguments.begin(), "ffmpeg");
  arguments.insert(arguments.end(), output);
  return arguments;
}

/// The colours over black, where alpha is how much of them is seen.
void blend_over_black(const Image& rgba, std::vector<std::uint8_t>& rgb) {
  const std::size_t pixels = rgba.pixels.size() / 4;
  rgb.resize(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const int alpha = rgba.pixels[4 * i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      rgb[3 * i + c] = static_cast<std::uint8_t>((rgba.pixels[4 * i + c] * alpha + 127) / 255);
    }
  }
}

}  // namespace

std::vector<std::string> encoder_arguments(const VideoFormat& format) {
  const auto& [width, height, fps, container, transparent] = format;
  if (width < 2 || height < 2 || width % 2 != 0 || height % 2 != 0) {
    throw UsageError(fmt::format("a film of {}x{}", width, height),
                     "films need an even width and height",
                     fmt::format("use --size {}x{}, or --no-video for the frames alone",
                                 std::max(2, width + width % 2), std::max(2, height + height % 2)));
  }
  // ProRes takes its tags from the frames, not from the options. Without accurate_rnd the
  // conversion makes colours a tenth of a level darker on average.
  return words(
      fmt::format("-hide_banner -loglevel error -xerror -y "
                  "-f rawvideo -pix_fmt {} -video_size {}x{} -framerate {} -i pipe:0 "
                  "-vf scale=in_range=pc:out_range=tv:out_color_matrix=bt709:"
                  "flags=bicubic+accurate_rnd,"
                  "setparams=color_primaries=bt709:color_trc=bt709:colorspace=bt709 {}",
                  format.has_alpha() ? "rgba" : "rgb24", width, height, rational(fps),
                  codec_arguments(container, format.has_alpha())));
}

void require_encoder(const VideoFormat& format) {
  encoder_arguments(format);  // what is wrong with the size
  VideoFormat tiny = format;
  tiny.width = tiny.height = 64;
  ChildProcess ffmpeg = start(ffmpeg_command(encoder_arguments(tiny), {"-f", "null", "-"}));
  ffmpeg.write(std::vector<std::uint8_t>((format.has_alpha() ? 4U : 3U) * 64 * 64));
  if (ffmpeg.wait() != 0) {
    throw EncoderError(
        "ffmpeg cannot make the film", last_words(ffmpeg.error_output()),
        "install one that has libx264, libvpx and prores_ks: apt-get install ffmpeg");
  }
}

VideoEncoder::VideoEncoder(const std::filesystem::path& output, const VideoFormat& format)
    : format_(format),
      file_(output),
      // "file:" keeps a name from being an option or a protocol.
      command_(ffmpeg_command(encoder_arguments(format), {"file:" + file_.path().string()})),
      ffmpeg_(start(command_)) {}

void VideoEncoder::write(const Image& frame) {
  if (frame.width != format_.width || frame.height != format_.height) {
    throw std::invalid_argument("a frame of another size than the film's");
  }
  const bool blend = frame.channels == 4 && !format_.has_alpha();
  if (blend) {
    blend_over_black(frame, opaque_);
  }
  if (!ffmpeg_.write(blend ? opaque_ : frame.pixels)) {
    fail();
  }
}

void VideoEncoder::finish() {
  if (ffmpeg_.wait() != 0) {
    fail();
  }
  file_.commit();
}

void VideoEncoder::fail() {
  const int status = ffmpeg_.wait();
  const std::string said = last_words(ffmpeg_.error_output());
  const std::string what = "cannot encode " + file_.target().string();
  if (said.find(std::generic_category().message(ENOSPC)) != std::string::npos) {
    throw file_error(what, ENOSPC);
  }
  throw EncoderError(what, fmt::format("ffmpeg ended with exit status {}: {}", status, said),
                     "its command was: " + shell_command(command_));
}

}  // namespace twrench
