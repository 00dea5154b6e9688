#include "torture.h"

#include <fcntl.h>
#include <grp.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

namespace twrench::torture {

Request parse_request(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    static_cast<void>(std::fprintf(stderr, "usage: %s SECONDS SEED [CASE]\n", argv[0]));
    std::exit(2);  // NOLINT(concurrency-mt-unsafe): there is one thread yet
  }
  return {std::strtod(argv[1], nullptr),
          static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)), argc == 4 ? argv[3] : ""};
}

void become_nobody(const std::string& program) {
  constexpr unsigned nobody = 65534;
  if (::geteuid() != 0) return;
  // First tests that the program is accessible: it is not in a folder that only root may enter.
  if (::setegid(nobody) == 0 && ::seteuid(nobody) == 0 &&
      ::faccessat(AT_FDCWD, program.c_str(), X_OK, AT_EACCESS) == 0) {
    if (::seteuid(0) == 0 && ::setgroups(0, nullptr) == 0 &&
        ::setresgid(nobody, nobody, nobody) == 0 && ::setresuid(nobody, nobody, nobody) == 0) {
      return;
    }
  }
  if (::seteuid(0) != 0 || ::setegid(0) != 0) std::abort();
}

std::size_t run_cases(double seconds, std::size_t count,
                      const std::function<void(std::uint32_t number)>& work) {
  using std::chrono::steady_clock;
  const auto end = steady_clock::now() + std::chrono::duration<double>(seconds);
  std::atomic<std::uint32_t> next = 0;
  const auto take_cases = [&] {
    while (steady_clock::now() < end) {
      const std::uint32_t number = next++;
      if (number >= count) return;
      work(number);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = std::max(1U, std::thread::hardware_concurrency()); i > 0; --i) {
    threads.emplace_back(take_cases);
  }
  for (std::thread& thread : threads) thread.join();
  return std::min<std::size_t>(next, count);
}

void tell(const std::string& text) {
  static std::mutex speaking;
  const std::lock_guard lock(speaking);
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stdout));
  static_cast<void>(std::fflush(stdout));
}

}  // namespace twrench::torture
