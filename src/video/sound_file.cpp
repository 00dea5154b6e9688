#include "video/sound_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <system_error>

#include "base/letters.h"
#include "system/file.h"
#include "system/file_kind.h"
#include "system/output_pipe.h"
#include "system/program.h"
#include "video/error.h"
#include "video/ffprobe.h"

namespace twrench::video {
namespace {

constexpr const char* conversion_remedy =
    "name a file of WAV, FLAC, MP3, AAC, Ogg or another format of sound, or convert it to one";

/// Rejects folders and pipes, because opening a pipe would wait for a writer.
void require_readable(const std::filesystem::path& file) {
  const std::string what = "cannot read " + file.string();
  std::error_code failed;
  const auto status = std::filesystem::status(file, failed);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw system::FileError(what, "it is not a regular file", "name a sound file");
  }
  if (!std::ifstream(file, std::ios::binary)) {
    throw system::file_error(what, errno, system::Access::read);
  }
}

/// The first sound track of a file, as ffprobe describes it.
struct Track {
  double length = 0;  ///< In s; 0 if it is not stated.
  /// Whether the length is that of the samples, not an estimate or that of another track.
  bool is_exact = false;
  double samples_per_second = 0;  ///< The sum over all channels.
};

Track track_of(const nlohmann::json& properties) {
  const nlohmann::json& stream = properties.at("streams").at(0);
  const nlohmann::json& format = properties.at("format");
  const double own_length = ffprobe_number(stream, "duration");
  constexpr std::array exact_formats{"wav", "w64", "aiff", "flac", "ogg"};
  const std::string name = format.value("format_name", "");
  return {
      .length = own_length > 0 ? own_length : ffprobe_number(format, "duration"),
      .is_exact = own_length > 0 && std::ranges::find(exact_formats, name) != exact_formats.end(),
      .samples_per_second = ffprobe_number(stream, "sample_rate") * stream.value("channels", 0)};
}

/// Returns why ffprobe did not find sound in the file.
std::string reason_of(const std::filesystem::path& file) {
  std::array<char, 4096> head{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), head.size());
  const auto size = static_cast<std::size_t>(stream.gcount());
  const auto kind = system::recognized_file_kind({head.data(), size});
  if (!kind) return "it is not a sound file";
  const bool is_sound =
      kind->ends_with(" sound") || kind->ends_with(" film") || *kind == "an Ogg file";
  return is_sound ? fmt::format("it begins like {}, but is damaged", *kind)
                  : fmt::format("it is {}, not a sound file", *kind);
}

/// Throws FileError unless the file has sound.
Track find_track(const std::filesystem::path& file) {
  require_readable(file);
  const auto properties =
      ffprobe(file, joined({sound_input_options(),
                            words_of("-select_streams a:0 -show_entries "
                                     "stream=duration,sample_rate,channels:format=duration,"
                                     "format_name")}));
  const std::string what = "cannot use " + file.string();
  if (!properties) throw system::FileError(what, reason_of(file), conversion_remedy);
  if (properties->value("streams", nlohmann::json::array()).empty()) {
    throw system::FileError(what, "it has no sound", "name a file with a sound track");
  }
  return track_of(*properties);
}

/// Looks at the samples of a sound, of 32 bits each, whose bytes arrive in pieces.
class SampleCheck {
 public:
  void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      sample_[count_++ % sample_.size()] = byte;
      if (count_ % sample_.size() == 0) check(std::bit_cast<float>(sample_));
    }
  }

  /// Returns the fault of the samples; empty if there is none.
  std::string fault() const {
    if (count_ == 0) return "it has no samples";
    if (!are_numbers_) return "it has samples that are not numbers";
    if (largest_ <= most) return {};
    return fmt::format("it has a sample of {:.3g}, and the full scale is 1", largest_);
  }

  std::uint64_t count() const { return count_ / sample_.size(); }

 private:
  /// 60 dB over the full scale.
  static constexpr float most = 1000;

  void check(float sample) {
    are_numbers_ = are_numbers_ && std::isfinite(sample);
    largest_ = std::max(largest_, std::abs(sample));
  }

  std::array<std::uint8_t, sizeof(float)> sample_{};
  std::uint64_t count_ = 0;  ///< The number of bytes.
  bool are_numbers_ = true;
  float largest_ = 0;
};

/// Returns a message if less than `length` s of the track were decoded; empty otherwise.
/// Decoders skip damaged parts of some formats silently.
std::string gap_in(const Track& track, std::uint64_t samples, double length) {
  if (!track.is_exact) return {};
  constexpr double tolerance = 0.1;  // s
  const double decoded = static_cast<double>(samples) / track.samples_per_second;
  const double expected = std::min(track.length, length);
  if (decoded >= expected - tolerance) return {};
  return fmt::format("only {:.2f} s of {:.2f} s can be decoded", decoded, expected);
}

/// Whether a WAV file was written to a pipe, so that its header does not state the true size: its
/// last packet is incomplete, but not damaged.
bool is_streamed_wav(const std::filesystem::path& file) {
  std::array<char, 12> head{};
  std::ifstream(file, std::ios::binary).read(head.data(), head.size());
  const std::string_view text(head.data(), head.size());
  std::uint32_t size = 0;
  for (std::size_t i = 8; i-- > 4;) size = size << 8U | static_cast<std::uint8_t>(head[i]);
  constexpr std::uint32_t unknown = 0x7fff'0000;  // programs state 0, or the largest size they know
  return text.starts_with("RIFF") && text.ends_with("WAVE") && (size == 0 || size >= unknown);
}

/// Returns the first line that ffmpeg printed, without the name and address of its part and the
/// name of the file.
std::string first_message(std::string text, const std::filesystem::path& file) {
  text = text.substr(0, text.find('\n'));
  const std::string name = "file:" + file.string() + ": ";
  if (text.starts_with(name)) text.erase(0, name.size());
  while (text.starts_with('[') && text.find("] ") != std::string::npos) {
    text.erase(0, text.find("] ") + 2);
  }
  return text.empty() ? "its data are damaged" : text;
}

/// Decodes the sound to standard output, and converts it as a film does without keeping the result.
Arguments decoding_command(const std::filesystem::path& file, double length) {
  Arguments strict;
  if (!is_streamed_wav(file)) strict = {"-xerror"};
  return joined({words_of("ffmpeg -nostdin -hide_banner -loglevel error"),
                 strict,
                 sound_input_options(),
                 {"-t", fmt::format("{:.6f}", length), "-i", "file:" + file.string()},
                 words_of("-map 0:a:0 -f f32le pipe:1 -map 0:a:0 -af"),
                 {sound_conversion()},
                 words_of("-f null -")});
}

}  // namespace

Arguments sound_input_options() {
  return words_of(
      "-protocol_whitelist file,pipe -format_whitelist "
      "aac,ac3,aiff,amr,ape,asf,au,avi,caf,eac3,flac,flv,matroska,mov,mp3,mpegts,ogg,tta,w64,wav,"
      "wv");
}

std::string sound_conversion() {
  return "aresample=48000,aformat=sample_fmts=fltp:channel_layouts=stereo";
}

double sound_length(const std::filesystem::path& file) {
  const double length = find_track(file).length;
  return length > 0 ? length : std::numeric_limits<double>::infinity();
}

void require_sound(const std::filesystem::path& file, double length, system::Patience patience) {
  const Track track = find_track(file);
  SampleCheck samples;
  system::OutputPipe output([&](std::span<const std::uint8_t> bytes) { samples.add(bytes); });
  auto ffmpeg = system::start_program<EncoderError>(decoding_command(file, length), ffmpeg_remedy,
                                                    patience, output.descriptor());
  // Ten times as long as a slow processor needs.
  const auto work = system::ChildProcess::Time(std::llround(1e3 * length)) + disk_time(file);
  const int status = ffmpeg.wait(work);
  output.finish();
  const std::string what = "cannot use " + file.string();
  if (ffmpeg.timed_out()) throw EncoderError(what, system::failure_of("ffmpeg", ffmpeg, status));
  std::string fault =
      status == 0 ? samples.fault()
                  : "its sound cannot be decoded: " + first_message(ffmpeg.error_output(), file);
  if (fault.empty()) fault = gap_in(track, samples.count(), length);
  if (!fault.empty()) {
    throw system::FileError(what, fault, "repair it, or export it from its source");
  }
}

}  // namespace twrench::video
