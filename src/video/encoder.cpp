#include "video/encoder.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/words.h"
#include "system/file.h"
#include "system/program.h"
#include "video/error.h"
#include "video/video_file.h"

namespace twrench::video {
namespace {

system::ChildProcess start_ffmpeg(const Arguments& command, system::Patience patience,
                                  int output = system::ChildProcess::output_dropped) {
  return system::start_program<EncoderError>(command, ffmpeg_remedy, patience, output);
}

/// A user can try the command by hand.
std::string command_remedy(const Arguments& command) {
  return "the command was: " + system::shell_command(command);
}

/// The system's error number of the file if it made ffmpeg fail; otherwise 0.
int file_failure(const std::string& said, int status) {
  if (status == 128 + SIGXFSZ) return EFBIG;
  if (status == 128 + SIGPIPE) return EPIPE;
  for (const int error : {ENOSPC, EDQUOT, EFBIG, EROFS, EIO, EPIPE}) {
    if (said.find(std::generic_category().message(error)) != std::string::npos) return error;
  }
  return 0;
}

/// The output as an argument. The "file:" prefix keeps a name from being taken for an option or a
/// protocol.
std::string output_argument(const system::PendingFile& file) {
  return file.is_direct() ? "pipe:1" : "file:" + file.path().string();
}

/// The arguments of the inputs after the frames, which contain the chapters and the sound.
Arguments more_inputs(const std::optional<system::MemoryFile>& chapters, const SoundTrack* sound) {
  Arguments inputs, uses;
  if (chapters) {
    inputs = {"-f", "ffmetadata", "-i", "pipe:" + std::to_string(chapters->descriptor())};
    uses = {"-map_chapters", "1"};
  }
  if (sound != nullptr) {
    const std::string number = chapters ? "2" : "1";
    inputs.insert(inputs.end(), {"-i", sound->input()});
    uses.insert(uses.end(), {"-map", "0:v", "-map", number + ":a", "-c:a", "copy"});
  }
  return joined({inputs, uses});
}

}  // namespace

void require_encoder(const VideoFormat& format, system::Patience patience) {
  const Arguments command = joined({{"ffmpeg"}, encoder_arguments(format), {"-f", "null", "-"}});
  system::ChildProcess ffmpeg = start_ffmpeg(command, patience);
  start_ffmpeg({"ffprobe", "-version"}, patience);  // killed at once: it need only start
  // A frame of the real size, because not every encoder supports every size.
  if (format.is_rgb()) {
    ffmpeg.write(image::Image(format.width, format.height, format.transparent ? 4 : 3).pixels);
  } else {
    ffmpeg.write(image::Yuv420(format.width, format.height).bytes());
  }
  if (const int status = ffmpeg.wait(); status != 0) {
    throw EncoderError(
        "ffmpeg cannot encode the video", system::failure_of("ffmpeg", ffmpeg, status),
        ffmpeg.timed_out()
            ? command_remedy(command)
            : fmt::format(
                  "choose a smaller size, or install an ffmpeg that has {}: apt-get install ffmpeg",
                  output_format(format.container).encoding(format.transparent).codec->name));
  }
}

VideoEncoder::VideoEncoder(const std::filesystem::path& output, const VideoFormat& format,
                           const std::string& identity, const std::vector<Cue>& chapters,
                           system::Patience patience, std::shared_ptr<const SoundTrack> sound)
    : format_(format),
      step_(format.frame_step()),
      identity_(identity),
      patience_(patience),
      name_(output == "-" ? "standard output" : output.string()),
      sound_(std::move(sound)),
      file_(output == "-" ? "/dev/fd/1" : output),
      converted_{Converted(format), Converted(format)} {
  file_.claim();
  const OutputFormat& written = output_format(format.container);
  if (!chapters.empty() && written.is_video()) chapters_.emplace(chapter_metadata(chapters));
  if (written.has_palette) passes_.emplace(file_);
  const Arguments input = joined({{"ffmpeg"}, input_arguments(format)});
  start(passes_ ? joined({input, passes_->first(format)}) : joined({input, rest_of_command()}));
}

/// The arguments after the input of raw frames, if there is only one pass.
Arguments VideoEncoder::rest_of_command() const {
  VideoFormat format = format_;
  format.streamed = file_.is_direct();  // it may not be seekable
  Arguments arguments = joined({more_inputs(chapters_, sound_.get()), output_arguments(format)});
  if (!identity_.empty()) arguments.insert(arguments.end(), {"-metadata", "comment=" + identity_});
  arguments.push_back(output_argument(file_));
  return arguments;
}

void VideoEncoder::start(Arguments command) {
  command_ = std::move(command);
  const int output = file_.is_direct() ? file_.descriptor() : system::ChildProcess::output_dropped;
  ffmpeg_.reset(new system::ChildProcess(start_ffmpeg(command_, patience_, output)));
}

void VideoEncoder::convert(const image::Image& frame, std::span<const image::Area> damage,
                           const Background& background) {
  if (frame.width != format_.width || frame.height != format_.height) {
    throw std::invalid_argument("the frame does not have the video's size");
  }
  if ((frame.channels == 4) != format_.transparent) {
    throw std::invalid_argument("the frame and the video do not both have alpha");
  }
  if (!is_kept()) return;
  if (format_.is_rgb()) {
    rgb_ = frame.pixels;
    return;
  }
  current_ = 1 - current_;
  auto& [planes, changed, background_before] = converted_[current_];
  if (background == nullptr || background != background_before) {
    changed.assign(1, {0, 0, format_.width, format_.height});
  }
  changed.insert(changed.end(), damage.begin(), damage.end());
  for (const image::Area& area : image::merged(std::move(changed))) planes.update(frame, area);
  changed.assign(damage.begin(), damage.end());
  background_before = background;
}

void VideoEncoder::write_converted() {
  if (is_kept()) {
    const auto frame = format_.is_rgb() ? std::span<const std::uint8_t>(rgb_)
                                        : converted_[current_].planes.bytes();
    // The memory of a lent frame is reused for the next frame but one. ffmpeg has read it by then,
    // because the frame in between is at least as large as the pipe and has displaced it.
    const bool may_lend = !format_.is_rgb() && frame.size() >= ffmpeg_->pipe_size();
    if (!(may_lend ? ffmpeg_->lend(frame) : ffmpeg_->write(frame))) fail();
  }
  ++frames_;
}

void VideoEncoder::write(const image::Image& frame) {
  convert(frame, std::array{image::Area{0, 0, format_.width, format_.height}}, nullptr);
  write_converted();
}

void VideoEncoder::finish() {
  // Moving the index to the front (faststart) rewrites the video.
  if (ffmpeg_->wait(disk_time(file_.path())) != 0) fail();
  if (passes_) draw_in_palette();
  if (!file_.is_direct()) {
    require_whole();
    if (is_animated_image(format_.container) && !identity_.empty())
      append_comment(file_.path(), identity_);
  }
  file_.commit();
}

void VideoEncoder::draw_in_palette() {
  start(joined({{"ffmpeg"},
                words_of(quiet_options),
                passes_->second(),
                words_of(codec_arguments(format_)),
                {output_argument(file_)}}));
  constexpr std::int64_t slow_machine = 500;  // pixels per millisecond
  const std::int64_t pixels = frames_ / step_ * format_.shown_width() * format_.shown_height();
  if (ffmpeg_->wait(system::ChildProcess::Time(pixels / slow_machine)) != 0) fail();
}

/// ffmpeg's exit status is no proof of success: the video is examined before it replaces another.
void VideoEncoder::require_whole() const {
  const auto film = probe_video(file_.path());
  const int width = format_.shown_width(), height = format_.shown_height();
  const std::int64_t frames = (frames_ + step_ - 1) / step_;
  const double fps = format_.fps / static_cast<double>(step_);
  const double duration = static_cast<double>(frames) / fps;
  const bool is_animation = is_animated_image(format_.container);
  // An animated image may merge equal frames, and a single frame has no duration.
  const auto is_right = [&](const VideoProperties& of) {
    return of.width == width && of.height == height &&
           (of.frames == frames || (is_animation && of.frames < frames && of.frames > 0));
  };
  // Matroska rounds times to milliseconds, and some containers omit the last frame's duration.
  const auto is_as_long = [&](const VideoProperties& of) {
    return std::abs(of.duration - duration) <= 1.5 / fps + 0.01 || (is_animation && of.frames == 1);
  };
  if (film && is_right(*film) && is_as_long(*film)) return;
  throw EncoderError(
      "cannot encode " + name_,
      film ? fmt::format("ffmpeg wrote a video of {} frames, {:.3f} s and {}x{}, but was given {}, "
                         "{:.3f} s and {}x{}",
                         film->frames, film->duration, film->width, film->height, frames, duration,
                         width, height)
           : "ffmpeg reported success, but its output is not a video",
      command_remedy(command_));
}

void VideoEncoder::fail() {
  const int status = ffmpeg_->wait();
  const std::string what = "cannot encode " + name_;
  if (const int error = file_failure(ffmpeg_->error_output(), status))
    throw system::file_error(what, error);
  throw EncoderError(what, system::failure_of("ffmpeg", *ffmpeg_, status),
                     command_remedy(command_));
}

}  // namespace twrench::video
