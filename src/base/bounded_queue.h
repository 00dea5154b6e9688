#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace twrench {

/// Joins two stages of a pipeline: first in, first out, any number of threads at either end, never
/// more than `capacity` items inside, so that a fast stage waits for a slow one.
///
/// Either end may close it: the producer when there is no more, the consumer when it failed. What
/// is inside at that time can still be taken.
template <typename T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Waits for room. False, and the item is dropped, when the queue is closed: nobody will take it.
  bool push(T item) {
    {
      std::unique_lock lock(mutex_);
      room_.wait(lock, [&] { return closed_ || items_.size() < capacity_; });
      if (closed_) {
        return false;
      }
      items_.push_back(std::move(item));
    }
    item_.notify_one();
    return true;
  }

  /// Waits for an item. Nothing when the queue is closed and empty: there will be none.
  std::optional<T> pop() {
    std::optional<T> item;
    {
      std::unique_lock lock(mutex_);
      item_.wait(lock, [&] { return closed_ || !items_.empty(); });
      if (items_.empty()) {
        return item;
      }
      item.emplace(std::move(items_.front()));
      items_.pop_front();
    }
    room_.notify_one();
    return item;
  }

  /// Ends all waiting, now and later. May be called more than once.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    room_.notify_all();
    item_.notify_all();
  }

 private:
  const std::size_t capacity_;
  std::mutex mutex_;
  std::condition_variable room_;
  std::condition_variable item_;
  std::deque<T> items_;
  bool closed_ = false;
};

}  // namespace twrench
