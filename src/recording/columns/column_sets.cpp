#include "recording/columns/column_sets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/words.h"
#include "recording/columns/column_words.h"
#include "recording/columns/columns.h"
#include "recording/columns/stated_unit.h"

namespace twrench::recording {
namespace {

/// The columns of one group, by component.
struct Group {
  std::vector<std::vector<std::size_t>> columns;
  bool in_space = false, is_open = false, is_weak = false;
};

std::size_t present(const Group& group) {
  return static_cast<std::size_t>(
      std::ranges::count_if(group.columns, [](const auto& of_one) { return !of_one.empty(); }));
}

bool is_complete(const Group& group) { return present(group) == group.columns.size(); }

/// Throws if two columns could be the same component.
std::vector<std::size_t> require_single(const table::Header& header, Kind kind,
                                        const Group& group) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < group.columns.size(); ++i) {
    const std::vector<std::size_t>& of_one = group.columns[i];
    if (of_one.size() > 1) {
      const std::string& ours = names_of(kind)[i];
      throw ColumnError(header.file, ours,
                        fmt::format("two columns could be {}: '{}' (#{}) and '{}' (#{})", ours,
                                    header.names[of_one[0]], of_one[0] + 1, header.names[of_one[1]],
                                    of_one[1] + 1),
                        fmt::format("#{} or #{} is meant", of_one[0] + 1, of_one[1] + 1));
    }
    columns.push_back(of_one.front());
  }
  return columns;
}

/// The columns that have our own names. A T in a file with other times is a temperature.
Group find_ours(const table::Header& header, Kind kind) {
  Group group;
  for (const std::string& name : names_of(kind)) {
    std::vector<std::size_t>& of_one = group.columns.emplace_back();
    for (std::size_t column = 0; column < header.names.size(); ++column) {
      const std::string& theirs = header.names[column];
      if (theirs == name || (to_lower(theirs) == name && theirs != "T")) of_one.push_back(column);
    }
  }
  return group;
}

/// A vector whose length shows where it has a quaternion or rates: the state of a simulator.
struct StateVector {
  std::string_view name;
  std::size_t size;
  Kind kind;
  std::size_t first;  ///< the index of the first number
  bool is_open = false, in_space = false;
};

/// MuJoCo's free and ball joints, whose rates are about the body's axes, and the root of Isaac,
/// whose rates are about those of space.
constexpr std::array<StateVector, 8> state_vectors{
    {{"qpos", 7, Kind::quaternion, 3},
     {"qpos", 4, Kind::quaternion, 0},
     {"qvel", 6, Kind::rates, 3},
     {"qvel", 3, Kind::rates, 0},
     {"root_state", 13, Kind::quaternion, 3, true},
     {"root_states", 13, Kind::quaternion, 3, true},
     {"root_state", 13, Kind::rates, 10, false, true},
     {"root_states", 13, Kind::rates, 10, false, true}}};

/// The columns of a state vector, in order: "qpos_0", "qpos[1]", "data.qpos2" ...
std::vector<std::size_t> columns_of_vector(const table::Header& header, std::string_view name) {
  const std::vector<std::string> stem = words_of(name);
  std::vector<std::size_t> columns;
  for (std::size_t column = 0; column < header.names.size(); ++column) {
    std::vector<std::string> words = words_of(header.names[column]);
    if (words.size() <= stem.size()) continue;
    const bool is_numbered = words.back().find_first_not_of("0123456789") == std::string::npos;
    words.pop_back();
    const bool is_of_vector = std::equal(stem.rbegin(), stem.rend(), words.rbegin());
    if (is_numbered && is_of_vector) columns.push_back(column);
  }
  return columns;
}

std::vector<ColumnSet> sets_of_vectors(const table::Header& header, Kind kind) {
  std::vector<ColumnSet> sets;
  for (const StateVector& vector : state_vectors) {
    if (vector.kind != kind) continue;
    const std::vector<std::size_t> all = columns_of_vector(header, vector.name);
    if (all.size() != vector.size) continue;
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(vector.first);
    const ColumnSet set{
        kind, {first, first + static_cast<std::ptrdiff_t>(names_of(kind).size())}, vector.in_space};
    if (!vector.is_open) sets.push_back(set);
    if (vector.is_open) std::ranges::move(orders_of(kind, set.columns), std::back_inserter(sets));
  }
  return sets;
}

/// The name, and a unit of rates or times in the row below it as if it were a part of it.
std::string name_with_unit(const table::Header& header, std::size_t column) {
  const std::string& name = header.names[column];
  if (column >= header.units.size()) return name;
  const StatedUnit unit = stated_unit(words_of(header.units[column]));
  const bool is_needed = (unit.is_per_second || unit.time) && unit.other_words.empty() &&
                         stated_unit(words_of(name)).unread.empty();
  return is_needed ? fmt::format("{} ({})", name, header.units[column]) : name;
}

/// Calendar times and times that follow from other columns are times whatever their names are.
std::map<std::string, Group> find_times(const table::Header& header) {
  std::map<std::string, Group> groups;
  std::set<std::size_t> sources;
  for (std::size_t column = 0; column < header.sources.size(); ++column) {
    for (const std::size_t source : header.sources[column]) {
      if (source != column) sources.insert(source);
    }
  }
  std::optional<std::size_t> of_frames;
  for (std::size_t column = 0; column < header.names.size(); ++column) {
    if (sources.contains(column)) continue;
    const table::Calendar calendar = header.calendar_of(column);
    const bool is_calendar =
        calendar == table::Calendar::date_time || calendar == table::Calendar::time_of_day;
    const std::size_t source_count = header.sources_of(column).size();
    if (source_count == 1) {
      of_frames = column;
    } else if (is_calendar || source_count > 1) {
      groups[fmt::format("#{}", column)].columns = {{column}};
    } else if (calendar == table::Calendar::none) {
      for (const Role& role : roles_of(name_with_unit(header, column), Kind::time)) {
        Group& group = groups[role.group];
        group.columns.resize(1);
        group.columns[0].push_back(column);
      }
    }
  }
  if (groups.empty() && of_frames) groups["frames"].columns = {{*of_frames}};
  // Pandas writes its index, which often is the time, in a first column without a name.
  const bool has_index = header.names.size() > 1 && header.names.front().empty();
  if (groups.empty() && has_index) groups["index"].columns = {{0}};
  return groups;
}

std::map<std::string, Group> find_groups(const table::Header& header, Kind kind) {
  if (kind == Kind::time) return find_times(header);
  std::map<std::string, Group> groups;
  for (std::size_t column = 0; column < header.names.size(); ++column) {
    for (const Role& role : roles_of(name_with_unit(header, column), kind)) {
      Group& group = groups[role.group];
      group.columns.resize(names_of(kind).size());
      group.columns[role.component].push_back(column);
      group.in_space = role.in_space;
      group.is_open = role.is_open;
      group.is_weak = role.is_weak;
    }
  }
  return groups;
}

/// Throws if most of a group is present and the rest is missing: it was probably forgotten, or its
/// names are written differently.
void require_no_rest(const table::Header& header, Kind kind,
                     const std::map<std::string, Group>& groups) {
  const std::size_t all = names_of(kind).size();
  const std::size_t most = all == 9 ? 6 : all - 1;
  for (const auto& [name, group] : groups) {
    // Single letters and numbers often mean something else, so they are no evidence.
    const bool is_evidence = !group.is_open && !group.is_weak && !name.starts_with("pqr") &&
                             !name.starts_with("0") && !name.starts_with("1") &&
                             !name.starts_with("one");
    if (all == 1 || !is_evidence || present(group) < most) continue;
    std::vector<std::string> found;
    std::string missing;
    for (std::size_t i = 0; i < all; ++i) {
      const auto& of_one = group.columns[i];
      if (of_one.empty()) missing = names_of(kind)[i];
      if (!of_one.empty()) found.push_back("'" + header.names[of_one.front()] + "'");
    }
    throw ColumnError(header.file, missing,
                      fmt::format("it has {}, but nothing for {}", fmt::join(found, ", "), missing),
                      columns_remedy(header));
  }
}

using Words = std::vector<std::string>;

/// The columns whose names have no other words than those of the components, if there are all.
std::optional<ColumnSet> find_bare_set(const table::Header& header, Kind kind,
                                       const std::vector<Words>& components) {
  Group group;
  for (const Words& words : components) {
    std::vector<std::size_t>& of_one = group.columns.emplace_back();
    for (std::size_t column = 0; column < header.names.size(); ++column) {
      if (words_of(header.names[column]) == words) of_one.push_back(column);
    }
  }
  if (!is_complete(group)) return std::nullopt;
  return ColumnSet{kind, require_single(header, kind, group)};
}

}  // namespace

std::vector<ColumnSet> orders_of(Kind kind, const std::vector<std::size_t>& columns) {
  std::vector<ColumnSet> sets{{kind, columns}};
  if (kind == Kind::quaternion) {
    sets.push_back({kind, {columns[3], columns[0], columns[1], columns[2]}});
  }
  if (kind == Kind::euler) sets.push_back({kind, {columns[2], columns[1], columns[0]}});
  if (kind == Kind::matrix) {
    std::vector<std::size_t> transposed;
    for (std::size_t i = 0; i < 9; ++i) transposed.push_back(columns[3 * (i % 3) + i / 3]);
    sets.push_back({kind, transposed});
  }
  return sets;
}

std::vector<ColumnSet> find_sets(const table::Header& header, Kind kind, Incomplete incomplete) {
  if (const Group ours = find_ours(header, kind); is_complete(ours)) {
    return {{kind, require_single(header, kind, ours), false}};
  }
  const std::map<std::string, Group> groups = find_groups(header, kind);
  std::vector<ColumnSet> sets = sets_of_vectors(header, kind);
  for (const auto& [name, group] : groups) {
    if (!is_complete(group)) continue;
    const std::vector<std::size_t> columns = require_single(header, kind, group);
    if (group.is_open) {
      for (ColumnSet& set : orders_of(kind, columns)) {
        set.is_weak = group.is_weak;
        sets.push_back(std::move(set));
      }
    } else {
      sets.push_back({kind, columns, group.in_space, group.is_weak});
    }
  }
  if (sets.empty() && incomplete == Incomplete::refused) require_no_rest(header, kind, groups);
  return sets;
}

std::vector<ColumnSet> find_bare_rates(const table::Header& header) {
  std::vector<ColumnSet> sets;
  for (const std::vector<Words>& components :
       std::vector<std::vector<Words>>{{{"x"}, {"y"}, {"z"}},
                                       {{"xyz", "0"}, {"xyz", "1"}, {"xyz", "2"}},
                                       {{"gx"}, {"gy"}, {"gz"}}}) {
    if (const auto set = find_bare_set(header, Kind::rates, components)) sets.push_back(*set);
  }
  return sets;
}

std::vector<ColumnSet> find_bare_quaternions(const table::Header& header) {
  const auto set = find_bare_set(header, Kind::quaternion, {{"w"}, {"x"}, {"y"}, {"z"}});
  return set ? std::vector{*set} : std::vector<ColumnSet>();
}

std::string columns_remedy(const table::Header& header) {
  constexpr std::size_t most = 60, longest = 60;
  std::vector<std::string> names;
  std::size_t more = 0;
  for (std::size_t column = 0; column < header.names.size(); ++column) {
    if (!header.sources_of(column).empty()) continue;
    if (names.size() == most) {
      ++more;
    } else {
      names.push_back(header.names[column].substr(0, longest));
    }
  }
  return fmt::format("its columns are: {}{}", fmt::join(names, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace twrench::recording
