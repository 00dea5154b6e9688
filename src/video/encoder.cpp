#include "video/encoder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "system/file.h"
#include "system/program.h"
#include "video/error.h"
#include "video/video_file.h"

namespace twrench::video {
namespace {

/// Returns fps as a fraction for ffmpeg, the simplest one within 1e-9 (by continued fractions): 60
/// is 60/1, 59.94 is 2997/50.
std::string rational(double fps) {
  constexpr double largest = 1e6;
  if (!(fps >= 1e-3 && fps <= 1e3)) {
    throw OutOfRange(fmt::format("fps {}", fps),
                     "a video must have 0.001 to 1000 frames per second", {fps, 1e-3, 1e3});
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

/// Splits a text at its spaces.
std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

system::ChildProcess start(const std::vector<std::string>& command, system::Patience patience,
                           int output = system::ChildProcess::output_dropped) {
  return system::start_program<EncoderError>(command, "install it: apt-get install ffmpeg",
                                             patience, output);
}

/// Why ffmpeg failed, with its own message.
std::string failure(const system::ChildProcess& ffmpeg, int status) {
  const std::string said = system::last_words(ffmpeg.error_output());
  if (ffmpeg.hung()) return "ffmpeg stopped responding and was killed: " + said;
  return fmt::format("ffmpeg ended with exit status {}: {}", status, said);
}

/// The system's error number of the file, if that is why ffmpeg failed; otherwise 0.
int file_failure(const std::string& said, int status) {
  if (status == 128 + SIGXFSZ) return EFBIG;
  if (status == 128 + SIGPIPE) return EPIPE;
  for (const int error : {ENOSPC, EDQUOT, EFBIG, EROFS, EIO, EPIPE}) {
    if (said.find(std::generic_category().message(error)) != std::string::npos) return error;
  }
  return 0;
}

std::vector<std::string> ffmpeg_command(std::vector<std::string> arguments,
                                        std::initializer_list<std::string> output) {
  arguments.insert(arguments.begin(), "ffmpeg");
  arguments.insert(arguments.end(), output);
  return arguments;
}

/// The command from raw frames to the file. Output that is not seekable is streamed.
std::vector<std::string> command(VideoFormat format, const system::PendingFile& file,
                                 const std::string& identity) {
  format.streamed = file.is_direct();
  std::vector<std::string> arguments = encoder_arguments(format);
  if (!identity.empty()) arguments.insert(arguments.end(), {"-metadata", "comment=" + identity});
  // The "file:" prefix keeps a name from being taken for an option or a protocol.
  const std::string output = file.is_direct() ? "pipe:1" : "file:" + file.path().string();
  return ffmpeg_command(std::move(arguments), {output});
}

/// Composites the unpremultiplied image over black.
void blend_over_black(const image::Image& rgba, image::Image& rgb) {
  const std::size_t pixels = rgba.pixels.size() / 4;
  rgb = image::Image(rgba.width, rgba.height, 3);
  for (std::size_t i = 0; i < pixels; ++i) {
    const int alpha = rgba.pixels[4 * i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      rgb.pixels[3 * i + c] =
          static_cast<std::uint8_t>((rgba.pixels[4 * i + c] * alpha + 127) / 255);
    }
  }
}

/// From RGBA. ProRes takes its tags from the frames, not from the options. Without accurate_rnd the
/// conversion darkens colours by a tenth of a level on average.
constexpr const char* conversion =
    "-vf scale=in_range=pc:out_range=tv:out_color_matrix=bt709:flags=bicubic+accurate_rnd,"
    "setparams=color_primaries=bt709:color_trc=bt709:colorspace=bt709";

}  // namespace

std::vector<std::string> encoder_arguments(const VideoFormat& format) {
  const auto& [width, height, fps, container, transparent, streamed] = format;
  if (width < 2 || height < 2 || width % 2 != 0 || height % 2 != 0) {
    throw FilmSizeError(fmt::format("a video of {}x{}", width, height),
                        "the width and height of a video must be even",
                        std::max(2, width + width % 2), std::max(2, height + height % 2));
  }
  // Planar frames are tagged at the input too: since 7.1, ffmpeg's encoders tag a video as its
  // frames are tagged, whatever the output options say.
  const std::string frame_tags =
      format.has_alpha() ? "" : fmt::format("{} -chroma_sample_location left", bt709_tags);
  return words(
      fmt::format("-hide_banner -loglevel error -xerror -y "
                  "-f rawvideo -pix_fmt {} -video_size {}x{} -framerate {} {} -i pipe:0 {} {}",
                  format.has_alpha() ? "rgba" : "yuv420p", width, height, rational(fps), frame_tags,
                  format.has_alpha() ? conversion : "",
                  codec_arguments(container, format.has_alpha(), streamed)));
}

void require_encoder(const VideoFormat& format, system::Patience patience) {
  system::ChildProcess ffmpeg =
      start(ffmpeg_command(encoder_arguments(format), {"-f", "null", "-"}), patience);
  system::ChildProcess ffprobe = start({"ffprobe", "-version"}, patience);
  // A frame of the real size, because not every encoder supports every size.
  if (format.has_alpha()) {
    ffmpeg.write(image::Image(format.width, format.height, 4).pixels);
  } else {
    ffmpeg.write(image::Yuv420(format.width, format.height).bytes());
  }
  if (const int status = ffmpeg.wait(); status != 0) {
    throw EncoderError(
        "ffmpeg cannot encode the video", failure(ffmpeg, status),
        "choose a smaller size, or install one that has libx264, libvpx and prores_ks: apt-get "
        "install ffmpeg");
  }
  ffprobe.wait();
}

VideoEncoder::VideoEncoder(const std::filesystem::path& output, const VideoFormat& format,
                           const std::string& identity, system::Patience patience)
    : format_(format),
      name_(output == "-" ? "standard output" : output.string()),
      file_(output == "-" ? "/dev/fd/1" : output),
      command_(command(format_, file_, identity)),
      ffmpeg_(start(command_, patience,
                    file_.is_direct() ? file_.descriptor() : system::ChildProcess::output_dropped)),
      converted_{Converted(format), Converted(format)} {
  file_.claim();
}

void VideoEncoder::convert(const image::Image& frame, std::span<const image::Area> damage,
                           const Background& background) {
  if (frame.width != format_.width || frame.height != format_.height) {
    throw std::invalid_argument("the frame does not have the video's size");
  }
  if (format_.has_alpha()) {
    with_alpha_ = frame.pixels;
    return;
  }
  const image::Image* shown = &frame;
  if (frame.channels == 4) {
    blend_over_black(frame, opaque_);
    shown = &opaque_;
  }
  current_ = 1 - current_;
  auto& [planes, changed, background_before] = converted_[current_];
  if (background == nullptr || background != background_before) {
    changed.assign(1, {0, 0, format_.width, format_.height});
  }
  changed.insert(changed.end(), damage.begin(), damage.end());
  for (const image::Area& area : image::merged(std::move(changed))) planes.update(*shown, area);
  changed.assign(damage.begin(), damage.end());
  background_before = background;
}

void VideoEncoder::write_converted() {
  const auto frame = format_.has_alpha() ? std::span<const std::uint8_t>(with_alpha_)
                                         : converted_[current_].planes.bytes();
  // A lent frame has been read by the time its memory is reused for the next but one: the frame in
  // between, at least as large as the pipe, has pushed it through.
  const bool may_lend = !format_.has_alpha() && frame.size() >= ffmpeg_.pipe_size();
  if (!(may_lend ? ffmpeg_.lend(frame) : ffmpeg_.write(frame))) fail();
  ++frames_;
}

void VideoEncoder::write(const image::Image& frame) {
  convert(frame, std::array{image::Area{0, 0, format_.width, format_.height}}, nullptr);
  write_converted();
}

void VideoEncoder::finish() {
  // Moving the index to the front (faststart) rewrites the video.
  if (ffmpeg_.wait(disk_time(file_.path())) != 0) {
    fail();
  }
  if (!file_.is_direct()) require_whole();
  file_.commit();
}

/// ffmpeg's exit status is no proof of success: the video is examined before it replaces another.
void VideoEncoder::require_whole() const {
  const auto film = probe_video(file_.path());
  const double duration = static_cast<double>(frames_) / format_.fps;
  // Matroska rounds times to milliseconds, and some containers omit the last frame's duration.
  const bool is_whole = film && film->width == format_.width && film->height == format_.height &&
                        film->frames == frames_ &&
                        std::abs(film->duration - duration) <= 1.5 / format_.fps + 0.01;
  if (is_whole) return;
  throw EncoderError(
      "cannot encode " + name_,
      film ? fmt::format("ffmpeg wrote a video of {} frames, {:.3f} s and {}x{}, but was given {}, "
                         "{:.3f} s and {}x{}",
                         film->frames, film->duration, film->width, film->height, frames_, duration,
                         format_.width, format_.height)
           : "ffmpeg reported success, but its output is not a video",
      "the command was: " + system::shell_command(command_));
}

void VideoEncoder::fail() {
  const int status = ffmpeg_.wait();
  const std::string what = "cannot encode " + name_;
  if (const int error = file_failure(ffmpeg_.error_output(), status))
    throw system::file_error(what, error);
  throw EncoderError(what, failure(ffmpeg_, status),
                     "the command was: " + system::shell_command(command_));
}

}  // namespace twrench::video
