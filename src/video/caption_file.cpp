#include "video/caption_file.h"

#include <fmt/format.h>

#include <cmath>
#include <system_error>

#include "system/error.h"
#include "system/file.h"

namespace twrench::video {
namespace {

namespace fs = std::filesystem;

std::string timestamp(double seconds) {
  const std::int64_t ms = std::llround(seconds * 1000);
  return fmt::format("{:02}:{:02}:{:02}.{:03}", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60,
                     ms % 1000);
}

/// The text on one line, without characters that mean something in WebVTT.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else {
      result += c == '\n' || c == '\r' ? ' ' : c;
    }
  }
  return result;
}

std::string note_of(const std::string& identity) { return "NOTE " + identity + "\n"; }

/// Returns the path if nothing would be lost by writing there.
const fs::path& replaceable(const fs::path& path, const std::string& identity) {
  std::error_code failed;
  if (!fs::is_regular_file(path, failed) || fs::file_size(path, failed) == 0) return path;
  constexpr std::size_t longest = 1 << 24;
  const std::vector<std::uint8_t> bytes = system::read_regular_file(path, longest);
  const std::string text(bytes.begin(), bytes.end());
  if (text.find(note_of(identity)) != std::string::npos) return path;
  throw system::OverwriteError(path.string(), "it exists and has captions of something else");
}

}  // namespace

std::string web_vtt(const std::vector<Cue>& cues, const std::string& identity) {
  std::string text = "WEBVTT\n\n" + note_of(identity);
  for (const auto& [begin, end, words] : cues) {
    text += fmt::format("\n{} --> {}\n{}\n", timestamp(begin), timestamp(end), escaped(words));
  }
  return text;
}

CaptionFile::CaptionFile(const fs::path& video, const std::vector<Cue>& cues,
                         const std::string& identity, bool overwrite)
    : file_([&] {
        const fs::path path = fs::path(video).replace_extension(".vtt");
        return overwrite ? path : replaceable(path, identity);
      }()) {
  const std::string text = web_vtt(cues, identity);
  file_.write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace twrench::video
