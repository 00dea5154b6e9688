#include "table/ardupilot_log.h"

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "system/error.h"
#include "table/dialect.h"
#include "table/line_reader.h"

namespace twrench::table {
namespace {

using Cells = std::vector<std::string_view>;

/// A kind of messages: its name, and the place of the number of its sensor, if it has one.
struct Messages {
  std::string name;
  std::size_t sensor = 0;
};

/// The kinds whose columns are named: FMT, 64, 35, ATT, QccccCCCCB, TimeUS,DesRoll,Roll ...
constexpr std::size_t name_in_format = 3, first_column_in_format = 5;

/// The first of the kinds that are read of which the log has a message.
Messages messages_in(const Input& input) {
  std::vector<Messages> formats;
  std::vector<std::string> there;
  LineReader lines(input);
  Cells cells;
  for (std::string_view line; lines.next(line);) {
    split_cells(line, ',', cells);
    if (cells.front() == "FMT" && cells.size() > first_column_in_format) {
      const auto sensor = std::ranges::find(cells, "I") - cells.begin();
      const bool has_sensor = static_cast<std::size_t>(sensor) < cells.size();
      formats.push_back(
          {std::string(cells[name_in_format]),
           has_sensor ? static_cast<std::size_t>(sensor) - first_column_in_format + 1 : 0});
    } else if (std::ranges::find(there, cells.front()) == there.end()) {
      there.emplace_back(cells.front());
    }
  }
  for (const char* name : {"ATT", "IMU", "GYR"}) {
    const auto format = std::ranges::find(formats, name, &Messages::name);
    const bool is_there = std::ranges::find(there, name) != there.end();
    if (is_there && format != formats.end()) return *format;
  }
  throw system::FileError(input.name(), "this log of ArduPilot has no messages ATT, IMU or GYR",
                          "log attitudes or rates: LOG_BITMASK");
}

/// The text behind so many commas.
std::string_view after_commas(std::string_view line, std::size_t count) {
  for (; count > 0; --count) line.remove_prefix(std::min(line.find(',') + 1, line.size()));
  return line;
}

}  // namespace

bool is_of_ardupilot(std::string_view start) {
  return start.starts_with("FMT, ") || start.starts_with("FMT,128,");
}

Input table_of_ardupilot(const Input& input) {
  const Messages messages = messages_in(input);
  auto text = std::make_shared<std::string>();
  std::string sensor;
  LineReader lines(input);
  Cells cells;
  for (std::string_view line; lines.next(line);) {
    split_cells(line, ',', cells);
    const bool is_format = cells.front() == "FMT" && cells.size() > first_column_in_format &&
                           cells[name_in_format] == messages.name;
    const bool is_message = cells.front() == messages.name && messages.sensor < cells.size();
    if (is_message && sensor.empty()) sensor = cells[messages.sensor];
    if (is_format) {
      *text += after_commas(line, first_column_in_format);
    } else if (is_message && cells[messages.sensor] == sensor) {
      *text += after_commas(line, 1);
    } else {
      *text += '#';
    }
    *text += '\n';
  }
  return {input.name(), std::shared_ptr<const std::string>(std::move(text))};
}

}  // namespace twrench::table
