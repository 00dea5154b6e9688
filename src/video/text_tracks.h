#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "system/pending_file.h"

namespace twrench::video {

/// A text and when it holds, in s of video.
struct Cue {
  double begin;
  double end;
  std::string text;
};

/// Returns the cues of a video whose frame i shows `text_of(i)`: one for every run of frames with
/// the same text, and none where it is empty. Frames are shown `fps` a second.
std::vector<Cue> cues_of(std::size_t frames, double fps,
                         const std::function<std::string(std::size_t)>& text_of);

/// The texts that go with a video.
struct TextTracks {
  /// What is said in the picture.
  std::vector<Cue> captions;
  /// Parts of the video that a player offers to jump to: without gaps from its start to its end,
  /// or none.
  std::vector<Cue> chapters;
};

/// Returns the chapters of a video whose frame i belongs to the one with the title `title_of(i)`:
/// none where they would all be one.
std::vector<Cue> chapters_of(std::size_t frames, double fps,
                             const std::function<std::string(std::size_t)>& title_of);

/// Returns the title of a chapter that shows a motion after `flips` flips, the last of them
/// `last_flip` s after its start: "flip 2 at 35.4 s".
std::string chapter_title(int flips, double last_flip);

/// Returns the cues as WebVTT, with `identity` as a note.
std::string web_vtt(const std::vector<Cue>& cues, const std::string& identity);

/// Returns the chapters as ffmpeg reads them, in its format ffmetadata. Times are rounded up to
/// milliseconds, so that the frame shown at that time is the chapter's first and not the one
/// before.
std::string chapter_metadata(const std::vector<Cue>& chapters);

/// The text tracks of a video as WebVTT in files beside it: F.vtt for the captions, where players
/// look for them, and F.chapters.vtt for the chapters. For an empty track none is written, and the
/// one of the video before is removed; beside a video that is no file there are none. All that
/// happens when finish() is called, or not at all.
class TextTrackFiles {
 public:
  /// `identity` is the video's. Throws OverwriteError where a file stands already and is not of
  /// the same video, unless it may `overwrite` it, and FileError.
  TextTrackFiles(const std::filesystem::path& video, const TextTracks& tracks,
                 const std::string& identity, bool overwrite);

  /// Throws FileError.
  void finish();

 private:
  std::deque<system::PendingFile> files_;
  std::vector<std::filesystem::path> outdated_;  ///< To be removed.
};

}  // namespace twrench::video
