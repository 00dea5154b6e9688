#include "video/sound_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/letters.h"
#include "system/program.h"
#include "video/encoder_arguments.h"
#include "video/error.h"
#include "video/sound_file.h"

namespace twrench::video {
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
