#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace twrench {
namespace {

/// The remaining parts and the first failure.
class Parts {
 public:
  Parts(std::size_t count, std::size_t grain,
        const std::function<void(std::size_t, std::size_t)>& work)
      : count_(count), grain_(grain), parts_((count + grain - 1) / grain), work_(work) {}

  std::size_t size() const { return parts_; }

  /// Works on parts until none is left or one has failed. Parts are handed out in ascending order,
  /// and parts in progress are finished. Hence the first of the parts that fail is always reached.
  void run() {
    while (!failed_) {
      const std::size_t part = next_++;
      if (part >= parts_) return;
      try {
        const std::size_t begin = part * grain_;
        work_(begin, begin + std::min(grain_, count_ - begin));
      } catch (...) {
        const std::lock_guard lock(mutex_);
        failed_ = true;
        if (part < failed_part_) failed_part_ = part, failure_ = std::current_exception();
      }
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const std::size_t count_, grain_, parts_;
  const std::function<void(std::size_t, std::size_t)>& work_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;  ///< Guards the failure.
  std::size_t failed_part_ = static_cast<std::size_t>(-1);
  std::exception_ptr failure_;
};

}  // namespace

void for_each_part(std::size_t count, std::size_t grain, unsigned threads,
                   const std::function<void(std::size_t, std::size_t)>& work) {
  Parts parts(count, grain, work);
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t useful = std::min<std::size_t>(threads, parts.size());
  {
    std::vector<std::jthread> others;
    others.reserve(useful);
    try {
      while (others.size() + 1 < useful) others.emplace_back([&parts] { parts.run(); });
    } catch (const std::system_error&) {
      // The system has no more threads, so fewer share the work.
    }
    parts.run();
  }
  parts.rethrow();
}

}  // namespace twrench
