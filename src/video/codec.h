#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace twrench::video {

/// The file formats of videos; the last two are animated images, which play without a player.
enum class Container { mp4, mov, matroska, webm, gif, webp };

/// Returns the container of that name, which is also the file extension: mp4, mov, mkv, webm, gif
/// or webp, in upper or lower case. Throws InvalidArgument for others.
Container container_named(std::string_view name);

/// Returns that name in lower case.
std::string_view name_of(Container container);

/// Returns the container for the file's extension. Throws InvalidArgument if it has none or an
/// unknown one.
Container container_of(const std::filesystem::path& file);

/// Returns whether it is a GIF or an animated WebP: any size, no chapters, repeated for ever.
bool is_animated_image(Container container);

/// The width in pixels of an animated image, unless another is asked for or its frames are smaller.
constexpr int widest_animation = 640;

/// Returns whether videos in that container keep alpha: WebM (VP9), MOV (ProRes 4444), WebP, and
/// GIF, whose pixels are either opaque or transparent.
bool keeps_alpha(Container container);

/// The size, rate and container of a video.
struct VideoFormat {
  /// Width of the frames in pixels; even, but for an animated image.
  int width = 0;
  /// Height of the frames in pixels, likewise.
  int height = 0;
  /// Frames per second.
  double fps = 0.0;
  /// Container of the video.
  Container container = Container::mp4;
  /// Whether frames are RGBA; only for a container that keeps their alpha.
  bool transparent = false;
  /// Whether the output is a pipe or another file that is not seekable.
  bool streamed = false;
  /// Width in pixels to which an animated image is scaled; 0 leaves it as it is.
  int scaled_width = 0;

  /// Returns whether the frames go to ffmpeg as RGB or RGBA, not as Y'CbCr.
  bool is_rgb() const { return transparent || is_animated_image(container); }

  /// Returns the width of the video in pixels.
  int shown_width() const { return scaled_width > 0 ? scaled_width : width; }
  /// Returns its height in pixels.
  int shown_height() const;

  /// Returns of how many frames the video keeps one. Browsers slow down a GIF that shows a frame
  /// for less than 0.02 s, and a WebP for less than 0.011 s: of too fast a film they have every
  /// second frame, or every third, at evenly spaced times. Other containers keep all.
  int frame_step() const;
};

/// The colour tags of every video as ffmpeg options: ITU-R BT.709, limited range.
inline constexpr const char* bt709_tags =
    "-color_primaries bt709 -color_trc bt709 -colorspace bt709 -color_range tv";

/// Returns ffmpeg's arguments after the input: codec and container. Opaque video is H.264 or (WebM)
/// VP9 in yuv420p; video with alpha, which the container must keep, is VP9 in yuva420p or ProRes
/// 4444. Animated images are drawn in a palette (GIF) or lossy (WebP). A `streamed` video is
/// fragmented and written from front to back, because a pipe is not seekable.
std::string codec_arguments(Container container, bool alpha, bool streamed);

}  // namespace twrench::video
