#include "video/video_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "system/bytes.h"
#include "system/descriptor.h"
#include "system/program.h"
#include "video/animated_image.h"
#include "video/error.h"
#include "video/frame_range.h"

namespace twrench::video {

system::ChildProcess::Time disk_time(const std::filesystem::path& file) {
  constexpr std::uintmax_t slow_disk = 10'000;  // bytes per millisecond
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  return system::ChildProcess::Time(unknown ? 0 : size / slow_disk);
}

std::optional<nlohmann::json> ffprobe(const std::filesystem::path& file,
                                      const std::vector<std::string>& options) {
  std::vector<std::string> command{"ffprobe", "-v", "error"};
  command.insert(command.end(), options.begin(), options.end());
  command.insert(command.end(), {"-of", "json", "file:" + file.string()});
  const system::MemoryFile output("");
  auto child = system::start_program<EncoderError>(command, ffmpeg_remedy, {}, output.descriptor());
  const int status = child.wait(disk_time(file));
  if (child.timed_out()) {
    throw EncoderError("cannot examine " + file.string(),
                       system::failure_of("ffprobe", child, status),
                       "the command was: " + system::shell_command(command));
  }
  if (status != 0) return std::nullopt;
  try {
    return nlohmann::json::parse(output.contents());
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

double ffprobe_number(const nlohmann::json& object, const char* key) {
  return object.contains(key) ? std::strtod(object[key].get<std::string>().c_str(), nullptr) : 0.0;
}

namespace {

namespace fs = std::filesystem;

/// Matroska has its tags in capital letters.
std::string comment_of(const nlohmann::json& said) {
  const nlohmann::json& format = said.at("format");
  if (!format.contains("tags")) return {};
  for (const auto& [key, value] : format["tags"].items()) {
    if (key == "comment" || key == "COMMENT") return value.get<std::string>();
  }
  return {};
}

/// Returns ffprobe's properties of the video as read by `read`; nothing if it is not a video.
template <typename Read>
auto run_ffprobe(const fs::path& file, const std::vector<std::string>& how, Read&& read)
    -> std::optional<decltype(read(nlohmann::json()))> {
  std::vector<std::string> options{"-select_streams", "v:0", "-show_entries",
                                   "stream=width,height,nb_read_packets:format=duration:"
                                   "format_tags=comment"};
  options.insert(options.end(), how.begin(), how.end());
  const std::optional<nlohmann::json> properties = ffprobe(file, options);
  if (!properties) return std::nullopt;
  try {
    return read(*properties);
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<VideoProperties> probe_video(const fs::path& file) {
  if (const auto webp = probe_webp(file)) return webp;
  return run_ffprobe(file, {"-count_packets"}, [](const nlohmann::json& said) {
    const nlohmann::json& stream = said.at("streams").at(0);
    return VideoProperties{stream.at("width").get<int>(), stream.at("height").get<int>(),
                           std::llround(ffprobe_number(stream, "nb_read_packets")),
                           ffprobe_number(said.at("format"), "duration")};
  });
}

std::string video_identity(const Manifest& film, const std::vector<int>& frames) {
  const nlohmann::json all{film.scene, film.width, film.height, film.fps,
                           format_frame_range(frames)};
  const std::string text = all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return any_identity + system::sha256_hex(std::span(
                            reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::string silent_video_identity(Manifest film, const std::vector<int>& frames) {
  film.scene = without_sound(std::move(film.scene));
  return video_identity(film, frames);
}

void require_replaceable(const fs::path& file, const std::vector<std::string>& identities) {
  const auto is_own = [&](const std::string& comment) {
    return std::ranges::find(identities, comment) != identities.end();
  };
  const auto has_own_comment = [&](const std::string& identity) {
    return has_comment(file, identity);
  };
  std::error_code failed;
  const bool stands = fs::is_regular_file(file, failed) && fs::file_size(file, failed) > 0;
  if (!stands || std::ranges::any_of(identities, has_own_comment)) return;
  const auto comment =
      probe_webp(file) ? std::optional<std::string>("") : run_ffprobe(file, {}, &comment_of);
  if (comment && is_own(*comment)) return;
  throw system::ExistingFileError(file.string(), comment ? "it exists and is a different video"
                                                         : "it exists and is not a video");
}

}  // namespace twrench::video
