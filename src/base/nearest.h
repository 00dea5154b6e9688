#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/error.h"

namespace twrench {

/// The error for a `name` that is not among `candidates`: "WHAT: unknown, ..." with the nearest
/// candidate offered, where one is near, and all of them listed.
UsageError unknown_name(const std::string& what, std::string_view name,
                        std::span<const std::string> candidates);

}  // namespace twrench
