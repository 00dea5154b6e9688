#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "system/error.h"
#include "video/codec.h"

namespace twrench::video {

/// What to do if frames of the range are missing.
enum class Missing { refuse, leave_out };

/// Where a video is written.
struct VideoOutput {
  /// "-" for standard output
  std::filesystem::path path;
  /// Container of the video.
  Container container = Container::mp4;
  /// Whether to replace an existing file that is another video or not a video.
  bool overwrite = false;
  /// Whether the flips become chapters.
  bool chapters = true;
  /// Width in pixels to which an animated image is scaled; if nothing, at most widest_animation.
  std::optional<int> width = std::nullopt;
};

/// Makes the film of the frames in a folder, of which its manifests tell: the one of a run, those
/// of shards, or both, all of the same film, with its captions and chapters. Each file is held
/// against its digest before it is used. `progress` hears how many of how many frames are done.
/// Returns the frames left out. Throws FramesError as read_manifests, when frames of the range are
/// missing and that is not allowed, or all are, or when a file is not the one that was drawn;
/// OverwriteError where the output is one of the folder's own files, or another film that must not
/// be overwritten; and as VideoEncoder does.
std::vector<int> encode_frames(const std::filesystem::path& folder, const VideoOutput& output,
                               Missing missing,
                               const std::function<void(int done, int total)>& progress);

}  // namespace twrench::video
