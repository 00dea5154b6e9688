#pragma once

#include <filesystem>

namespace twrench::video {

/// Returns the length in s of the first sound track of a file; infinity if the file does not state
/// it. Throws FileError if the file cannot be read, is not a regular file, or has no sound, and
/// EncoderError if ffprobe is missing.
double sound_length(const std::filesystem::path& file);

}  // namespace twrench::video
