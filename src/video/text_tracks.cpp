#include "video/text_tracks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <utility>

#include "system/error.h"
#include "text/escape.h"
#include "video/video_file.h"

namespace twrench::video {
namespace {

namespace fs = std::filesystem;

std::string timestamp(double seconds) {
  const std::int64_t ms = std::llround(seconds * 1000);
  return fmt::format("{:02}:{:02}:{:02}.{:03}", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60,
                     ms % 1000);
}

/// The text on one line, with references for the characters that have a meaning in WebVTT.
std::string escaped(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text::with_references(text, "&<>");
}

constexpr const char* note = "NOTE ";

/// The beginning of a file, which contains its note; empty if there is no file.
std::string head_of(const fs::path& path) {
  std::string head(256, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

bool is_nonempty_file(const fs::path& path) {
  std::error_code failed;
  return fs::is_regular_file(path, failed) && fs::file_size(path, failed) > 0;
}

/// Returns whether `text` is the beginning of a track of the video with that identity, or with one
/// that begins with it.
bool is_track_of(const std::string& text, const std::string& identity) {
  return text.find(note + identity) != std::string::npos;
}

}  // namespace

std::vector<Cue> cues_of(std::size_t frames, double fps,
                         const std::function<std::string(std::size_t)>& text_of) {
  std::vector<Cue> cues;
  for (std::size_t i = 0; i < frames; ++i) {
    std::string text = text_of(i);
    const double begin = static_cast<double>(i) / fps;
    if (cues.empty() || cues.back().text != text) cues.push_back({begin, begin, std::move(text)});
    cues.back().end = static_cast<double>(i + 1) / fps;
  }
  std::erase_if(cues, [](const Cue& cue) { return cue.text.empty(); });
  return cues;
}

std::vector<Cue> chapters_of(std::size_t frames, double fps,
                             const std::function<std::string(std::size_t)>& title_of) {
  std::vector<Cue> chapters = cues_of(frames, fps, title_of);
  if (chapters.size() == 1) chapters.clear();
  return chapters;
}

std::string chapter_title(int flips, double last_flip) {
  if (flips == 0) return "start";
  return last_flip < 10 ? fmt::format("flip {} at {:.3g} s", flips, last_flip)
                        : fmt::format("flip {} at {:.1f} s", flips, last_flip);
}

std::string web_vtt(const std::vector<Cue>& cues, const std::string& identity) {
  std::string text = "WEBVTT\n\n" + (note + identity) + "\n";
  for (const auto& [begin, end, words] : cues) {
    text += fmt::format("\n{} --> {}\n{}\n", timestamp(begin), timestamp(end), escaped(words));
  }
  return text;
}

std::string chapter_metadata(const std::vector<Cue>& chapters) {
  const auto ms = [](double seconds) {
    constexpr double round_off = 1e-6;
    return static_cast<std::int64_t>(std::ceil(seconds * 1000 - round_off));
  };
  std::string text = ";FFMETADATA1\n";
  for (const auto& [begin, end, title] : chapters) {
    text += fmt::format("[CHAPTER]\nTIMEBASE=1/1000\nSTART={}\nEND={}\ntitle={}\n", ms(begin),
                        ms(end), title);
  }
  return text;
}

std::vector<fs::path> text_track_files(const fs::path& video, Container container) {
  std::error_code failed;
  const bool is_device = fs::exists(video, failed) && !fs::is_regular_file(video, failed);
  if (video == "-" || is_device || is_animated_image(container)) return {};
  return {fs::path(video).replace_extension(".vtt"),
          fs::path(video).replace_extension(".chapters.vtt")};
}

TextTrackFiles::TextTrackFiles(const fs::path& video, Container container, const TextTracks& tracks,
                               const std::vector<std::string>& identities, bool overwrite) {
  const std::array all{&tracks.captions, &tracks.chapters};  // in the order of the files
  const std::vector<fs::path> paths = text_track_files(video, container);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const std::vector<Cue>* const cues = all.at(i);
    const fs::path& path = paths[i];
    const std::string before = is_nonempty_file(path) ? head_of(path) : "";
    const bool is_own = std::ranges::any_of(
        identities, [&](const std::string& identity) { return is_track_of(before, identity); });
    if (cues->empty()) {
      if (is_own || (overwrite && is_track_of(before, any_identity))) outdated_.push_back(path);
      continue;
    }
    if (is_nonempty_file(path) && !is_own && !overwrite) {
      throw system::ExistingFileError(path.string(),
                                      "it exists and is a text track of another video");
    }
    const std::string text = web_vtt(*cues, identities.front());
    files_.emplace_back(path).write(
        {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }
}

void TextTrackFiles::finish() {
  for (system::PendingFile& file : files_) file.commit();
  for (const fs::path& path : outdated_) {
    std::error_code gone;
    fs::remove(path, gone);
  }
}

}  // namespace twrench::video
