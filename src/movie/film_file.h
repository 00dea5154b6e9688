#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/child_process.h"
#include "movie/manifest.h"

namespace twrench {

/// What the file of a film says of itself.
struct FilmProperties {
  int width = 0;  ///< pixels
  int height = 0;
  std::int64_t frames = 0;
  double duration = 0.0;  ///< s
};

/// How long a slow disk takes to read or to write the file; nothing where its size is not known.
ChildProcess::Time disk_time(const std::filesystem::path& file);

/// Asks ffprobe, which counts the frames without decoding them. Nothing where it is no film.
/// Throws EncoderError when ffprobe cannot be started.
std::optional<FilmProperties> probe_film(const std::filesystem::path& file);

/// What the comment of a film says: the digest of all that decides which film it is, namely scene,
/// size, rate and the numbers of its frames. Program and machine are not among it: a film that is
/// made anew by another version is the same film.
std::string film_identity(const Manifest& film, const std::vector<int>& frames);

/// Throws OverwriteError where the file stands already, and is not empty, nor the film of that
/// identity: then it may only be replaced by one who says so.
void require_replaceable(const std::filesystem::path& file, const std::string& identity);

}  // namespace twrench
