#include "system/bounded_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

namespace twrench::system {
namespace {

TEST(BoundedQueue, FirstInFirstOut) {
  BoundedQueue<int> queue(3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(queue.push(i));
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(queue.pop(), i);
  }
}

TEST(BoundedQueue, WhatIsInsideACloseCanBeTaken) {
  BoundedQueue<int> queue(2);
  EXPECT_TRUE(queue.push(7));
  queue.close();
  EXPECT_FALSE(queue.push(8));
  EXPECT_EQ(queue.pop(), 7);
  EXPECT_EQ(queue.pop(), std::nullopt);
}

TEST(BoundedQueue, CarriesWhatCanOnlyBeMoved) {
  BoundedQueue<std::unique_ptr<int>> queue(1);
  EXPECT_TRUE(queue.push(std::make_unique<int>(5)));
  EXPECT_EQ(**queue.pop(), 5);
}

TEST(BoundedQueue, NeverHoldsMoreThanItsCapacity) {
  constexpr int capacity = 2;
  constexpr int items = 2000;
  BoundedQueue<int> queue(capacity);
  std::atomic<int> taken = 0;
  std::atomic<int> most = 0;
  std::thread producer([&] {
    for (int i = 0; i < items; ++i) {
      queue.push(i);
      // Items inside, and one that the consumer has taken but not counted yet.
      const int inside = i + 1 - taken;
      if (inside > most) {
        most = inside;
      }
    }
    queue.close();
  });
  while (queue.pop()) {
    ++taken;
  }
  producer.join();
  EXPECT_EQ(taken, items);
  EXPECT_LE(most, capacity + 1);
}

TEST(BoundedQueue, CloseWakesAWaitingProducer) {
  BoundedQueue<int> queue(1);
  queue.push(0);
  bool pushed = true;
  std::thread producer([&] { pushed = queue.push(1); });
  queue.close();
  producer.join();
  EXPECT_FALSE(pushed);
}

TEST(BoundedQueue, CloseWakesAllWaitingConsumers) {
  BoundedQueue<int> queue(1);
  std::atomic<int> nothings = 0;
  std::vector<std::thread> consumers;
  consumers.reserve(3);
  for (int i = 0; i < 3; ++i) {
    consumers.emplace_back([&] {
      if (!queue.pop()) {
        ++nothings;
      }
    });
  }
  queue.close();
  for (std::thread& consumer : consumers) {
    consumer.join();
  }
  EXPECT_EQ(nothings, 3);
}

TEST(BoundedQueue, LosesAndDoublesNothingBetweenManyThreads) {
  constexpr int producers = 3;
  constexpr int each = 1000;
  BoundedQueue<int> queue(4);
  std::vector<std::atomic<int>> seen(std::size_t{producers} * each);
  std::vector<std::thread> threads;
  threads.reserve(std::size_t{2} * producers);
  std::atomic<int> running = producers;
  for (int p = 0; p < producers; ++p) {
    threads.emplace_back([&, p] {
      for (int i = 0; i < each; ++i) {
        queue.push(p * each + i);
      }
      if (--running == 0) {
        queue.close();
      }
    });
  }
  for (int c = 0; c < 3; ++c) {
    threads.emplace_back([&] {
      while (const auto item = queue.pop()) {
        ++seen[static_cast<std::size_t>(*item)];
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const auto& count : seen) {
    EXPECT_EQ(count, 1);
  }
}

}  // namespace
}  // namespace twrench::system
