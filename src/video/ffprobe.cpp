#include "video/ffprobe.h"

#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <system_error>

#include "system/memory_file.h"
#include "system/program.h"
#include "video/error.h"

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

}  // namespace twrench::video
