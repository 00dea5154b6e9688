#include "comparison/update.h"

#include <optional>

#include "image/png.h"
#include "system/file.h"
#include "system/folder_lock.h"
#include "system/pending_file.h"

namespace twrench::comparison {
namespace {

bool is_to_be_copied(const FrameResult& frame) {
  return frame.outcome == Outcome::different || frame.outcome == Outcome::other_format ||
         frame.outcome == Outcome::extra;
}

void copy_frame(const Inputs& inputs, const std::string& name) {
  const auto actual = inputs.actual_frame(name);
  const auto bytes = system::read_regular_file(actual, image::max_png_size);
  image::require_whole_png(bytes, actual.string());
  // In a folder of frames, a link may lead to a file that another folder uses as well.
  system::PendingFile file(inputs.expected_frame(name),
                           inputs.folders ? system::Links::replace : system::Links::follow);
  file.write(bytes);
  file.commit();
}

}  // namespace

std::size_t update_expected(const Comparison& comparison) {
  if (comparison.first_unreadable() != nullptr) return 0;
  std::optional<system::FolderLock> lock;
  if (comparison.inputs.folders) {
    system::make_folder(comparison.inputs.expected);
    lock.emplace(comparison.inputs.expected, system::LockKind::exclusive);
  }
  std::size_t copied = 0;
  for (const FrameResult& frame : comparison.frames) {
    if (!is_to_be_copied(frame)) continue;
    copy_frame(comparison.inputs, frame.name);
    ++copied;
  }
  return copied;
}

}  // namespace twrench::comparison
