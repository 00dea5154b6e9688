// Manifests, as read by --resume and encode.
#include "video/manifest.h"

#include <string_view>

#include "system/error.h"
#include "target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace twrench;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const video::Manifest manifest = video::parse_manifest(text, "input");
    for (const video::FrameRecord& record : manifest.frames) {
      require(record.file.find('/') == std::string::npos, "a plain name");
    }
    const std::string written = video::format_manifest(manifest);
    require(video::format_manifest(video::parse_manifest(written, "written")) == written,
            "read back");
  } catch (const system::FileError&) {
  }
  return 0;
}
