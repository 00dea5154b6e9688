#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "system/child_process.h"
#include "system/error.h"
#include "video/manifest.h"

namespace twrench::video {

/// Returns how long a slow disk takes to read or write the file; zero if its size is unknown.
system::ChildProcess::Time disk_time(const std::filesystem::path& file);

/// Returns what ffprobe finds in the file; nothing if it does not recognise it. `options` select
/// the properties. Throws EncoderError if ffprobe is missing or hangs.
std::optional<nlohmann::json> ffprobe(const std::filesystem::path& file,
                                      const std::vector<std::string>& options);

/// Returns a number of an object, which ffprobe writes as a string; 0 if it is absent.
double ffprobe_number(const nlohmann::json& object, const char* key);

/// The properties of a video file.
struct VideoProperties {
  /// Size in pixels.
  int width = 0;
  /// Height in pixels.
  int height = 0;
  /// Number of frames.
  std::int64_t frames = 0;
  /// Duration in s.
  double duration = 0.0;
};

/// Examines a file with ffprobe, which counts the frames without decoding them. Returns nothing if
/// it is not a video. Throws EncoderError if ffprobe cannot be started.
std::optional<VideoProperties> probe_video(const std::filesystem::path& file);

/// The beginning of a comment that identifies a video.
inline constexpr const char* any_identity = "twrench:";

/// Returns the comment that identifies a video: any_identity and the digest of everything that
/// determines its contents, namely scene, size, rate and frame numbers. Program and machine are not
/// included: the same video rendered again by another version counts as the same.
std::string video_identity(const Manifest& film, const std::vector<int>& frames);

/// Returns the identity of the same video without its sound.
std::string silent_video_identity(Manifest film, const std::vector<int>& frames);

/// Throws OverwriteError if the file exists, is not empty, and is not a video with one of these
/// identities. Such a file may be replaced only with the user's permission.
void require_replaceable(const std::filesystem::path& file,
                         const std::vector<std::string>& identities);

}  // namespace twrench::video
