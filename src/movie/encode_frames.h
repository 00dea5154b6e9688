#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace twrench {

/// What to do where frames of the range are missing.
enum class Missing { refuse, leave_out };

/// Makes the film of the frames in a folder, of which its manifests tell: the one of a run, those
/// of shards, or both, all of the same film. Each file is held against its digest before it is
/// used. `progress` hears how many of how many frames are done. Returns the frames left out.
/// Throws FileError as read_manifests, when frames of the range are missing (named as a RANGE) and
/// that is not allowed, or all are, or when a file is not the one that was drawn; and as
/// VideoEncoder does.
std::vector<int> encode_frames(const std::filesystem::path& folder,
                               const std::filesystem::path& output, Missing missing,
                               const std::function<void(int done, int total)>& progress);

}  // namespace twrench
