#include "table/aem_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "system/error.h"

namespace twrench::table {
namespace {

/// The value in capital letters, because a message may have it in small ones.
std::string value_of(const AemMetadata& metadata, const std::string& keyword) {
  const auto found = metadata.values.find(keyword);
  std::string value = found == metadata.values.end() ? std::string() : found->second;
  for (char& c : value) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return value;
}

/// Whether the name of a frame is that of a spacecraft or one of its parts.
bool is_of_body(std::string_view frame) {
  constexpr std::array<std::string_view, 15> parts{
      "SC_", "BODY", "INSTRUMENT", "STARTRACKER", "STAR_TRACKER", "GYRO", "ACTUATOR",  "CSS",
      "DSS", "ESA",  "IMU_FRAME",  "SENSOR",      "TAM",          "ACC_", "SPACECRAFT"};
  return std::ranges::any_of(parts, [&](std::string_view part) { return frame.starts_with(part); });
}

/// Whether REF_FRAME_A rather than REF_FRAME_B is that of the body.
bool is_body_first(const AemMetadata& metadata) {
  return is_of_body(value_of(metadata, "REF_FRAME_A")) &&
         !is_of_body(value_of(metadata, "REF_FRAME_B"));
}

system::FileError bad_metadata(const AemMetadata& metadata, const std::string& why,
                               const std::string& remedy) {
  return {metadata.place, why, remedy};
}

void add_values(AemLayout& layout, const std::vector<std::string>& keywords,
                const std::vector<std::string>& columns, const std::string& unit) {
  for (std::size_t i = 0; i < keywords.size(); ++i)
    layout.values.push_back({keywords[i], columns[i], unit});
}

/// Whether the scalar is the first component. Version 2.0 has it last.
bool is_scalar_first(const AemMetadata& metadata) {
  const std::string order = value_of(metadata, "QUATERNION_TYPE");
  if (order == "FIRST") return true;
  if (order == "LAST" || (order.empty() && !metadata.is_version_1)) return false;
  throw bad_metadata(metadata,
                     order.empty() ? std::string("its metadata have no QUATERNION_TYPE")
                                   : fmt::format("its QUATERNION_TYPE is '{}'", order),
                     "add QUATERNION_TYPE = LAST or = FIRST to the metadata, as its scalar is");
}

void add_quaternion(const AemMetadata& metadata, bool has_derivative, AemLayout& layout) {
  std::vector<std::string> keywords{"Q1", "Q2", "Q3", "QC"}, columns{"qx", "qy", "qz", "qw"};
  if (is_scalar_first(metadata)) {
    std::ranges::rotate(keywords, keywords.end() - 1);
    std::ranges::rotate(columns, columns.end() - 1);
  }
  add_values(layout, keywords, columns, "");
  if (!has_derivative) return;
  for (std::string& keyword : keywords) keyword += "_DOT";
  for (std::string& column : columns) column += "_dot";
  add_values(layout, keywords, columns, "1/s");
}

/// "321" or "ZYX" -> "zyx".
std::string sequence_of(const AemMetadata& metadata) {
  const std::string stated = value_of(metadata, "EULER_ROT_SEQ");
  std::string sequence = stated;
  bool is_known = sequence.size() == 3;
  for (char& c : sequence) {
    const std::size_t axis = std::string_view("123XYZ").find(c);
    is_known = is_known && axis != std::string_view::npos;
    if (is_known) c = "xyz"[axis % 3];
  }
  if (is_known && sequence[0] != sequence[1] && sequence[1] != sequence[2]) return sequence;
  throw bad_metadata(metadata, fmt::format("its EULER_ROT_SEQ is '{}'", stated),
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

void add_euler_angles(const AemMetadata& metadata, bool has_derivative, AemLayout& layout) {
  layout.sequence = sequence_of(metadata);
  add_values(layout, {"ANGLE_1", "ANGLE_2", "ANGLE_3"}, angle_names(layout.sequence), "deg");
  if (!has_derivative) return;
  add_values(layout, {"ANGLE_1_DOT", "ANGLE_2_DOT", "ANGLE_3_DOT"},
             {"angle_1_dot", "angle_2_dot", "angle_3_dot"}, "deg/s");
}

/// The attitude is reached from frame A, which must be that of space, by rotations of
/// SPIN_ALPHA + 90, 90 - SPIN_DELTA and SPIN_ANGLE degrees about z, x and z.
void add_spin(const AemMetadata& metadata, std::string_view nutation, AemLayout& layout) {
  if (is_body_first(metadata)) {
    throw bad_metadata(metadata, "its spin axis is given in the frame of the body",
                       "REF_FRAME_A must be the frame of space, and REF_FRAME_B that of the body");
  }
  layout.sequence = "zxz";
  layout.values.push_back({"SPIN_ALPHA", "yaw", "deg", 1, 90});
  layout.values.push_back({"SPIN_DELTA", "pitch", "deg", -1, 90});
  layout.values.push_back({"SPIN_ANGLE", "roll", "deg"});
  layout.values.push_back({"SPIN_ANGLE_VEL", "spin_angle_vel", "deg/s"});
  if (nutation == "NUTATION") {
    layout.values.push_back({"NUTATION", "nutation", "deg"});
    layout.values.push_back({"NUTATION_PER", "nutation_per", "s"});
    layout.values.push_back({"NUTATION_PHASE", "nutation_phase", "deg"});
  }
  if (nutation == "NUTATION_MOM") {
    layout.values.push_back({"MOMENTUM_ALPHA", "momentum_alpha", "deg"});
    layout.values.push_back({"MOMENTUM_DELTA", "momentum_delta", "deg"});
    layout.values.push_back({"NUTATION_VEL", "nutation_vel", "deg/s"});
  }
}

/// Whether angular velocities are in the axes of space; nothing if their frame is neither.
std::optional<bool> are_in_space(const AemMetadata& metadata) {
  std::string frame = value_of(metadata, "ANGVEL_FRAME");
  if (frame.empty()) frame = value_of(metadata, "RATE_FRAME");
  const auto is_frame = [&](const std::string& keyword) {
    return frame == keyword || frame == value_of(metadata, keyword);
  };
  const bool is_first = is_body_first(metadata);
  if (frame.empty() || is_frame(is_first ? "REF_FRAME_A" : "REF_FRAME_B")) return false;
  if (is_frame(is_first ? "REF_FRAME_B" : "REF_FRAME_A")) return true;
  return std::nullopt;
}

/// Version 2.0 defines angular velocities as those of frame B relative to A. The rates of version
/// 1.0 may be derivatives of Euler angles as well, and their sign is open if the attitude leads
/// from the body to space.
void add_rates(const AemMetadata& metadata, bool is_angular_velocity, AemLayout& layout) {
  const auto in_space = are_in_space(metadata);
  const bool may_be_derivative =
      !is_angular_velocity &&
      (!value_of(metadata, "EULER_ROT_SEQ").empty() || layout.states_inverse);
  std::vector<std::string> columns{"wx", "wy", "wz"};
  if (in_space && *in_space) columns = {"omega_space_x", "omega_space_y", "omega_space_z"};
  if (!in_space || may_be_derivative) columns = {"rate_of_1", "rate_of_2", "rate_of_3"};
  const std::size_t first = layout.values.size();
  if (is_angular_velocity) {
    add_values(layout, {"ANGVEL_X", "ANGVEL_Y", "ANGVEL_Z"}, columns, "deg/s");
  } else {
    add_values(layout, {"X_RATE", "Y_RATE", "Z_RATE"}, columns, "deg/s");
  }
  if (!is_angular_velocity || !is_body_first(metadata)) return;
  for (std::size_t i = first; i < layout.values.size(); ++i) layout.values[i].sign = -1;
}

/// An attitude from the frame of space to that of the body turns its axes into the body's, as X
/// does. Version 2.0 has no direction: it is from A to B.
bool is_inverse(const AemMetadata& metadata) {
  const std::string direction = value_of(metadata, "ATTITUDE_DIR");
  if (!direction.empty() && direction != "A2B" && direction != "B2A") {
    throw bad_metadata(metadata, fmt::format("its ATTITUDE_DIR is '{}'", direction),
                       "it must be A2B or B2A");
  }
  return (direction == "B2A") != is_body_first(metadata);
}

}  // namespace

AemLayout aem_layout(const AemMetadata& metadata) {
  std::string type = value_of(metadata, "ATTITUDE_TYPE");
  std::ranges::replace(type, ' ', '_');
  const std::string form = type.substr(0, type.find('/'));
  const std::string more = type.substr(std::min(type.size(), form.size() + 1));
  const bool has_derivative = more == "DERIVATIVE", has_velocity = more == "ANGVEL";
  const bool has_rates = has_velocity || more == "RATE";
  const bool is_plain = more.empty() || has_derivative || has_rates;
  AemLayout layout;
  layout.states_inverse = is_inverse(metadata);
  if (form == "QUATERNION" && is_plain) {
    add_quaternion(metadata, has_derivative, layout);
  } else if (form == "EULER_ANGLE" && is_plain) {
    add_euler_angles(metadata, has_derivative, layout);
  } else if (form == "SPIN" && (more.empty() || more == "NUTATION" || more == "NUTATION_MOM")) {
    add_spin(metadata, more, layout);
    layout.states_inverse = false;
  } else {
    throw bad_metadata(metadata,
                       type.empty()
                           ? "its metadata have no ATTITUDE_TYPE"
                           : fmt::format("its ATTITUDE_TYPE is {}, which is not read", type),
                       "QUATERNION, EULER_ANGLE and SPIN are read, also with rates or nutation");
  }
  if (has_rates) add_rates(metadata, has_velocity, layout);
  return layout;
}

}  // namespace twrench::table
