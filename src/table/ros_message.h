#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::table {

/// The names of the columns of `ros2 topic echo --csv`, which writes none, if this row is one of
/// sensor_msgs/Imu or geometry_msgs/PoseStamped: it has as many cells, and begins with the seconds,
/// the nanoseconds and the name of the frame. Otherwise empty.
std::vector<std::string> names_of_ros_message(std::span<const std::string_view> row);

}  // namespace twrench::table
