#include "system/file_lock.h"

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

}  // namespace twrench::system
