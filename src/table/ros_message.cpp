#include "table/ros_message.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "table/dialect.h"

namespace twrench::table {
namespace {

constexpr std::size_t numbers_in_covariance = 9;

void add_components(const std::string& name, std::string_view components,
                    std::vector<std::string>& names) {
  for (const char component : components) names.push_back(fmt::format("{}.{}", name, component));
}

void add_covariance(const std::string& name, std::vector<std::string>& names) {
  for (std::size_t i = 0; i < numbers_in_covariance; ++i)
    names.push_back(fmt::format("{}_covariance[{}]", name, i));
}

const std::vector<std::string>& names_of_ros_header() {
  static const std::vector<std::string> names{"header.stamp.sec", "header.stamp.nanosec",
                                              "header.frame_id"};
  return names;
}

std::vector<std::string> names_of_imu() {
  std::vector<std::string> names = names_of_ros_header();
  add_components("orientation", "xyzw", names);
  add_covariance("orientation", names);
  for (const char* vector : {"angular_velocity", "linear_acceleration"}) {
    add_components(vector, "xyz", names);
    add_covariance(vector, names);
  }
  return names;
}

std::vector<std::string> names_of_pose() {
  std::vector<std::string> names = names_of_ros_header();
  add_components("pose.position", "xyz", names);
  add_components("pose.orientation", "xyzw", names);
  return names;
}

bool is_whole(std::string_view cell) {
  return !cell.empty() && cell.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::vector<std::string> names_of_ros_message(std::span<const std::string_view> row) {
  static const std::array messages{names_of_imu(), names_of_pose()};
  const auto* const names =
      std::ranges::find(messages, row.size(), &std::vector<std::string>::size);
  if (names == messages.end()) return {};
  constexpr std::size_t digits_of_nanoseconds = 9;
  const bool begins_with_header = is_whole(row[0]) && is_whole(row[1]) &&
                                  row[1].size() <= digits_of_nanoseconds && !is_numeric(row[2]);
  const bool has_numbers =
      std::ranges::all_of(row.subspan(names_of_ros_header().size()), is_numeric);
  return begins_with_header && has_numbers ? *names : std::vector<std::string>();
}

}  // namespace twrench::table
