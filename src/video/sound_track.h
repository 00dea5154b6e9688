#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "system/child_process.h"
#include "system/descriptor.h"
#include "video/codec.h"

namespace twrench::video {

/// Returns ffmpeg's and ffprobe's options for a user's sound file. Only containers of sound are
/// opened: a list of files or a description of a session would open other files and addresses.
Arguments sound_input_options();

/// Returns ffmpeg's filters that convert any sound to that of a film: 48 kHz, stereo.
std::string sound_conversion();

/// Returns the length in s of the first sound track of a file; infinity if the file does not state
/// it. Throws FileError if the file cannot be read, is not a regular file, or has no sound, and
/// EncoderError if ffprobe is missing.
double sound_length(const std::filesystem::path& file);

/// Decodes the first `length` s of the first sound track. Throws FileError as sound_length() does,
/// and if the track is damaged, has a format that cannot be converted, has no samples, or has
/// samples that are not numbers or far beyond the full scale; EncoderError if ffmpeg is missing or
/// hangs.
void require_sound(const std::filesystem::path& file, double length, system::Patience patience);

/// A sound file in a film.
struct PlacedSound {
  std::filesystem::path file;
  /// Time in s of film at which it starts.
  double start = 0.0;
};

/// The parts of a film's sound, which are mixed. Times are in s of film.
struct SoundMix {
  /// They keep their loudness.
  std::vector<PlacedSound> files;
  /// Passes the samples of the sound of the motion from `begin` to `end` to its argument, which
  /// returns false if it takes no more: 48 kHz, left and right alternating. Empty for none. With
  /// `files` it is 12 dB softer.
  std::function<void(const std::function<bool(std::span<const float>)>&)> motion = {};
  /// The part of the film that the video shows.
  double begin = 0.0, end = 0.0;
  /// Length of the film. Files that are longer fade out before it.
  double film_length = 0.0;
};

/// The sound of a video, mixed and encoded for its container.
class SoundTrack {
 public:
  /// Mixes and encodes the sound. The container must be one of a video. Throws EncoderError if
  /// ffmpeg is missing, lacks the encoder or fails; FileError if a file has no sound.
  SoundTrack(const SoundMix& mix, Container container, system::Patience patience = {});

  /// Returns ffmpeg's name of the encoded sound, which child processes can read.
  std::string input() const;

 private:
  system::MemoryFile encoded_{""};
};

}  // namespace twrench::video
