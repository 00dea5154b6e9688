#include "table/json_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "table/line_reader.h"

namespace twrench::table {
namespace {

using Json = nlohmann::ordered_json;

/// Columns and tables may be nested this deep.
constexpr int most_levels = 3;

/// What is nested deeper is left out, because values are written recursively.
constexpr int most_depth = 16;

/// Whether the value is an array, or an object with the keys "0", "1", "2" ..., as of Pandas.
bool is_column(const Json& value) {
  if (value.is_array()) return true;
  if (!value.is_object() || value.empty()) return false;
  std::size_t i = 0;
  return std::ranges::all_of(value.items(),
                             [&](const auto& item) { return item.key() == std::to_string(i++); });
}

struct NamedColumn {
  std::string name;
  std::vector<const Json*> cells;
};

/// The columns of an object, and those of objects in it with names such as "omega.x".
void add_columns(const Json& object, const std::string& prefix, int levels,
                 std::vector<NamedColumn>& columns) {
  for (const auto& [name, value] : object.items()) {
    if (is_column(value)) {
      NamedColumn column{prefix + name, {}};
      for (const Json& cell : value) column.cells.push_back(&cell);
      columns.push_back(std::move(column));
    } else if (value.is_object() && levels > 1) {
      add_columns(value, prefix + name + '.', levels - 1, columns);
    }
  }
}

/// Rows of the longest columns that are at least two of the same length; empty if there are none.
std::string rows_of_columns(const Json& object) {
  std::vector<NamedColumn> columns;
  add_columns(object, "", most_levels, columns);
  std::map<std::size_t, int> counts;
  for (const NamedColumn& column : columns) ++counts[column.cells.size()];
  std::erase_if(counts, [](const auto& count) { return count.first < 2 || count.second < 2; });
  if (counts.empty()) return {};
  const std::size_t rows = counts.rbegin()->first;
  std::string text;
  for (std::size_t i = 0; i < rows; ++i) {
    Json row;
    for (const NamedColumn& column : columns) {
      if (column.cells.size() == rows) row[column.name] = *column.cells[i];
    }
    text += row.dump() + '\n';
  }
  return text;
}

/// The names of the components of a keyframe track of three.js.
std::vector<std::string> components_of_track(const Json& track) {
  const std::string name = track.value("name", "");
  if (name.ends_with(".quaternion")) return {"x", "y", "z", "w"};
  if (name.ends_with(".position") || name.ends_with(".scale")) return {"x", "y", "z"};
  return {};
}

bool are_numbers(const Json& array) {
  return array.is_array() &&
         std::ranges::all_of(array, [](const Json& value) { return value.is_number(); });
}

/// Whether the value is a track of known components, with its values in one flat array.
bool is_track(const Json& value) {
  if (!value.is_object() || !value.value("name", Json()).is_string()) return false;
  const Json times = value.value("times", Json()), values = value.value("values", Json());
  const std::size_t components = components_of_track(value).size();
  return components > 0 && are_numbers(times) && are_numbers(values) &&
         values.size() == components * times.size();
}

/// The rows of the tracks of three.js that have the times of the first quaternion; empty if there
/// is none.
std::string rows_of_tracks(const Json& object) {
  const Json tracks = object.value("tracks", Json());
  const auto is_quaternion = [](const Json& track) {
    return is_track(track) && components_of_track(track).size() == 4;
  };
  const auto first = std::ranges::find_if(tracks, is_quaternion);
  if (!tracks.is_array() || first == tracks.end()) return {};
  const Json& times = (*first)["times"];
  std::vector<const Json*> together;
  for (const Json& track : tracks) {
    if (is_track(track) && track["times"] == times) together.push_back(&track);
  }
  std::string text;
  for (std::size_t i = 0; i < times.size(); ++i) {
    Json row{{"time", times[i]}};
    for (const Json* const track : together) {
      const std::vector<std::string> components = components_of_track(*track);
      for (std::size_t k = 0; k < components.size(); ++k) {
        row[fmt::format("{}.{}", (*track)["name"].get<std::string>(), components[k])] =
            (*track)["values"][components.size() * i + k];
      }
    }
    text += row.dump() + '\n';
  }
  return text;
}

/// Pandas has the names of the columns beside rows of values.
bool are_names_of(const Json& names, const Json& row) {
  return names.is_array() && row.is_array() && names.size() == row.size() &&
         std::ranges::all_of(names, [](const Json& name) { return name.is_string(); });
}

/// The rows of an array; empty if it has none.
std::string rows_of_array(const Json& array, const Json& names) {
  const bool are_rows = !array.empty() && std::ranges::all_of(array, [](const Json& row) {
    return row.is_object() || row.is_array();
  });
  if (!are_rows) return {};
  std::string text;
  for (const Json& row : array) {
    if (are_names_of(names, row)) {
      Json named;
      for (std::size_t i = 0; i < row.size(); ++i) named[names[i].get<std::string>()] = row[i];
      text += named.dump() + '\n';
    } else {
      text += row.dump() + '\n';
    }
  }
  return text;
}

/// The rows in an object: its columns, or else those in the first member that has any.
std::string rows_in(const Json& object, int levels) {
  const Json names = object.value("columns", Json());
  const bool has_names = names.is_array() && !names.empty() && names[0].is_string();
  std::string rows = rows_of_tracks(object);
  if (rows.empty() && !has_names) rows = rows_of_columns(object);
  if (!rows.empty()) return rows;
  for (const auto& [name, value] : object.items()) {
    if (value.is_array()) rows = rows_of_array(value, names);
    if (value.is_object() && levels > 1) rows = rows_in(value, levels - 1);
    if (!rows.empty()) return rows;
  }
  return {};
}

}  // namespace

std::optional<JsonRows> rows_of_object(const Input& input) {
  constexpr std::size_t most = std::size_t{64} << 20;
  if (input.size() > most) return std::nullopt;
  std::string text(input.size(), '\0');
  input.read(0, text.data(), text.size());
  const auto is_flat = [](int depth, Json::parse_event_t, Json&) { return depth <= most_depth; };
  const Json object = Json::parse(text.begin() + static_cast<std::ptrdiff_t>(byte_order_mark(text)),
                                  text.end(), is_flat, false);
  if (!object.is_object()) return std::nullopt;
  auto rows = std::make_shared<std::string>(rows_in(object, most_levels));
  if (rows->empty()) return std::nullopt;
  JsonRows converted{{input.name(), std::shared_ptr<const std::string>(std::move(rows))}, {}};
  for (const auto& [name, value] : object.items()) {
    if (value.is_number()) converted.preamble.push_back(fmt::format("{}: {}", name, value.dump()));
  }
  return converted;
}

}  // namespace twrench::table
