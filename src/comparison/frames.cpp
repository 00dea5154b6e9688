#include "comparison/frames.h"

#include <algorithm>
#include <system_error>

#include "base/letters.h"
#include "system/file.h"

namespace twrench::comparison {
namespace {

namespace fs = std::filesystem;

bool is_frame_name(const std::string& name) {
  const std::string ending = to_lower(fs::path(name).extension().string());
  return ending == ".png" && !name.starts_with('.');
}

std::vector<std::string> frame_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code failed;
  auto entry = fs::directory_iterator(folder, failed);
  if (failed == std::errc::no_such_file_or_directory) return names;
  for (; !failed && entry != fs::directory_iterator(); entry.increment(failed)) {
    std::string name = entry->path().filename().string();
    std::error_code unknown;
    if (is_frame_name(name) && !entry->is_directory(unknown)) names.push_back(std::move(name));
  }
  if (failed) {
    throw system::file_error("cannot read the folder " + folder.string(), failed.value(),
                             system::Access::read);
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace

fs::path Inputs::expected_frame(const std::string& name) const {
  return folders ? expected / name : expected;
}

fs::path Inputs::actual_frame(const std::string& name) const {
  return folders ? actual / name : actual;
}

std::vector<FrameName> frames_of(const Inputs& folders) {
  std::vector<FrameName> frames;
  for (std::string& name : frame_names(folders.expected)) {
    frames.push_back({std::move(name), true, false});
  }
  const auto middle = static_cast<std::ptrdiff_t>(frames.size());
  for (std::string& name : frame_names(folders.actual)) {
    const auto end = frames.begin() + middle;
    const auto found = std::ranges::lower_bound(frames.begin(), end, name, {}, &FrameName::name);
    if (found != end && found->name == name) {
      found->is_actual = true;
    } else {
      frames.push_back({std::move(name), false, true});
    }
  }
  std::ranges::inplace_merge(frames, frames.begin() + middle, {}, &FrameName::name);
  return frames;
}

}  // namespace twrench::comparison
