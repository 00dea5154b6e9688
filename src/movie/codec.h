#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace twrench {

enum class Container { mp4, mov, matroska, webm };

/// By its name, which is also a file's ending: mp4, mov, mkv or webm, in any case. Throws
/// UsageError for others.
Container container_named(std::string_view name);

/// By the file's ending. Throws UsageError where there is none, or one of no container.
Container container_of(const std::filesystem::path& file);

/// Whether a film in that container is made so that it keeps alpha: WebM (VP9) and MOV (ProRes
/// 4444). The others show what is transparent over black.
bool keeps_alpha(Container container);

/// The colours of every film, as ffmpeg's options say them: ITU-R BT.709, limited range.
inline constexpr const char* bt709_tags =
    "-color_primaries bt709 -color_trc bt709 -colorspace bt709 -color_range tv";

/// What follows the input in ffmpeg's arguments: codec and container. Opaque, H.264 or (WebM) VP9
/// in yuv420p; with alpha, which the container must keep, VP9 in yuva420p or ProRes 4444. A film
/// that is `streamed` is written from front to back, in fragments: a pipe cannot be gone back in.
std::string codec_arguments(Container container, bool alpha, bool streamed);

}  // namespace twrench
