#include "video/sound_file.h"

#include <cerrno>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "system/file.h"
#include "video/ffprobe.h"

namespace twrench::video {
namespace {

/// Rejects folders and pipes, because opening a pipe would wait for a writer.
void require_readable(const std::filesystem::path& file) {
  const std::string what = "cannot read " + file.string();
  std::error_code failed;
  const auto status = std::filesystem::status(file, failed);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw system::FileError(what, "it is not a regular file", "name a sound file");
  }
  if (!std::ifstream(file, std::ios::binary)) {
    throw system::file_error(what, errno, system::Access::read);
  }
}

/// Returns the length of a track or of a file as ffprobe found it; 0 if it found none.
double stated_length(const nlohmann::json& properties) {
  const double of_track = ffprobe_number(properties.at("streams").at(0), "duration");
  return of_track > 0 ? of_track : ffprobe_number(properties.at("format"), "duration");
}

}  // namespace

double sound_length(const std::filesystem::path& file) {
  require_readable(file);
  const auto properties =
      ffprobe(file, {"-select_streams", "a:0", "-show_entries", "stream=duration:format=duration"});
  const std::string what = "cannot use " + file.string();
  if (!properties) {
    throw system::FileError(what, "it is not a sound file that ffmpeg reads",
                            "convert it to WAV, FLAC, MP3, AAC or Opus");
  }
  if (properties->value("streams", nlohmann::json::array()).empty()) {
    throw system::FileError(what, "it has no sound", "name a file with a sound track");
  }
  const double length = stated_length(*properties);
  return length > 0 ? length : std::numeric_limits<double>::infinity();
}

}  // namespace twrench::video
