#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"

namespace twrench {

/// The candidate that `name` was most likely meant to be: the one with the fewest slips of the hand
/// (a letter added, left out, changed, or two neighbours swapped), the first of equals. Nothing
/// when even that one is too far to be a misspelling.
std::optional<std::string> nearest(std::string_view name, std::span<const std::string> candidates);

/// The error for a `name` that is not among `candidates`: "WHAT: unknown name 'NAME'", with the
/// nearest offered and all of them listed.
UsageError unknown_name(const std::string& what, std::string_view name,
                        std::span<const std::string> candidates);

}  // namespace twrench
