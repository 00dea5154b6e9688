#pragma once

#include <filesystem>
#include <functional>

namespace twrench {

/// Makes the film of the frames in a folder, of which its manifest tells. Each file is held against
/// its digest before it is used. `progress` hears how many of how many frames are done.
/// Throws FileError when the manifest is none, when frames of its range are missing (named as a
/// RANGE) or a file is not the one that was drawn; and as VideoEncoder does.
void encode_frames(const std::filesystem::path& folder, const std::filesystem::path& output,
                   const std::function<void(int done, int total)>& progress);

}  // namespace twrench
