#include "video/animated_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "system/file.h"

namespace twrench::video {
namespace {

namespace fs = std::filesystem;

/// Returns a filter such as "scale=640:360:flags=lanczos,"; nothing if the frames have that size.
std::string scaling(const VideoFormat& format) {
  if (format.shown_width() == format.width) return "";
  return fmt::format("scale={}:{}:flags=lanczos+accurate_rnd+full_chroma_inp+full_chroma_int,",
                     format.shown_width(), format.shown_height());
}

/// One palette for all frames, so that the colours of resting parts do not change.
std::string palette_filter(const VideoFormat& format) {
  return fmt::format("palettegen=reserve_transparent={}", format.transparent ? 1 : 0);
}

/// An ordered pattern, unlike error diffusion, does not crawl where nothing moves, and compresses.
constexpr const char* drawing_filter = "paletteuse=dither=bayer:bayer_scale=4";

/// The filters from the input to the outputs [shown] and [palette].
std::string palette_graph(const VideoFormat& format) {
  return fmt::format("[0:v]{}split[shown][seen];[seen]{}[palette]", scaling(format),
                     palette_filter(format));
}

fs::path temporary_beside(const system::PendingFile& output) {
  if (!output.is_direct()) return output.target();
  std::error_code failed;
  const fs::path folder = fs::temp_directory_path(failed);
  if (failed) throw system::file_error("cannot use the folder for temporary files", failed.value());
  return folder / "twrench.palette";
}

std::uint32_t little_endian(const char* bytes, int count) {
  std::uint32_t value = 0;
  for (int i = count; i-- > 0;) value = value << 8U | static_cast<std::uint8_t>(bytes[i]);
  return value;
}

std::array<char, 4> little_endian(std::uint32_t value) {
  std::array<char, 4> bytes{};
  for (char& byte : bytes) {
    byte = static_cast<char>(value & 0xFFU);
    value >>= 8U;
  }
  return bytes;
}

constexpr std::size_t riff_header = 12;  // "RIFF", the size of what follows, "WEBP"

/// Reads properties of the picture from a chunk of a WebP. `data` is the beginning of the chunk.
void take_chunk(std::string_view name, const std::array<char, 16>& data, VideoProperties& webp) {
  const auto at = [&](std::size_t offset, int bytes) {
    return static_cast<int>(little_endian(data.data() + offset, bytes));
  };
  if (name == "VP8X") {
    webp.width = at(4, 3) + 1;
    webp.height = at(7, 3) + 1;
  } else if (name == "ANMF") {
    ++webp.frames;
    webp.duration += at(12, 3) / 1000.0;
  } else if (name == "VP8 " && webp.frames == 0) {
    webp = {at(6, 2) & 0x3FFF, at(8, 2) & 0x3FFF, 1, 0};
  }
}

}  // namespace

Arguments animation_filters(const VideoFormat& format) {
  const OutputFormat& output = output_format(format.container);
  if (output.has_palette) {
    return {"-filter_complex", palette_graph(format) + ";[shown][palette]" + drawing_filter};
  }
  std::string filters = scaling(format);
  if (output.is_video() || filters.empty()) return {};
  filters.pop_back();  // the comma
  return {"-vf", filters};
}

PalettePasses::PalettePasses(const system::PendingFile& output)
    : frames_(temporary_beside(output)), palette_(temporary_beside(output)) {}

Arguments PalettePasses::first(const VideoFormat& format) const {
  Arguments arguments{"-filter_complex", palette_graph(format)};
  for (const auto& [stream, file] : {std::pair("[shown]", &frames_), {"[palette]", &palette_}}) {
    arguments.insert(arguments.end(), {"-map", stream, "-c:v", "ffv1", "-f", "nut",
                                       "file:" + file->path().string()});
  }
  return arguments;
}

Arguments PalettePasses::second() const {
  return {"-f",
          "nut",
          "-i",
          "file:" + frames_.path().string(),
          "-f",
          "nut",
          "-i",
          "file:" + palette_.path().string(),
          "-filter_complex",
          std::string("[0:v][1:v]") + drawing_filter};
}

std::optional<VideoProperties> probe_webp(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, riff_header> riff{};
  file.read(riff.data(), riff.size());
  const std::string_view head(riff.data(), riff.size());
  if (!file || !head.starts_with("RIFF") || !head.ends_with("WEBP")) return std::nullopt;
  VideoProperties webp;
  std::array<char, 8> chunk{};  // name and size
  while (file.read(chunk.data(), chunk.size())) {
    const std::uint64_t size = little_endian(chunk.data() + 4, 4);
    const std::streamoff next = file.tellg() + static_cast<std::streamoff>(size + size % 2);
    std::array<char, 16> data{};
    file.read(data.data(), data.size());
    file.clear();
    take_chunk({chunk.data(), 4}, data, webp);
    file.seekg(next);
  }
  if (webp.frames == 0) return std::nullopt;
  return webp;
}

void append_comment(const fs::path& path, const std::string& comment) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  std::array<char, 4> head{};
  file.read(head.data(), head.size());
  const auto length = static_cast<std::uint32_t>(comment.size());
  if (std::string_view(head.data(), head.size()) == "RIFF") {
    // A separate chunk, which readers skip. Unlike XMP, it may follow a picture of any kind.
    file.seekp(0, std::ios::end);
    file.write("NOTE", 4).write(little_endian(length).data(), 4) << comment;
    if (length % 2 != 0) file.put('\0');
    const auto whole = static_cast<std::uint32_t>(file.tellp());
    file.seekp(4).write(little_endian(whole - 8).data(), 4);
  } else {
    file.seekp(-1, std::ios::end);  // over the trailer, which is written again
    file << "\x21\xFE" << static_cast<char>(length) << comment << '\0' << ';';
  }
  file.close();
  if (!file) throw system::file_error("cannot write " + path.string(), errno);
}

bool has_comment(const fs::path& path, const std::string& comment) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff tail = static_cast<std::streamoff>(comment.size()) + 2;
  file.seekg(-tail, std::ios::end);
  const std::string last{std::istreambuf_iterator<char>(file), {}};
  return last.find(comment) != std::string::npos;
}

}  // namespace twrench::video
