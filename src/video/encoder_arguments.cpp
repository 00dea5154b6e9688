#include "video/encoder_arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

#include "base/words.h"
#include "video/animated_image.h"
#include "video/error.h"

namespace twrench::video {
namespace {

/// Returns fps as a fraction for ffmpeg: the nearest one of numbers up to a million, by continued
/// fractions. 60 is 60/1, 59.94 is 2997/50.
std::string rational(double fps) {
  constexpr double largest = 1e6;
  if (!(fps >= 1e-3 && fps <= 1e3)) {
    throw OutOfRange(fmt::format("fps {}", fps),
                     "a video must have 0.001 to 1000 frames per second", {fps, 1e-3, 1e3});
  }
  double p = 1, q = 0, p_before = 0, q_before = 1, rest = fps;
  while (q == 0 || p / q != fps) {
    const double whole = std::floor(rest);
    p_before = std::exchange(p, whole * p + p_before);
    q_before = std::exchange(q, whole * q + q_before);
    if (std::max(p, q) > largest) return fmt::format("{:.0f}/{:.0f}", p_before, q_before);
    rest = 1.0 / (rest - whole);
  }
  return fmt::format("{:.0f}/{:.0f}", p, q);
}

/// Converts from RGBA. ProRes takes its tags from the frames, not from the options. Without
/// accurate_rnd, the conversion darkens colours by a tenth of a level on average.
constexpr const char* conversion =
    "-vf scale=in_range=pc:out_range=tv:out_color_matrix=bt709:flags=bicubic+accurate_rnd,"
    "setparams=color_primaries=bt709:color_trc=bt709:colorspace=bt709";

const char* pixel_format(const VideoFormat& format) {
  if (format.transparent) return "rgba";
  return format.is_rgb() ? "rgb24" : "yuv420p";
}

void require_valid_size(const VideoFormat& format) {
  const int width = format.width, height = format.height;
  const bool is_even = width % 2 == 0 && height % 2 == 0;
  if (width >= 2 && height >= 2 && (is_even || is_animated_image(format.container))) return;
  throw FilmSizeError(fmt::format("a video of {}x{}", width, height),
                      "the width and height of a video must be even",
                      std::max(2, width + width % 2), std::max(2, height + height % 2));
}

void require_kept_alpha(const VideoFormat& format) {
  const OutputFormat& output = output_format(format.container);
  if (!format.transparent || output.keeps_alpha()) return;
  const auto others = [](bool is_animated) {
    return format_texts(&OutputFormat::extension, [=](const OutputFormat& other) {
      return other.keeps_alpha() && other.is_animated_image == is_animated;
    });
  };
  throw InvalidArgument(fmt::format("container {}", output.ending),
                        "it cannot keep a transparent background",
                        fmt::format("choose {} (or {}), or give an opaque background",
                                    listed(others(false), "or"), fmt::join(others(true), ", ")));
}

}  // namespace

Arguments joined(std::initializer_list<Arguments> groups) {
  Arguments all;
  for (const Arguments& group : groups) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

Arguments input_arguments(const VideoFormat& format) {
  require_valid_size(format);
  require_kept_alpha(format);
  // Planar frames are tagged at the input too: since 7.1, ffmpeg's encoders copy the tags of the
  // frames to the video, whatever the output options say.
  const std::string frame_tags =
      format.is_rgb() ? "" : fmt::format("{} -chroma_sample_location left", bt709_tags);
  return words_of(
      fmt::format("{} -f rawvideo -pix_fmt {} -video_size {}x{} -framerate {} {} -i pipe:0",
                  quiet_options, pixel_format(format), format.width, format.height,
                  rational(format.fps / format.frame_step()), frame_tags));
}

Arguments output_arguments(const VideoFormat& format) {
  return joined({is_animated_image(format.container)
                     ? animation_filters(format)
                     : words_of(format.transparent ? conversion : ""),
                 words_of(codec_arguments(format))});
}

Arguments encoder_arguments(const VideoFormat& format) {
  return joined({input_arguments(format), output_arguments(format)});
}

}  // namespace twrench::video
