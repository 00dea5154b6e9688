#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "system/pending_file.h"
#include "video/encoder_arguments.h"
#include "video/video_file.h"

namespace twrench::video {

/// Returns the filters of an animated image as ffmpeg's arguments; none for other containers. Those
/// of a GIF make it in one pass, which would hold all frames in memory.
Arguments animation_filters(const VideoFormat& format);

/// The two passes in which ffmpeg makes a GIF: the first chooses its 256 colours, for which it has
/// to see all frames, and the second draws them in these colours. Between them the frames lie,
/// lossless, in a temporary file, so that memory does not grow with the length of the film.
class PalettePasses {
 public:
  /// The temporary files lie beside the output or, if that is a device, in the folder for temporary
  /// files. Throws FileError.
  explicit PalettePasses(const system::PendingFile& output);

  /// Returns ffmpeg's arguments after its input, raw frames.
  Arguments first(const VideoFormat& format) const;
  /// Returns ffmpeg's arguments before those of the codec.
  Arguments second() const;

 private:
  system::PendingFile frames_, palette_;
};

/// Returns the properties of a WebP, which not every ffprobe knows; nothing if it is none. Frames
/// that show the same are one in it, and one that shows a single picture has a duration of 0.
std::optional<VideoProperties> probe_webp(const std::filesystem::path& file);

/// Adds a comment to a GIF or a WebP, as ffmpeg does not. Throws FileError.
void append_comment(const std::filesystem::path& file, const std::string& comment);

/// Returns whether append_comment() has added that comment.
bool has_comment(const std::filesystem::path& file, const std::string& comment);

}  // namespace twrench::video
