#include "movie/earlier_run.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/sha256.h"

namespace twrench {
namespace {

bool has_frames(const std::filesystem::path& folder) {
  std::error_code failed;
  const std::filesystem::directory_iterator entries(folder, failed);
  return !failed && std::ranges::any_of(entries, [](const auto& entry) {
    return entry.path().filename().string().starts_with("frame_");
  });
}

}  // namespace

bool same_film(const Manifest& a, const Manifest& b) {
  return a.version == b.version && a.scene == b.scene && a.renderer == b.renderer &&
         a.width == b.width && a.height == b.height;
}

EarlierRun::EarlierRun(std::filesystem::path folder) : folder_(std::move(folder)) {
  exists_ = std::filesystem::exists(folder_ / manifest_name) || has_frames(folder_);
  try {
    manifest_ = read_manifest(folder_ / manifest_name);
  } catch (const FileError&) {
    return;
  }
  for (const FrameRecord& record : manifest_->frames) by_number_[record.frame] = &record;
}

std::optional<FrameRecord> EarlierRun::intact(const FrameRecord& wanted) const {
  const auto found = by_number_.find(wanted.frame);
  if (found == by_number_.end()) return std::nullopt;
  const FrameRecord& record = *found->second;
  if (record.t != wanted.t || record.X != wanted.X || record.view != wanted.view ||
      record.projection != wanted.projection) {
    return std::nullopt;
  }
  try {
    constexpr std::size_t longest = 1U << 30U;
    if (sha256_hex(read_file(folder_ / record.file, longest)) != record.sha256) return std::nullopt;
  } catch (const FileError&) {
    return std::nullopt;
  }
  return record;
}

}  // namespace twrench
