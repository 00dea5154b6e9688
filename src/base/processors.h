#pragma once

#include <algorithm>
#include <thread>

namespace twrench {

/// How many threads run at once; 1 where the system does not tell.
inline unsigned processor_count() { return std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace twrench
