// Manifests: what --resume and encode read.
#include "video/manifest.h"

#include <string_view>

#include "system/error.h"
#include "target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace twrench;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const Manifest manifest = parse_manifest(text, "input");
    for (const FrameRecord& record : manifest.frames) {
      require(record.file.find('/') == std::string::npos, "a plain name");
    }
    const std::string written = format_manifest(manifest);
    require(format_manifest(parse_manifest(written, "written")) == written, "read back");
  } catch (const FileError&) {
  }
  return 0;
}
