#include "movie/codec.h"

#include <fmt/format.h>

namespace twrench {
namespace {

/// ffmpeg's name of it.
std::string muxer(Container container) {
  switch (container) {
    case Container::mov:
      return "mov";
    case Container::matroska:
      return "matroska";
    case Container::webm:
      return "webm";
    case Container::mp4:
      break;
  }
  return "mp4";
}

/// Without -auto-alt-ref 0, libvpx refuses alpha in versions before 1.13.
constexpr const char* vp9 =
    "-c:v libvpx-vp9 -crf 18 -b:v 0 -deadline good -cpu-used 4 -row-mt 1 -auto-alt-ref 0";
constexpr const char* prores = "-c:v prores_ks -profile:v 4444 -alpha_bits 16 -vendor apl0";
/// aq-mode 3 spends on the dark: there H.264 turns a gradient into bands first. Smooth surfaces
/// that turn gain nothing from smaller blocks with motion of their own: without, the encoder takes
/// a sixth less time for the same quality and size.
constexpr const char* h264 =
    "-c:v libx264 -preset veryfast -crf 16 -aq-mode 3 -partitions i4x4 -movflags +faststart";

}  // namespace

Container container_of(const std::filesystem::path& file) {
  const auto ending = file.extension();
  if (ending == ".mov") return Container::mov;
  if (ending == ".mkv") return Container::matroska;
  if (ending == ".webm") return Container::webm;
  return Container::mp4;
}

bool keeps_alpha(Container container) {
  return container == Container::webm || container == Container::mov;
}

std::string codec_arguments(Container container, bool alpha) {
  const bool webm = container == Container::webm;
  const char* codec = webm ? vp9 : (alpha ? prores : h264);
  const char* pixels = alpha ? (webm ? "yuva420p" : "yuva444p10le") : "yuv420p";
  return fmt::format("-pix_fmt {} {} {} -f {}", pixels, codec, bt709_tags, muxer(container));
}

}  // namespace twrench
