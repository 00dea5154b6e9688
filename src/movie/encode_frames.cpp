#include "movie/encode_frames.h"

#include <fmt/format.h>

#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "base/sha256.h"
#include "image/png.h"
#include "movie/encoder.h"
#include "movie/frame_range.h"
#include "movie/manifest.h"

namespace twrench {
namespace {

/// The frames of the manifest's range that it does not tell of, or that have no file.
std::vector<int> missing_frames(const Manifest& manifest, const std::filesystem::path& folder) {
  std::vector<int> missing;
  auto record = manifest.frames.begin();
  for (const int frame : parse_frame_range(manifest.range, max_frame_count)) {
    const bool told = record != manifest.frames.end() && record->frame == frame;
    if (!told || !std::filesystem::exists(folder / record->file)) {
      missing.push_back(frame);
    }
    record += told ? 1 : 0;
  }
  return missing;
}

/// The frame as it was drawn, or a FileError.
Image read_frame(const FrameRecord& record, const std::filesystem::path& folder,
                 const Manifest& manifest) {
  constexpr std::size_t longest = 1U << 30U;
  const std::filesystem::path path = folder / record.file;
  const auto png = read_file(path, longest);
  if (sha256_hex(png) != record.sha256) {
    throw FileError("cannot use " + path.string(), "it is not the file that the manifest tells of",
                    "render the frames again: --frames " + manifest.range);
  }
  Image image = decode_png(png, path.string());
  if (image.width != manifest.width || image.height != manifest.height) {
    throw FileError("cannot use " + path.string(),
                    fmt::format("it has {}x{} pixels, the manifest says {}x{}", image.width,
                                image.height, manifest.width, manifest.height));
  }
  return image;
}

}  // namespace

void encode_frames(const std::filesystem::path& folder, const std::filesystem::path& output,
                   const std::function<void(int done, int total)>& progress) {
  const Manifest manifest = read_manifest(folder / manifest_name);
  const std::vector<int> missing = missing_frames(manifest, folder);
  if (!missing.empty()) {
    throw FileError("cannot encode " + folder.string(),
                    "frames are missing: " + format_frame_range(missing),
                    "render them again: --frames " + manifest.range);
  }
  const bool transparent = read_frame(manifest.frames.front(), folder, manifest).channels == 4;
  const VideoFormat format{manifest.width, manifest.height, manifest.fps, container_of(output),
                           transparent};
  require_encoder(format);
  VideoEncoder encoder(output, format);
  const int total = static_cast<int>(manifest.frames.size());
  for (int done = 0; done < total; ++done) {
    encoder.write(read_frame(manifest.frames[static_cast<std::size_t>(done)], folder, manifest));
    progress(done + 1, total);
  }
  encoder.finish();
}

}  // namespace twrench
