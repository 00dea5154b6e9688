#include "base/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <sstream>

namespace twrench {

std::string to_lower(std::string_view text) {
  std::string small(text);
  for (char& c : small) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return small;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

namespace {

/// Returns the optimal string alignment distance: Levenshtein's distance with transpositions of
/// adjacent letters.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({change, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

}  // namespace

std::optional<std::string> nearest(std::string_view name, std::span<const std::string> candidates) {
  std::optional<std::string> best;
  std::size_t best_distance = 0;
  for (const std::string& candidate : candidates) {
    const std::size_t longer = std::max(name.size(), candidate.size());
    const std::size_t distance = edit_distance(to_lower(name), to_lower(candidate));
    // One letter in three may be wrong. Beyond that, it is a different word.
    if (distance > std::max<std::size_t>(1, longer / 3) || distance == longer) {
      continue;
    }
    const bool is_nearer = !best || distance < best_distance ||
                           (distance == best_distance && candidate.size() > best->size());
    if (is_nearer) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string list_of_names(std::span<const std::string> names) {
  constexpr std::size_t most = 3;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    const bool is_last = i > 0 && i + 1 == names.size();
    list += fmt::format("{}'{}'", i == 0 ? "" : is_last ? " and " : ", ", names[i]);
  }
  if (names.size() == most + 1) return fmt::format("{} and 1 other", list);
  return names.size() > most ? fmt::format("{} and {} others", list, names.size() - most) : list;
}

InvalidArgument unknown_name(const std::string& what, std::string_view name,
                             std::span<const std::string> candidates) {
  std::string remedy = fmt::format("one of: {}", fmt::join(candidates, ", "));
  if (const auto meant = nearest(name, candidates)) {
    remedy = fmt::format("did you mean '{}'? {}", *meant, remedy);
  }
  return {what, fmt::format("unknown name '{}'", name), remedy};
}

namespace {

// Control characters, which no text of ours contains otherwise.
constexpr char begins = '\x02', separates = '\x1f', ends = '\x03';

}  // namespace

std::string argument(std::string_view name, std::string_view value) {
  std::string mention{begins};
  mention.append(name).append(1, separates).append(value).append(1, ends);
  return mention;
}

std::string with_arguments(std::string_view text, const ArgumentWording& wording) {
  std::string worded;
  std::size_t begin = 0;
  while ((begin = text.find(begins)) != std::string_view::npos) {
    const std::size_t middle = text.find(separates, begin), end = text.find(ends, begin);
    if (end == std::string_view::npos || middle > end) break;
    worded.append(text.substr(0, begin));
    worded += wording(text.substr(begin + 1, middle - begin - 1),
                      text.substr(middle + 1, end - middle - 1));
    text.remove_prefix(end + 1);
  }
  return worded.append(text);
}

}  // namespace twrench
