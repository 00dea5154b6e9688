#include "recording/columns/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "base/words.h"
#include "recording/columns/column_sets.h"
#include "recording/conventions/names.h"

namespace twrench::recording {
namespace {

template <typename Same>
std::vector<std::size_t> columns_where(const table::Header& header, const Same& same) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < header.names.size(); ++i) {
    if (same(header.names[i])) found.push_back(i);
  }
  return found;
}

/// The index that "#3" means in a table with `count` columns.
std::optional<std::size_t> numbered(const std::string& name, std::size_t count) {
  if (!name.starts_with('#')) return std::nullopt;
  std::size_t number = 0;
  const char* end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + 1, end, number);
  if (read.ec != std::errc{} || read.ptr != end || number < 1 || number > count)
    return std::nullopt;
  return number - 1;
}

std::string remedy_for(const table::Header& header, const std::string& theirs) {
  const std::string all = columns_remedy(header);
  const auto meant = nearest(theirs, header.names);
  return meant ? fmt::format("did you mean '{}'? {}", *meant, all) : all;
}

}  // namespace

std::size_t find_column(const table::Header& header, const std::string& ours,
                        const std::string& theirs) {
  auto found = columns_where(header, [&](const std::string& name) { return name == theirs; });
  if (found.empty()) {
    if (const auto column = numbered(theirs, header.names.size())) return *column;
    const std::string small = to_lower(theirs);
    found = columns_where(header, [&](const std::string& name) { return to_lower(name) == small; });
  }
  if (found.empty()) {
    throw ColumnError(header.file, ours, fmt::format("it has no column '{}' for {}", theirs, ours),
                      remedy_for(header, theirs));
  }
  if (found.size() == 1) return found.front();
  throw ColumnError(header.file, ours,
                    fmt::format("it has {} columns '{}' (for {})", found.size(), theirs, ours),
                    fmt::format("#{} or #{} is meant", found[0] + 1, found[1] + 1));
}

std::string name_for(const table::Header& header, std::size_t column) {
  const std::string& name = header.names[column];
  const bool is_unique = std::ranges::count(header.names, name) == 1;
  return is_unique && !name.empty() ? name : fmt::format("#{}", column + 1);
}

}  // namespace twrench::recording
