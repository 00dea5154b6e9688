#include "table/aem_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "system/error.h"

namespace twrench::table {
namespace {

std::string value_of(const AemSegment& segment, const std::string& keyword) {
  const auto found = segment.metadata.find(keyword);
  return found == segment.metadata.end() ? std::string() : found->second;
}

/// Whether the name of a frame is that of a spacecraft or one of its parts.
bool is_of_body(std::string_view frame) {
  constexpr std::array<std::string_view, 15> parts{
      "SC_", "BODY", "INSTRUMENT", "STARTRACKER", "STAR_TRACKER", "GYRO", "ACTUATOR",  "CSS",
      "DSS", "ESA",  "IMU_FRAME",  "SENSOR",      "TAM",          "ACC_", "SPACECRAFT"};
  return std::ranges::any_of(parts, [&](std::string_view part) { return frame.starts_with(part); });
}

/// Whether REF_FRAME_A rather than REF_FRAME_B is that of the body.
bool is_body_first(const AemSegment& segment) {
  return is_of_body(value_of(segment, "REF_FRAME_A")) &&
         !is_of_body(value_of(segment, "REF_FRAME_B"));
}

/// Adds columns of the same unit.
void add_columns(Header& header, const std::vector<std::string>& names, const std::string& unit) {
  for (const std::string& name : names) {
    header.names.push_back(name);
    header.units.push_back(unit);
  }
}

system::FileError bad_metadata(const Header& header, const AemSegment& segment,
                               const std::string& why, const std::string& remedy) {
  return {fmt::format("{}:{}", header.file, segment.meta_start), why, remedy};
}

/// The four components in the file's order.
std::vector<std::string> quaternion_names(const AemSegment& segment, bool is_version_1,
                                          const Header& header) {
  const std::string order = value_of(segment, "QUATERNION_TYPE");
  if (order == "FIRST") return {"qw", "qx", "qy", "qz"};
  if (order == "LAST" || (order.empty() && !is_version_1)) return {"qx", "qy", "qz", "qw"};
  throw bad_metadata(header, segment,
                     order.empty() ? std::string("its metadata have no QUATERNION_TYPE")
                                   : fmt::format("its QUATERNION_TYPE is '{}'", order),
                     "add QUATERNION_TYPE = LAST or = FIRST below META_START, as its scalar is");
}

/// "321" or "ZYX" -> "zyx".
std::string sequence_of(const AemSegment& segment, const Header& header) {
  std::string sequence = value_of(segment, "EULER_ROT_SEQ");
  bool is_known = sequence.size() == 3;
  for (char& c : sequence) {
    const std::size_t axis = std::string_view("123XYZxyz").find(c);
    is_known = is_known && axis != std::string_view::npos;
    if (is_known) c = "xyz"[axis % 3];
  }
  if (is_known && sequence[0] != sequence[1] && sequence[1] != sequence[2]) return sequence;
  throw bad_metadata(header, segment,
                     fmt::format("its EULER_ROT_SEQ is '{}'", value_of(segment, "EULER_ROT_SEQ")),
                     "it must name three axes, such as 321 or ZYX");
}

/// The angles are in the order of the rotations.
std::vector<std::string> angle_names(const std::string& sequence) {
  if (sequence[0] == sequence[2]) return {"yaw", "pitch", "roll"};
  std::vector<std::string> names;
  constexpr std::array<const char*, 3> about{"roll", "pitch", "yaw"};
  for (const char axis : sequence)
    names.emplace_back(about.at(static_cast<std::size_t>(axis - 'x')));
  return names;
}

/// Angular velocities in deg/s, in the axes of the frame that the metadata name.
std::vector<std::string> rate_names(const AemSegment& segment) {
  std::string frame = value_of(segment, "RATE_FRAME");
  if (frame.empty()) frame = value_of(segment, "ANGVEL_FRAME");
  const std::string body = is_body_first(segment) ? "REF_FRAME_A" : "REF_FRAME_B";
  const bool is_in_body = frame.empty() || frame == body || frame == value_of(segment, body);
  if (is_in_body) return {"wx", "wy", "wz"};
  return {"omega_space_x", "omega_space_y", "omega_space_z"};
}

}  // namespace

void describe_aem_columns(const AemSegment& segment, bool is_version_1, Header& header) {
  std::string type = value_of(segment, "ATTITUDE_TYPE");
  std::ranges::replace(type, ' ', '/');
  add_columns(header, {"t"}, "s");
  const std::string form = type.substr(0, type.find('/'));
  const std::string derivative = type.substr(std::min(type.size(), form.size() + 1));
  if (form == "QUATERNION" && derivative != "DERIVATIVE") {
    add_columns(header, quaternion_names(segment, is_version_1, header), "");
  } else if (form == "QUATERNION") {
    const auto names = quaternion_names(segment, is_version_1, header);
    add_columns(header, names, "");
    for (const std::string& name : names) add_columns(header, {name + "_dot"}, "");
  } else if (form == "EULER_ANGLE" || type.starts_with("EULER/ANGLE")) {
    header.sequence = sequence_of(segment, header);
    add_columns(header, angle_names(header.sequence), "deg");
  }
  const bool has_rates = type.ends_with("/RATE") || type.ends_with("/ANGVEL");
  const bool has_euler_rates = form == "EULER_ANGLE" && derivative == "DERIVATIVE";
  if (has_rates) add_columns(header, rate_names(segment), "deg/s");
  if (has_euler_rates) add_columns(header, {"dot_1", "dot_2", "dot_3"}, "");
  const bool is_read =
      header.names.size() > 1 &&
      (derivative.empty() || has_rates || derivative == "DERIVATIVE" || type == "EULER/ANGLE");
  if (!is_read) {
    throw bad_metadata(header, segment,
                       type.empty() ? "its metadata have no ATTITUDE_TYPE"
                                    : fmt::format("its ATTITUDE_TYPE is {}, which is not read",
                                                  value_of(segment, "ATTITUDE_TYPE")),
                       "QUATERNION, EULER_ANGLE, and these with rates are read");
  }
  const std::string direction = value_of(segment, "ATTITUDE_DIR");
  if (!direction.empty() && direction != "A2B" && direction != "B2A") {
    throw bad_metadata(header, segment, fmt::format("its ATTITUDE_DIR is '{}'", direction),
                       "it must be A2B or B2A");
  }
  // An attitude from the frame of space to that of the body turns its axes into the body's, as X
  // does. Version 2.0 has no direction: it is from A to B.
  header.states_inverse = (direction == "B2A") != is_body_first(segment);
}

}  // namespace twrench::table
