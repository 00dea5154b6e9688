#include "video/sound_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "base/words.h"
#include "system/child_process.h"
#include "system/file.h"
#include "system/file_kind.h"
#include "system/program.h"
#include "video/error.h"
#include "video/video_file.h"

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

namespace {

constexpr int sample_rate = 48'000;

/// s. A file that is longer than the film fades out in this time before the film's end.
constexpr double fade_out = 0.5;

/// How many dB softer the sound of the motion is than alone, if there is other sound.
constexpr int motion_softness = 12;

std::int64_t sample_at(double time) { return std::llround(time * sample_rate); }

/// The filters of a sound file, which convert it and move it to its start.
std::string file_filters(const PlacedSound& sound, const SoundMix& mix) {
  std::string filters = sound_conversion() + ",asetpts=PTS-STARTPTS";
  const double room = mix.film_length - sound.start;
  if (sound_length(sound.file) > room) {
    const double fade = std::min(fade_out, room / 2);
    filters += fmt::format(",afade=t=out:st={:.6f}:d={:.6f}", room - fade, fade);
  }
  return filters + fmt::format(",adelay={}S:all=1", sample_at(sound.start));
}

/// The graph of filters whose inputs are the files and then the motion, and whose output is [mix].
std::string filter_graph(const SoundMix& mix) {
  std::string graph, inputs;
  std::size_t count = 0;
  const auto add = [&](const std::string& filters) {
    graph += fmt::format("[{0}:a:0]{1},apad[s{0}];", count, filters);
    inputs += fmt::format("[s{}]", count);
    ++count;
  };
  for (const PlacedSound& sound : mix.files) add(file_filters(sound, mix));
  if (mix.motion) {
    const int softness = mix.files.empty() ? 0 : motion_softness;
    add(fmt::format("aformat=sample_fmts=fltp:channel_layouts=stereo,volume=-{}dB,adelay={}S:all=1",
                    softness, sample_at(mix.begin)));
  }
  // The sum of several sounds may exceed the full scale. An encoder adds some tenths of a dB.
  if (count > 1) {
    inputs += fmt::format(
        "amix=inputs={}:normalize=0,alimiter=limit=0.84:level=disabled:latency=enabled,", count);
  }
  return graph + inputs +
         fmt::format("atrim=start_sample={}:end_sample={},asetpts=PTS-STARTPTS[mix]",
                     sample_at(mix.begin), sample_at(mix.end));
}

Arguments command_of(const SoundMix& mix, const SoundCodec& codec, const std::string& output) {
  // Not strict (-xerror): the files were decoded before, and the end of a file that was written to
  // a pipe is no error.
  Arguments command = words_of("ffmpeg -hide_banner -loglevel error -y");
  for (const PlacedSound& sound : mix.files) {
    command =
        joined({command,
                sound_input_options(),
                {"-vn", "-sn", "-dn", "-t", fmt::format("{:.6f}", mix.film_length - sound.start),
                 "-i", "file:" + sound.file.string()}});
  }
  const Arguments motion = words_of(fmt::format("-f f32le -ar {} -ac 2 -i pipe:0", sample_rate));
  return joined({command,
                 mix.motion ? motion : Arguments{},
                 {"-filter_complex", filter_graph(mix), "-map", "[mix]", "-map_metadata", "-1"},
                 words_of(codec.options),
                 {output}});
}

}  // namespace

SoundTrack::SoundTrack(const SoundMix& mix, Container container, system::Patience patience) {
  const SoundCodec& codec = *output_format(container).sound;
  for (const PlacedSound& sound : mix.files) {
    require_sound(sound.file, mix.film_length - sound.start, patience);
  }
  const Arguments command = command_of(mix, codec, input());
  system::ChildProcess ffmpeg =
      system::start_program<EncoderError>(command, ffmpeg_remedy, patience);
  if (mix.motion) {
    mix.motion([&](std::span<const float> samples) {
      return ffmpeg.write(
          {reinterpret_cast<const std::uint8_t*>(samples.data()), samples.size_bytes()});
    });
  }
  // Ten times as long as a slow processor needs.
  const auto work = std::chrono::milliseconds(std::llround(1e3 * mix.end));
  if (const int status = ffmpeg.wait(work); status != 0) {
    throw EncoderError(
        "cannot encode the sound", system::failure_of("ffmpeg", ffmpeg, status),
        ffmpeg.timed_out()
            ? "the command was: " + system::shell_command(command)
            : fmt::format("install an ffmpeg that has {}: apt-get install ffmpeg", codec.name));
  }
}

std::string SoundTrack::input() const {
  return fmt::format("file:/dev/fd/{}", encoded_.descriptor());
}

}  // namespace twrench::video
