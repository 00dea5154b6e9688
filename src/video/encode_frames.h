#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "system/error.h"
#include "video/codec.h"

namespace twrench::video {

/// How to treat missing frames of the range.
enum class MissingFrames { refuse, leave_out };

/// The destination and the options of a video.
struct VideoOutput {
  /// A file, or "-" for standard output.
  std::filesystem::path path;
  /// Container of the video.
  Container container = Container::mp4;
  /// Whether to replace an existing file that is another video or not a video.
  bool overwrite = false;
  /// Whether the flips become chapters.
  bool chapters = true;
  /// Width in pixels to which an animated image is scaled; if not given, at most widest_animation.
  std::optional<int> width = std::nullopt;
  /// Effort and quality of the encoder.
  Quality quality = {};
  /// A sound file under the video; empty for none.
  std::filesystem::path audio = {};
  /// Whether to leave out the sound of the scene, which the frames do not contain.
  bool leave_sound_out = false;
};

/// Encodes the frames in a folder as listed in its manifests: the one of a run, those of shards, or
/// both, all of the same film. Adds captions and chapters. Verifies the digest of each file before
/// using it. `progress` receives the numbers of encoded frames and of all frames. Returns the
/// frames left out. Throws FramesError as read_manifests() does, if frames of the range are missing
/// and that is not allowed, if all are missing, or if a file differs from the frame that was drawn;
/// InvalidArgument if the scene has sound that is neither replaced nor left out, or the container
/// has none; as sound_length() and SoundTrack do;
/// OverwriteError if the output is a file of the folder, or another film that must not be
/// overwritten; and as VideoEncoder does.
std::vector<int> encode_frames(const std::filesystem::path& folder, const VideoOutput& output,
                               MissingFrames missing,
                               const std::function<void(int done, int total)>& progress);

}  // namespace twrench::video
