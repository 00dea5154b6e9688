#pragma once

#include <cstddef>
#include <functional>

namespace twrench {

/// Divides [0, count) into parts of at most `grain` (> 0) and calls `work(begin, end)` for each, on
/// up to `threads` threads including the calling one; 0 means one per processor. A single part, or
/// a single thread, uses only the calling thread. If the system refuses to start threads, fewer
/// share the work. An exception stops the work and is rethrown to the caller; if there are several,
/// that of the first part.
void for_each_part(std::size_t count, std::size_t grain, unsigned threads,
                   const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace twrench
