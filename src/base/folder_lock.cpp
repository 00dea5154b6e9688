#include "base/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>

#include "base/error.h"

namespace twrench {

FolderLock::FolderLock(const std::filesystem::path& folder, LockKind kind)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  const int operation = kind == LockKind::exclusive ? LOCK_EX : LOCK_SH;
  if (folder_ && ::flock(folder_.get(), operation | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw FileError("cannot write to " + folder.string(),
                    "another run is writing there at this moment",
                    "wait for its end, or choose another folder");
  }
}

}  // namespace twrench
