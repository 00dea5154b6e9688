#include "video/video_file.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "system/error.h"
#include "system/memory_file.h"
#include "system/program.h"
#include "system/sha256.h"
#include "video/animated_image.h"
#include "video/error.h"
#include "video/frame_range.h"

namespace twrench::video {
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
  std::vector<std::string> command{"ffprobe", "-v", "error", "-select_streams", "v:0"};
  command.insert(command.end(), how.begin(), how.end());
  constexpr const char* entries =
      "stream=width,height,nb_read_packets:format=duration:format_tags=comment";
  command.insert(command.end(), {"-show_entries", entries, "-of", "json", "file:" + file.string()});
  const system::MemoryFile output("");
  auto ffprobe = system::start_program<EncoderError>(command, "install it: apt-get install ffmpeg",
                                                     {}, output.descriptor());
  if (ffprobe.wait(disk_time(file)) != 0) return std::nullopt;
  try {
    return read(nlohmann::json::parse(output.contents()));
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

/// ffprobe writes numbers as strings.
double number(const nlohmann::json& object, const char* key) {
  return object.contains(key) ? std::strtod(object[key].get<std::string>().c_str(), nullptr) : 0.0;
}

}  // namespace

system::ChildProcess::Time disk_time(const fs::path& file) {
  constexpr std::uintmax_t slow_disk = 10'000;  // bytes per millisecond
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(file, unknown);
  return system::ChildProcess::Time(unknown ? 0 : size / slow_disk);
}

std::optional<VideoProperties> probe_video(const fs::path& file) {
  if (const auto webp = probe_webp(file)) return webp;
  return run_ffprobe(file, {"-count_packets"}, [](const nlohmann::json& said) {
    const nlohmann::json& stream = said.at("streams").at(0);
    return VideoProperties{stream.at("width").get<int>(), stream.at("height").get<int>(),
                           std::llround(number(stream, "nb_read_packets")),
                           number(said.at("format"), "duration")};
  });
}

std::string video_identity(const Manifest& film, const std::vector<int>& frames) {
  const nlohmann::json all{film.scene, film.width, film.height, film.fps,
                           format_frame_range(frames)};
  const std::string text = all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return any_identity + system::sha256_hex(std::span(
                            reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void require_replaceable(const fs::path& file, const std::string& identity) {
  std::error_code failed;
  const bool stands = fs::is_regular_file(file, failed) && fs::file_size(file, failed) > 0;
  if (!stands || has_comment(file, identity)) return;
  const auto comment =
      probe_webp(file) ? std::optional<std::string>("") : run_ffprobe(file, {}, &comment_of);
  if (comment == identity) return;
  throw system::OverwriteError(file.string(), comment ? "it exists and is a different video"
                                                      : "it exists and is not a video");
}

}  // namespace twrench::video
