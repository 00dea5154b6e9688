#pragma once

#include <filesystem>

#include "system/child_process.h"
#include "video/encoder_arguments.h"

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

}  // namespace twrench::video
