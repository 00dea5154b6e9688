#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <latch>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace twrench {
namespace {

TEST(ForEachPart, TakesEachItemOnce) {
  for (const std::size_t count : {0U, 1U, 7U, 8U, 1000U}) {
    for (const std::size_t grain : {1U, 8U, 3000U}) {
      for (const unsigned threads : {0U, 1U, 2U, 9U}) {
        std::vector<std::atomic<int>> taken(count);
        for_each_part(count, grain, threads, [&](std::size_t begin, std::size_t end) {
          EXPECT_LT(begin, end);
          EXPECT_LE(end - begin, grain);
          for (std::size_t i = begin; i < end; ++i) ++taken[i];
        });
        for (const auto& times : taken) EXPECT_EQ(times, 1);
      }
    }
  }
}

TEST(ForEachPart, UsesTheCallingThreadAloneForOnePartAndForOneThread) {
  const auto caller = std::this_thread::get_id();
  const auto here = [&](std::size_t, std::size_t) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // lets another thread take the rest
  };
  for_each_part(20, 20, 8, here);
  for_each_part(20, 1, 1, here);
}

// The message must not depend on which thread is ahead.
TEST(ForEachPart, ReportsTheFirstOfSeveralFailures) {
  for (int round = 0; round < 100; ++round) {
    std::latch both_begun(2);
    try {
      for_each_part(2, 1, 2, [&](std::size_t begin, std::size_t) {
        both_begun.arrive_and_wait();
        throw std::runtime_error(std::to_string(begin));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& failure) {
      EXPECT_STREQ(failure.what(), "0");
    }
  }
}

}  // namespace
}  // namespace twrench
