#include "system/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace twrench::system {

bool lock_file(const Descriptor& file, int operation) {
  using namespace std::chrono_literals;
  const auto end = std::chrono::steady_clock::now() + 3s;
  while (::flock(file.get(), operation | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return true;
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(20ms);
  }
  return true;
}

FolderLock::FolderLock(const std::filesystem::path& folder, LockKind kind)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ && !lock_file(folder_, kind == LockKind::exclusive ? LOCK_EX : LOCK_SH)) {
    throw FileError("cannot write to " + folder.string(), "another run is writing there",
                    "wait for it to finish, or choose another folder");
  }
}

}  // namespace twrench::system
