#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "movie/codec.h"

namespace twrench {

/// What to do if frames of the range are missing.
enum class Missing { refuse, leave_out };

/// Where a video is written.
struct FilmOutput {
  /// "-" for standard output
  std::filesystem::path path;
  /// Container of the video.
  Container container = Container::mp4;
  /// Whether to replace an existing file that is another video or not a video.
  bool overwrite = false;
};

/// Encodes the frames in a folder according to its manifests: that of a whole run, those of shards,
/// or both, all of the same video. The digest of each file is verified before it is used.
/// `progress` is called with the numbers of finished and of all frames. Returns the frames omitted.
/// Throws FileError as read_manifests() does, if frames of the range are missing (listed as a
/// RANGE) and that is not allowed, if all are missing, or if a file is not the one that was drawn;
/// UsageError if the output is one of the folder's own files or another video that must not be
/// replaced; and as VideoEncoder does.
std::vector<int> encode_frames(const std::filesystem::path& folder, const FilmOutput& output,
                               Missing missing,
                               const std::function<void(int done, int total)>& progress);

}  // namespace twrench
