#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::video {

/// The file formats of videos; output_formats() describes them.
enum class Container { mp4, mov, matroska, webm, gif, webp };

/// How much processor time a codec may take to make the video small. The quality is the same.
enum class Effort { fast, balanced, small };

/// The settings of a codec for an effort.
struct EffortSettings {
  Effort effort;
  /// Options of ffmpeg.
  const char* options;
  /// The default of Quality::crf.
  int crf;
};

/// The requested effort and quality of a video; the codec has defaults for both.
struct Quality {
  std::optional<Effort> effort = std::nullopt;
  /// The quality on the codec's own scale: 0 is the best, and larger numbers give smaller files.
  std::optional<int> crf = std::nullopt;

  bool operator==(const Quality&) const = default;
};

/// An encoder of ffmpeg.
struct Codec {
  /// ffmpeg's name.
  const char* name;
  /// Its options that do not depend on the effort.
  const char* options;
  /// A description for users.
  const char* use;
  /// One row for each effort; empty if the codec has neither efforts nor a scale of quality.
  std::span<const EffortSettings> efforts = {};
  /// The largest Quality::crf.
  int most_crf = 0;
};

/// A codec and the pixel format in which it encodes.
struct Encoding {
  const Codec* codec;
  /// ffmpeg's name of the pixel format; if empty, ffmpeg chooses it.
  const char* pixels;
};

/// An encoder of ffmpeg for sound.
struct SoundCodec {
  /// ffmpeg's name.
  const char* name;
  /// Its options, with the container for the sound alone.
  const char* options;
  /// A description for users.
  const char* use;
};

/// A file format of videos.
struct OutputFormat {
  Container container;
  /// The file extension, which is also the user's name for the container.
  const char* ending;
  /// The name in sentences.
  const char* label;
  /// ffmpeg's name.
  const char* muxer;
  /// The media type as which browsers play it.
  const char* media_type;
  /// For opaque frames.
  Encoding opaque;
  /// For frames with alpha; no codec if the format does not keep alpha.
  Encoding transparent = {};
  /// For sound; null if the format has none.
  const SoundCodec* sound = nullptr;
  /// Whether an index of the frames can precede them.
  bool has_index = false;
  /// Whether it is an animated image: it plays without a player, has any size and no chapters, and
  /// is repeated for ever.
  bool is_animated_image = false;
  /// Whether all frames share one palette.
  bool has_palette = false;
  /// The largest number of frames per second that browsers do not slow down; 0 if there is none.
  double most_fps = 0;

  bool is_video() const { return !is_animated_image; }
  /// Returns whether the format keeps alpha. The pixels of a GIF are either opaque or transparent.
  bool keeps_alpha() const { return transparent.codec != nullptr; }
  /// Returns how frames with or without alpha are encoded.
  const Encoding& encoding(bool alpha) const { return alpha ? transparent : opaque; }
  /// Returns whether the effort and the quality of frames with or without alpha can be chosen.
  bool has_quality(bool alpha) const {
    const Codec* const codec = encoding(alpha).codec;
    return codec != nullptr && !codec->efforts.empty();
  }
  /// Returns the file extension with its dot.
  std::string extension() const { return std::string(".") + ending; }
};

/// Returns all formats, in the order of Container.
std::span<const OutputFormat> output_formats();

/// Returns the format of a container.
const OutputFormat& output_format(Container container);

/// Returns `text` of each format that satisfies `condition`; both are members of OutputFormat or
/// functions that take one.
template <typename Text, typename Condition>
std::vector<std::string> format_texts(Text text, Condition condition) {
  std::vector<std::string> texts;
  for (const OutputFormat& format : output_formats()) {
    if (std::invoke(condition, format)) texts.emplace_back(std::invoke(text, format));
  }
  return texts;
}

/// Returns a text of each format.
template <typename Text>
std::vector<std::string> format_texts(Text text) {
  return format_texts(text, [](const OutputFormat&) { return true; });
}

/// Returns "a, b or c". `conjunction` is "or" or "and". Requires at least two texts.
std::string listed(const std::vector<std::string>& texts, std::string_view conjunction);

/// Returns the container with that name, which is its file extension, in upper or lower case.
/// Throws InvalidArgument for unknown names.
Container container_named(std::string_view name);

/// Returns the container for the file's extension. Throws InvalidArgument if it has none or an
/// unknown one.
Container container_of(const std::filesystem::path& file);

/// Returns whether it is an animated image.
bool is_animated_image(Container container);

/// The width in pixels of an animated image, unless another is requested or its frames are
/// narrower.
constexpr int widest_animation = 640;

/// The size, rate and container of a video.
struct VideoFormat {
  /// Width of the frames in pixels; even, except for an animated image.
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
  /// Effort and quality of the encoder.
  Quality quality = {};

  /// Returns whether ffmpeg receives the frames as RGB or RGBA instead of Y'CbCr.
  bool is_rgb() const { return transparent || is_animated_image(container); }

  /// Returns the width of the video in pixels.
  int shown_width() const { return scaled_width > 0 ? scaled_width : width; }
  /// Returns its height in pixels.
  int shown_height() const;

  /// Returns n if the video keeps every nth frame. It is 2 or more if the film is faster than
  /// OutputFormat::most_fps, otherwise 1. The kept frames are evenly spaced in time.
  int frame_step() const;
};

/// The colour tags of every video as ffmpeg options: ITU-R BT.709, limited range.
inline constexpr const char* bt709_tags =
    "-color_primaries bt709 -color_trc bt709 -colorspace bt709 -color_range tv";

/// Returns the requested effort and quality, or the codec's defaults; neither if the codec has
/// none. If the frames have alpha, the container must keep it. Throws InvalidArgument if they are
/// requested of a codec that has none, and OutOfRange if the quality is outside its scale.
Quality chosen_quality(const VideoFormat& format);

/// Returns ffmpeg's arguments after the input: codec and container. A `streamed` video is
/// fragmented and written from front to back, because a pipe is not seekable. Throws as
/// chosen_quality().
std::string codec_arguments(const VideoFormat& format);

/// Arguments of ffmpeg.
using Arguments = std::vector<std::string>;

/// Options that make ffmpeg print only errors, stop at the first one, and never prompt.
inline constexpr const char* quiet_options = "-hide_banner -loglevel error -xerror -y";

/// Returns the arguments of several groups, in order.
Arguments joined(std::initializer_list<Arguments> groups);

/// Returns the arguments up to the input, which is raw frames on standard input: RGB or RGBA if
/// VideoFormat::is_rgb(), otherwise planes as Yuv420::bytes() provides them. Throws FilmSizeError
/// for odd sizes, which yuv420p does not allow, OutOfRange for an invalid rate, and InvalidArgument
/// for transparent frames in a container that does not keep their alpha.
Arguments input_arguments(const VideoFormat& format);

/// Returns the arguments between the input and the output file: filters, codec and container,
/// tagged BT.709. Throws as chosen_quality().
Arguments output_arguments(const VideoFormat& format);

/// Returns both. For an animated image with a palette, these arguments would keep all frames in
/// memory; use PalettePasses instead.
Arguments encoder_arguments(const VideoFormat& format);

}  // namespace twrench::video
