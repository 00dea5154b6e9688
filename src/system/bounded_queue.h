#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace twrench::system {

/// A first-in, first-out queue between two stages of a pipeline, for any number of threads at
/// either end. It holds at most `capacity` items, so that a fast stage waits for a slow one.
///
/// Either end may close it: the producer when it is finished, the consumer when it has failed.
/// Items already in the queue can still be taken.
template <typename T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Waits for room and adds the item. Returns false and drops the item if the queue is closed.
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

  /// Waits for an item and takes it. Returns nothing if the queue is closed and empty.
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

  /// Closes the queue and ends all waiting, now and later. May be called more than once.
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

}  // namespace twrench::system
