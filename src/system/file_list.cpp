#include "system/file_list.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <system_error>

#include "system/file.h"
#include "system/pending_file.h"

namespace twrench::system {
namespace {

namespace fs = std::filesystem;

/// The absolute path without links in its folders; its last component may be one.
fs::path place_of(const fs::path& path) {
  std::error_code unknown;
  fs::path place = fs::absolute(path, unknown).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();  // "folder/" is "folder"
  return fs::weakly_canonical(place.parent_path(), unknown) / place.filename();
}

/// Names that identify the file, which need not exist: its place, that of the link's target, and
/// its number. A device has none.
std::set<std::string> identities_of(const fs::path& path) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) return {};
  std::set<std::string> names{place_of(path).string(), place_of(link_target(path)).string()};
  if (exists) names.insert(fmt::format("{}:{}", status.st_dev, status.st_ino));
  return names;
}

/// Throws if a new file cannot be put beside the file, so that a command fails before its
/// computation. Devices need no new file. A missing folder may be created later.
void require_place_for(const fs::path& file) {
  std::error_code unknown;
  const fs::path target = link_target(file);
  if (fs::exists(target, unknown) && !fs::is_regular_file(target, unknown)) return;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
  if (!fs::is_directory(folder, unknown)) return;
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    throw file_error("cannot write " + file.string(), errno);
  }
}

[[noreturn]] void refuse_input(const fs::path& output) {
  throw OverwriteError(output.string(), "it is an input of this command and would be overwritten",
                       "choose another name for the output");
}

[[noreturn]] void refuse_second_output(const fs::path& output) {
  throw OverwriteError(output.string(), "two outputs of this command would be written to this file",
                       "choose another name for one of them");
}

}  // namespace

void FileList::add_input(const fs::path& file) {
  std::error_code unknown;
  if (!file.empty() && file != "-" && fs::exists(file, unknown)) add(file, Role::input);
}

void FileList::add_output(const fs::path& file) {
  if (!file.empty() && file != "-") add(file, Role::output);
}

OutputFile FileList::add_output(const OutputKind& kind, const fs::path& file,
                                std::string_view format) {
  add_output(file);
  const OutputFormat& chosen = format_of(kind, file, format);
  std::error_code unknown;
  const bool is_stream = file == "-" || is_named_descriptor(link_target(file));
  const bool stands =
      !is_stream && fs::is_regular_file(file, unknown) && fs::file_size(file, unknown) > 0;
  if (stands && !overwrite_ && !is_written_in(chosen, file)) {
    throw ExistingFileError(
        file.string(),
        fmt::format("it exists, and is not {} output of twrench ({})", kind.name, chosen.name));
  }
  if (!is_stream) require_place_for(file);
  return {file, chosen};
}

void FileList::add_outputs(const fs::path& folder,
                           std::function<bool(const std::string& name)> is_output) {
  add_output(folder);
  const std::string place = place_of(link_target(folder)).string();
  for (const auto& [name, entry] : files_) {
    const fs::path path = name;
    if (path.parent_path() != place || !is_output(path.filename().string())) continue;
    entry.role == Role::input ? refuse_input(entry.path) : refuse_second_output(entry.path);
  }
  folders_.push_back({place, std::move(is_output)});
}

void FileList::add(const fs::path& file, Role role) {
  const auto refuse = [&](Role other, const fs::path& output) {
    role == Role::input || other == Role::input ? refuse_input(output)
                                                : refuse_second_output(output);
  };
  for (const std::string& name : identities_of(file)) {
    const auto [entry, is_new] = files_.try_emplace(name, Entry{file, role});
    const bool clashes = role == Role::output || entry->second.role == Role::output;
    if (!is_new && clashes)
      refuse(entry->second.role, role == Role::output ? file : entry->second.path);
    const fs::path path = name;
    for (const Folder& folder : folders_) {
      if (path.parent_path() == folder.place && folder.is_output(path.filename().string())) {
        refuse(Role::output, file);
      }
    }
  }
}

}  // namespace twrench::system
