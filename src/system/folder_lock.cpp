#include "system/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include "system/error.h"
#include "system/file_lock.h"

namespace twrench::system {

FolderLock::FolderLock(const std::filesystem::path& folder, LockKind kind)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ && !lock_file(folder_, kind == LockKind::exclusive ? LOCK_EX : LOCK_SH)) {
    throw FileError("cannot write to " + folder.string(), "another run is writing there",
                    "wait for it to finish, or choose another folder");
  }
}

}  // namespace twrench::system
