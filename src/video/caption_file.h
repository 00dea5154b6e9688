#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "system/pending_file.h"

namespace twrench::video {

/// A caption and when it is seen, in s of video.
struct Cue {
  double begin;
  double end;
  std::string text;
};

/// Returns the captions as WebVTT, with `identity` as a note.
std::string web_vtt(const std::vector<Cue>& cues, const std::string& identity);

/// The captions of a video, in a file beside it with the ending .vtt that players find. It appears
/// when finish() is called, and not at all otherwise.
class CaptionFile {
 public:
  /// `identity` is the video's. Throws OverwriteError where the file stands already and is not of
  /// the same video, unless it may `overwrite` it, and FileError.
  CaptionFile(const std::filesystem::path& video, const std::vector<Cue>& cues,
              const std::string& identity, bool overwrite);

  /// Throws FileError.
  void finish() { file_.commit(); }

 private:
  system::PendingFile file_;
};

}  // namespace twrench::video
