#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "system/child_process.h"

namespace twrench::video {

/// Returns how long a slow disk takes to read or write the file; zero if its size is unknown.
system::ChildProcess::Time disk_time(const std::filesystem::path& file);

/// Returns what ffprobe finds in the file; nothing if it does not recognise it. `options` select
/// the properties. Throws EncoderError if ffprobe is missing or hangs.
std::optional<nlohmann::json> ffprobe(const std::filesystem::path& file,
                                      const std::vector<std::string>& options);

/// Returns a number of an object, which ffprobe writes as a string; 0 if it is absent.
double ffprobe_number(const nlohmann::json& object, const char* key);

}  // namespace twrench::video
