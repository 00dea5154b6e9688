#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "recording/conventions/body_axes.h"
#include "recording/conventions/names.h"

namespace twrench::recording {

/// The unit of Euler angles, and of rotation vectors and their angles.
enum class Angle { radians, degrees };

/// The unit of angular rates.
enum class RateUnit { rad_s, deg_s, rev_s, rpm };

/// The unit of times.
enum class TimeUnit { s, ms, us, ns, min, h, d, tenth_ms };

/// How a file writes the attitude. A rotation vector is the axis times the angle. The (classical)
/// Rodrigues parameters are the axis times tan(angle/2), the modified ones (MRP) times
/// tan(angle/4).
enum class AttitudeForm {
  none,
  matrix,
  quaternion,
  euler,
  rotation_vector,
  axis_angle,
  mrp,
  rodrigues
};

/// How to interpret the columns of a file.
struct Convention {
  /// Our name ("t", "wx", "x11", "qw", "yaw") -> the column's name in the file, or "#3" for the
  /// third.
  std::map<std::string, std::string> columns;
  /// Seconds if absent.
  std::optional<TimeUnit> time_unit;
  /// The unit of the rates; rad/s if absent.
  std::optional<RateUnit> rate_unit;
  /// The unit of angles. If absent, it is that of the rates, or radians.
  std::optional<Angle> angle_unit;
  /// The names of the fields of those units that the file itself states, which no argument may
  /// contradict.
  std::set<std::string> stated_units = {};
  /// The axes of Euler angles in the order of the rotations, each as turned by the rotations before
  /// (intrinsic). "zyx": yaw about z first, then pitch about y, then roll about x. May be empty if
  /// there are no Euler angles.
  std::string sequence;
  /// Our name of the component of the quaternion that has the wrong sign in the file, "qx", "qy" or
  /// "qz"; empty if there is none. (All components but the scalar have it in the inverse.)
  std::string negated = {};
  /// The inertia of the body about its own axes, which turns columns of angular momentum into
  /// rates; unused without them.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();
  bool inverse_is_stated = false;  ///< by the file itself
  bool inverse = false;            ///< the attitude is body_from_space
  /// Whether the rates or the angular momentum are in space axes, not in the body's.
  bool rates_in_space = false;
  /// The body's axes along which the file's axes point.
  BodyAxes axes;
  /// If present, the attitude is that of a part; this rotation takes the part's axes to the file's
  /// axes of the body.
  std::optional<Eigen::Quaterniond> offset;
};

/// The given units, or the defaults.
TimeUnit time_unit(const Convention& convention);
RateUnit rate_unit(const Convention& convention);
Angle angle_unit(const Convention& convention);

/// The sequences of Euler angles: the six that turn about three different axes, then the others.
const std::vector<std::string>& all_sequences();

/// Returns the sequence in lower case. Throws InvalidArgument about `quantity` unless it is one of
/// the twelve.
std::string parse_sequence(std::string_view text, const std::string& quantity);

/// The kind of the columns of a form; nothing for `none`.
std::optional<Kind> kind_of(AttitudeForm form);

/// The form whose columns the convention has.
AttitudeForm attitude_form(const Convention& convention);

/// Whether the numbers of this form have a unit of angles.
bool has_angles(AttitudeForm form);

/// Whether the convention has columns of angular momentum.
bool has_momentum(const Convention& convention);

/// Whether the convention has columns of rates, or of the angular momentum that determines them.
bool has_rates(const Convention& convention);

/// The value of a field: whether a flag is set, a word (empty if there is none), our names and the
/// file's, or a rotation; the first alternative means that there is no rotation.
using FieldValue = std::variant<std::monostate, bool, std::string,
                                std::map<std::string, std::string>, Eigen::Quaterniond>;

/// How users give a field.
enum class FieldForm { flag, text, rotation, unasked };

/// A field of Convention. The options of the program, the arguments of Python, the reports and the
/// search for other conventions all follow from the table of the fields.
struct Field {
  const char* name;  ///< of the argument, and in the JSON: "angle_units"
  FieldForm form;
  std::string help;
  const char* placeholder;         ///< for the value, in the help
  const char* otherwise;           ///< what holds if it is not given; may be empty
  std::vector<std::string> words;  ///< the only ones allowed; empty if there is no such list

  std::function<FieldValue(const Convention&)> value;
  /// Throws InvalidArgument about the argument of this name. Empty if users are not asked.
  std::function<void(Convention&, const FieldValue&)> set;
  /// Says what the field means, such as "the rates are in deg/s".
  std::function<std::string(const Convention&)> statement;
};

/// All fields, in the order in which users read them.
const std::vector<Field>& convention_fields();

/// Whether both have the same value in this field. Rotations may differ by rounding.
bool agree(const Field& field, const Convention& a, const Convention& b);

/// Mentions the argument that gives the field the value that it has in the convention:
/// `--angle-units deg`. Empty for a flag that is not set, for no value, and if users are not asked.
std::string mention(const Field& field, const Convention& convention);

/// Whether the second convention has another unit than the file states in the first.
bool contradicts_file(const Convention& before, const Convention& after);

/// The arguments that change the first convention into the second: `--units deg --inverse`. There
/// is none for a unit that contradicts the file.
std::string changing_arguments(const Convention& before, const Convention& after);

}  // namespace twrench::recording
