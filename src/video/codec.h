#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace twrench::video {

enum class Container { mp4, mov, matroska, webm };

/// Returns the container of that name, which is also the file extension: mp4, mov, mkv or webm, in
/// upper or lower case. Throws InvalidArgument for others.
Container container_named(std::string_view name);

/// Returns the container for the file's extension. Throws InvalidArgument if it has none or an
/// unknown one.
Container container_of(const std::filesystem::path& file);

/// Returns whether videos in that container keep alpha: WebM (VP9) and MOV (ProRes 4444). The
/// others are composited over black.
bool keeps_alpha(Container container);

/// The colour tags of every video as ffmpeg options: ITU-R BT.709, limited range.
inline constexpr const char* bt709_tags =
    "-color_primaries bt709 -color_trc bt709 -colorspace bt709 -color_range tv";

/// Returns ffmpeg's arguments after the input: codec and container. Opaque video is H.264 or (WebM)
/// VP9 in yuv420p; video with alpha, which the container must keep, is VP9 in yuva420p or ProRes
/// 4444. A `streamed` video is fragmented and written from front to back, because a pipe is not
/// seekable.
std::string codec_arguments(Container container, bool alpha, bool streamed);

}  // namespace twrench::video
