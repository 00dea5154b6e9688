#include "video/codec.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/enumeration.h"
#include "base/words.h"
#include "video/animated_image.h"
#include "video/error.h"

namespace twrench::video {
namespace {

/// Rotating smooth surfaces gain nothing from smaller blocks with their own motion vectors: without
/// them the encoder takes a sixth less time at the same quality and size. Without B-frames it takes
/// a fifth less time at the same quality, and the file is a tenth larger. Without psychovisual
/// optimization, which adds detail that the frames do not have, the file is a tenth smaller.
/// bench/encode.sh compares the rows, whose crf give the same PSNR and SSIM.
constexpr std::array h264_efforts{
    EffortSettings{Effort::fast, "-preset ultrafast", 19},
    EffortSettings{Effort::balanced, "-preset veryfast -bf 0 -partitions i4x4", 16},
    EffortSettings{Effort::small, "-preset slow -psy-rd 0:0", 18}};

static_assert(has_row_for_each(h264_efforts, &EffortSettings::effort));

/// aq-mode 3 spends more bits on dark areas, where H.264 first shows banding in gradients.
constexpr Codec h264{"libx264", "-aq-mode 3", "H.264 video in MP4", h264_efforts, 51};

constexpr Codec prores{"prores_ks", "-profile:v 4444 -alpha_bits 16 -vendor apl0",
                       "video with alpha in MOV"};

constexpr std::array vp9_efforts{EffortSettings{Effort::fast, "-deadline realtime -cpu-used 8", 11},
                                 EffortSettings{Effort::balanced, "-deadline good -cpu-used 4", 18},
                                 EffortSettings{Effort::small, "-deadline good -cpu-used 1", 22}};

static_assert(has_row_for_each(vp9_efforts, &EffortSettings::effort));

/// Without -auto-alt-ref 0, libvpx before 1.13 rejects alpha.
constexpr Codec vp9{"libvpx-vp9", "-b:v 0 -row-mt 1 -auto-alt-ref 0",
                    "video in WebM, optionally with alpha", vp9_efforts, 63};

/// Repeated for ever.
constexpr Codec gif{"gif", "-loop 0", "animated images in GIF"};

/// Repeated for ever. At a lower quality, libwebp ignores changes of two levels or more, so that
/// soft shadows leave a trace of blocks.
constexpr Codec webp{"libwebp_anim", "-quality 97 -compression_level 4 -loop 0",
                     "animated images in WebP"};

/// All players and browsers play it. The first packet only fills the decoder: it precedes the
/// sound, and containers that cannot skip it would delay the sound or the picture by 21 ms.
constexpr SoundCodec aac{"aac", "-c:a aac -b:a 192k -bsf:a noise=drop=lt(pts\\,0) -f mp4",
                         "sound in MP4, MOV and MKV"};

/// WebM allows only Opus and Vorbis. Shorter packets end closer to the end of the film.
constexpr SoundCodec opus{"libopus", "-c:a libopus -b:a 160k -frame_duration 10 -f webm",
                          "sound in WebM"};

// Browsers slow down a GIF that shows a frame for less than 0.02 s, and a WebP for less than 0.011
// s. They play MOV, and usually MKV, as if it were MP4.
constexpr std::array formats{OutputFormat{.container = Container::mp4,
                                          .ending = "mp4",
                                          .label = "MP4",
                                          .muxer = "mp4",
                                          .media_type = "video/mp4",
                                          .opaque = {&h264, "yuv420p"},
                                          .sound = &aac,
                                          .has_index = true},
                             OutputFormat{.container = Container::mov,
                                          .ending = "mov",
                                          .label = "MOV",
                                          .muxer = "mov",
                                          .media_type = "video/mp4",
                                          .opaque = {&h264, "yuv420p"},
                                          .transparent = {&prores, "yuva444p10le"},
                                          .sound = &aac,
                                          .has_index = true},
                             OutputFormat{.container = Container::matroska,
                                          .ending = "mkv",
                                          .label = "MKV",
                                          .muxer = "matroska",
                                          .media_type = "video/mp4",
                                          .opaque = {&h264, "yuv420p"},
                                          .sound = &aac},
                             OutputFormat{.container = Container::webm,
                                          .ending = "webm",
                                          .label = "WebM",
                                          .muxer = "webm",
                                          .media_type = "video/webm",
                                          .opaque = {&vp9, "yuv420p"},
                                          .transparent = {&vp9, "yuva420p"},
                                          .sound = &opus},
                             OutputFormat{.container = Container::gif,
                                          .ending = "gif",
                                          .label = "GIF",
                                          .muxer = "gif",
                                          .media_type = "image/gif",
                                          .opaque = {&gif, ""},
                                          .transparent = {&gif, ""},
                                          .is_animated_image = true,
                                          .has_palette = true,
                                          .most_fps = 50},
                             OutputFormat{.container = Container::webp,
                                          .ending = "webp",
                                          .label = "WebP",
                                          .muxer = "webp",
                                          .media_type = "image/webp",
                                          .opaque = {&webp, "bgra"},
                                          .transparent = {&webp, "bgra"},
                                          .is_animated_image = true,
                                          .most_fps = 90}};

static_assert(has_row_for_each(formats, &OutputFormat::container));

/// The index precedes the frames, so that a player can start at once. It is moved there at the end;
/// in a streamed video, each fragment has its own index before it. The first one is written with
/// the first fragment (delay_moov), because it states the delay of reordered frames.
std::string_view index_arguments(const OutputFormat& format, bool streamed) {
  if (!format.has_index) return "";
  return streamed ? "-movflags +frag_keyframe+delay_moov+default_base_moof"
                  : "-movflags +faststart";
}

/// Returns the settings of the codec for the effort. The codec must have efforts.
const EffortSettings& settings_for(const Codec& codec, const Quality& quality) {
  return *std::ranges::find(codec.efforts, quality.effort.value_or(Effort::balanced),
                            &EffortSettings::effort);
}

const Codec& codec_of(const VideoFormat& format) {
  return *output_format(format.container).encoding(format.transparent).codec;
}

/// Throws if an effort or a quality is requested of a codec that has none.
void require_no_quality(const VideoFormat& format) {
  const Quality& quality = format.quality;
  if (quality == Quality{}) return;
  const auto others = format_texts(&OutputFormat::extension, [&](const OutputFormat& other) {
    return other.has_quality(format.transparent);
  });
  throw InvalidArgument(
      quality.effort ? fmt::format("encode {}", enumerator_name(*quality.effort))
                     : fmt::format("crf {}", *quality.crf),
      fmt::format("the encoder {} has no such setting", codec_of(format).name),
      fmt::format("leave it out, or choose another format ({})", fmt::join(others, ", ")));
}

}  // namespace

std::span<const OutputFormat> output_formats() { return formats; }

const OutputFormat& output_format(Container container) {
  return *std::ranges::find(formats, container, &OutputFormat::container);
}

std::string listed(const std::vector<std::string>& texts, std::string_view conjunction) {
  return fmt::format("{} {} {}", fmt::join(texts.begin(), texts.end() - 1, ", "), conjunction,
                     texts.back());
}

Container container_named(std::string_view name) {
  const auto format = std::ranges::find(formats, to_lower(name), &OutputFormat::ending);
  if (format != formats.end()) return format->container;
  throw InvalidArgument(fmt::format("container '{}'", name),
                        "it is not a supported video container",
                        "choose " + listed(format_texts(&OutputFormat::ending), "or"));
}

Container container_of(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  try {
    return container_named(std::string_view(ending).substr(ending.empty() ? 0 : 1));
  } catch (const InvalidArgument&) {
    throw InvalidArgument("video " + file.string(), "its extension is not that of a video format",
                          "use " + listed(format_texts(&OutputFormat::extension), "or"));
  }
}

bool is_animated_image(Container container) { return output_format(container).is_animated_image; }

int VideoFormat::shown_height() const {
  if (scaled_width == 0) return height;
  return std::max(1, static_cast<int>(std::lround(double(height) * scaled_width / width)));
}

int VideoFormat::frame_step() const {
  const double most_fps = output_format(container).most_fps;
  if (most_fps == 0) return 1;
  constexpr double round_off = 1e-9;
  return std::max(1, static_cast<int>(std::ceil(fps / most_fps - round_off)));
}

Quality chosen_quality(const VideoFormat& format) {
  const Codec& codec = codec_of(format);
  const Quality& quality = format.quality;
  if (codec.efforts.empty()) {
    require_no_quality(format);
    return {};
  }
  const EffortSettings& settings = settings_for(codec, quality);
  const int crf = quality.crf.value_or(settings.crf);
  if (crf < 0 || crf > codec.most_crf) {
    throw OutOfRange(fmt::format("crf {}", crf),
                     fmt::format("the encoder {} accepts 0 to {}", codec.name, codec.most_crf),
                     {double(crf), 0, double(codec.most_crf)},
                     fmt::format("choose a number in this range; the default is {}", settings.crf));
  }
  return {settings.effort, crf};
}

std::string codec_arguments(const VideoFormat& format) {
  const OutputFormat& output = output_format(format.container);
  const auto& [codec, pixels] = output.encoding(format.transparent);
  const std::string pixel_format = *pixels == '\0' ? "" : fmt::format("-pix_fmt {}", pixels);
  const Quality quality = chosen_quality(format);
  const std::string effort =
      quality.crf ? fmt::format("{} -crf {}", settings_for(*codec, quality).options, *quality.crf)
                  : "";
  return fmt::format("{} -c:v {} {} {} {} {} -f {}", pixel_format, codec->name, codec->options,
                     effort, index_arguments(output, format.streamed),
                     output.is_video() ? bt709_tags : "", output.muxer);
}

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
