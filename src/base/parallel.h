#pragma once

#include <cstddef>
#include <functional>

namespace twrench {

/// Calls `work(begin, end)` for parts of [0, count) that together are all of it, each of at most
/// `grain` (> 0), on up to `threads` threads, the calling one among them; 0 stands for all
/// processors. What is no more than one part, or one thread's, runs on the calling thread alone;
/// where the system refuses threads, those that there are do the work. An exception ends the work
/// and reaches the caller; of several, that of the first part.
void for_each_part(std::size_t count, std::size_t grain, unsigned threads,
                   const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace twrench
