#include "base/nearest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace twrench {
namespace {

/// Levenshtein's distance, one row at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

}  // namespace

UsageError unknown_name(const std::string& what, std::string_view name,
                        std::span<const std::string> candidates) {
  std::string remedy = fmt::format("one of: {}", fmt::join(candidates, ", "));
  const auto distance = [&](const std::string& c) { return edit_distance(name, c); };
  const auto best = std::ranges::min_element(candidates, {}, distance);
  // Further than half its letters away it is a guess, not a slip of the finger.
  if (best != candidates.end() && 2 * distance(*best) <= std::max(best->size(), name.size())) {
    remedy = fmt::format("did you mean '{}'? {}", *best, remedy);
  }
  return {what, fmt::format("unknown name '{}'", name), remedy};
}

}  // namespace twrench
