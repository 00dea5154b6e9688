#pragma once

#include <algorithm>
#include <thread>

namespace twrench::system {

/// Returns the number of hardware threads; 1 if the system does not tell.
inline unsigned processor_count() { return std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace twrench::system
