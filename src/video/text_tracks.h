#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "system/pending_file.h"
#include "video/codec.h"

namespace twrench::video {

/// A text and the time when it is shown, in s of video.
struct Cue {
  double begin;
  double end;
  std::string text;
};

/// Returns the cues of a video whose frame i shows `text_of(i)`: one for each run of frames with
/// the same text, and none for an empty text. `fps` is the number of frames per second.
std::vector<Cue> cues_of(std::size_t frames, double fps,
                         const std::function<std::string(std::size_t)>& text_of);

/// The text tracks of a video.
struct TextTracks {
  /// The captions shown in the picture.
  std::vector<Cue> captions;
  /// Parts of the video that a player offers to jump to. They cover the video without gaps, or
  /// there are none.
  std::vector<Cue> chapters;
};

/// Returns the chapters of a video whose frame i belongs to the chapter with the title
/// `title_of(i)`; none if there would be only one.
std::vector<Cue> chapters_of(std::size_t frames, double fps,
                             const std::function<std::string(std::size_t)>& title_of);

/// Returns the title of a chapter that shows a motion after `flips` flips, the last of them
/// `last_flip` s after its start: "flip 2 at 35.4 s".
std::string chapter_title(int flips, double last_flip);

/// Returns the cues as WebVTT, with `identity` as a note.
std::string web_vtt(const std::vector<Cue>& cues, const std::string& identity);

/// Returns the chapters in ffmpeg's format ffmetadata. Times are rounded up to milliseconds, so
/// that the frame shown at that time is the chapter's first and not the one before.
std::string chapter_metadata(const std::vector<Cue>& chapters);

/// Returns the files of a video's text tracks: F.vtt for the captions, where players look for them,
/// and F.chapters.vtt for the chapters. A video that is not a file, and an animated image, have
/// none.
std::vector<std::filesystem::path> text_track_files(const std::filesystem::path& video,
                                                    Container container);

/// The text tracks of a video as WebVTT files. For an empty track no file is written, and an
/// earlier one of the same video is removed; with `overwrite`, also one of another video. Nothing
/// is written or removed before finish().
class TextTrackFiles {
 public:
  /// The first of the `identities` is that of the video, and files with the others may be replaced,
  /// too. Throws OverwriteError if a file exists and belongs to another video, unless `overwrite`
  /// is set, and FileError.
  TextTrackFiles(const std::filesystem::path& video, Container container, const TextTracks& tracks,
                 const std::vector<std::string>& identities, bool overwrite);

  /// Throws FileError.
  void finish();

 private:
  std::deque<system::PendingFile> files_;
  std::vector<std::filesystem::path> outdated_;  ///< Removed by finish().
};

}  // namespace twrench::video
