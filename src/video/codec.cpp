#include "video/codec.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/letters.h"

namespace twrench::video {
namespace {

constexpr std::array<std::pair<std::string_view, Container>, 6> containers{
    {{"mp4", Container::mp4},
     {"mov", Container::mov},
     {"mkv", Container::matroska},
     {"webm", Container::webm},
     {"gif", Container::gif},
     {"webp", Container::webp}}};

/// ffmpeg's name of the container.
std::string_view muxer(Container container) {
  switch (container) {
    case Container::mov:
      return "mov";
    case Container::matroska:
      return "matroska";
    case Container::webm:
      return "webm";
    case Container::gif:
      return "gif";
    case Container::webp:
      return "webp";
    case Container::mp4:
      break;
  }
  return "mp4";
}

/// The index precedes the frames, so that a player can start at once: it is moved there at the end
/// or, in a streamed video, each fragment is preceded by its own.
std::string_view index_arguments(Container container, bool streamed) {
  if (container != Container::mp4 && container != Container::mov) return "";
  return streamed ? "-movflags +frag_keyframe+empty_moov+default_base_moof"
                  : "-movflags +faststart";
}

/// Without -auto-alt-ref 0, libvpx before 1.13 rejects alpha.
constexpr const char* vp9 =
    "-c:v libvpx-vp9 -crf 18 -b:v 0 -deadline good -cpu-used 4 -row-mt 1 -auto-alt-ref 0";
constexpr const char* prores = "-c:v prores_ks -profile:v 4444 -alpha_bits 16 -vendor apl0";
/// aq-mode 3 spends more bits on dark areas, where H.264 first shows banding in gradients. Rotating
/// smooth surfaces gain nothing from smaller blocks with their own motion vectors: without them the
/// encoder takes a sixth less time at the same quality and size.
constexpr const char* h264 = "-c:v libx264 -preset veryfast -crf 16 -aq-mode 3 -partitions i4x4";

/// Repeated for ever. At a lower quality, libwebp leaves unchanged what has changed by two levels
/// or more, and soft shadows leave a trace of blocks.
constexpr const char* webp =
    "-c:v libwebp_anim -pix_fmt bgra -quality 97 -compression_level 4 -loop 0";
constexpr const char* gif = "-c:v gif -loop 0";

}  // namespace

Container container_named(std::string_view name) {
  const std::string lower = in_small_letters(name);
  for (const auto& [known, container] : containers) {
    if (lower == known) return container;
  }
  throw InvalidArgument(fmt::format("container '{}'", name),
                        "it is not a supported video container",
                        "choose mp4, mov, mkv, webm, gif or webp");
}

std::string_view name_of(Container container) {
  return std::ranges::find(containers, container, [](const auto& known) { return known.second; })
      ->first;
}

Container container_of(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  try {
    return container_named(std::string_view(ending).substr(ending.empty() ? 0 : 1));
  } catch (const InvalidArgument&) {
    throw InvalidArgument("video " + file.string(), "its name does not end in that of a container",
                          "use .mp4, .mov, .mkv, .webm, .gif or .webp");
  }
}

bool is_animated_image(Container container) {
  return container == Container::gif || container == Container::webp;
}

bool keeps_alpha(Container container) {
  return container != Container::mp4 && container != Container::matroska;
}

int VideoFormat::shown_height() const {
  if (scaled_width == 0) return height;
  return std::max(1, static_cast<int>(std::lround(double(height) * scaled_width / width)));
}

int VideoFormat::frame_step() const {
  if (!is_animated_image(container)) return 1;
  const double fastest = container == Container::gif ? 50 : 90;
  constexpr double round_off = 1e-9;
  return std::max(1, static_cast<int>(std::ceil(fps / fastest - round_off)));
}

std::string codec_arguments(Container container, bool alpha, bool streamed) {
  if (is_animated_image(container)) {
    return fmt::format("{} -f {}", container == Container::gif ? gif : webp, muxer(container));
  }
  const bool webm = container == Container::webm;
  const char* codec = webm ? vp9 : (alpha ? prores : h264);
  const char* pixels = alpha ? (webm ? "yuva420p" : "yuva444p10le") : "yuv420p";
  return fmt::format("-pix_fmt {} {} {} {} -f {}", pixels, codec,
                     index_arguments(container, streamed), bt709_tags, muxer(container));
}

}  // namespace twrench::video
