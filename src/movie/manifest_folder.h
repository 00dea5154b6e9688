#pragma once

#include <filesystem>
#include <vector>

#include "movie/manifest.h"

namespace twrench {

/// The manifests in a folder of frames, the whole's and the shards', by name. None where the folder
/// cannot be read.
std::vector<std::filesystem::path> manifests_in(const std::filesystem::path& folder);

/// All manifests of the folder as one, its range all that was asked for. Throws FileError when
/// there is none, one is none, or they disagree: on the film, or on the digest of a frame.
Manifest read_manifests(const std::filesystem::path& folder);

}  // namespace twrench
