#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "system/pending_file.h"
#include "video/codec.h"
#include "video/video_file.h"

namespace twrench::video {

/// Returns the filters of an animated image as ffmpeg's arguments; none for other containers. The
/// filters of a GIF create it in one pass, which keeps all frames in memory.
Arguments animation_filters(const VideoFormat& format);

/// The two passes in which ffmpeg makes a GIF. The first examines all frames and chooses 256
/// colours; the second draws the frames in these colours. Between the passes, the frames are in a
/// lossless temporary file, so that memory does not grow with the length of the film.
class PalettePasses {
 public:
  /// The temporary files are created beside the output or, if that is a device, in the folder for
  /// temporary files. Throws FileError.
  explicit PalettePasses(const system::PendingFile& output);

  /// Returns ffmpeg's arguments after its input, which is raw frames.
  Arguments first(const VideoFormat& format) const;
  /// Returns ffmpeg's arguments before those of the codec.
  Arguments second() const;

 private:
  system::PendingFile frames_, palette_;
};

/// Returns the properties of a WebP, which not every ffprobe can read; nothing if the file is not a
/// WebP. Consecutive equal frames count as one, and a single picture has a duration of 0.
std::optional<VideoProperties> probe_webp(const std::filesystem::path& file);

/// Adds a comment to a GIF or a WebP, which ffmpeg does not do. Throws FileError.
void append_comment(const std::filesystem::path& file, const std::string& comment);

/// Returns whether append_comment() has added that comment.
bool has_comment(const std::filesystem::path& file, const std::string& comment);

}  // namespace twrench::video
