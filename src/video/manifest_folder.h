#pragma once

#include <filesystem>
#include <vector>

#include "system/error.h"
#include "video/manifest.h"

namespace twrench::video {

/// Returns the manifests in a folder of frames, of the whole video and of shards, sorted by name.
/// Empty if there is no such folder. Throws FileError if it cannot be read.
std::vector<std::filesystem::path> manifests_in(const std::filesystem::path& folder);

/// Returns all manifests of the folder merged into one, whose range is the union of the requested
/// ranges. Throws FileError if there is none, if one is invalid, or if they disagree on the video
/// or on the digest of a frame.
Manifest read_manifests(const std::filesystem::path& folder);

}  // namespace twrench::video
