#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/body_axes.h"
#include "table/error.h"
#include "table/reader.h"

namespace twrench::check {

/// The unit of Euler angles.
enum class Angle { radians, degrees };

/// The unit of angular rates.
enum class RateUnit { rad_s, deg_s, rev_s, rpm };

/// The unit of times.
enum class TimeUnit { s, ms, us, ns, min, h };

/// How a file writes the attitude.
enum class AttitudeForm { none, matrix, quaternion, euler };

/// How the columns of a file are meant.
struct Convention {
  /// Our name ("t", "wx", "x11", "qw", "yaw") -> the column's name in the file, or "#3" for the
  /// third.
  std::map<std::string, std::string> columns;
  /// Seconds if absent.
  std::optional<TimeUnit> time_unit;
  /// The unit of the rates; rad/s if absent.
  std::optional<RateUnit> rate_unit;
  /// The unit of Euler angles. If absent, it is that of the rates, or radians.
  std::optional<Angle> angle_unit;
  /// Of Euler angles: the axes in the order of the rotations, each about the axes as they are then
  /// (intrinsic). "zyx": yaw about z first, then pitch about y, then roll about x. May be empty
  /// where there are none.
  std::string sequence;
  bool inverse = false;         ///< the attitude is body_from_space
  bool rates_in_space = false;  ///< the rates are in space axes, not in the body's
  /// The body's axes along which the file's axes point.
  BodyAxes axes;
  /// What the attitude is that of: a part whose axes this takes to the file's axes of the body.
  std::optional<Eigen::Quaterniond> offset;
};

/// In which they are read.
TimeUnit time_unit(const Convention& convention);
RateUnit rate_unit(const Convention& convention);
Angle angle_unit(const Convention& convention);

/// The columns that are wanted do not fit those that the file has: one is missing, given twice, or
/// left open. The remedy lists the file's columns.
class ColumnError : public table::BadTable {
 public:
  /// `column` is ours ("wz"), or empty where it is no single one.
  ColumnError(const std::string& file, std::string column, const std::string& why,
              const std::string& remedy)
      : BadTable(file, why, remedy), column_(std::move(column)) {}

  const std::string& column() const noexcept { return column_; }

 private:
  std::string column_;
};

/// Reads "t=time,wx=p,wy=q" into Convention::columns. Names of the file with a comma, '=' or spaces
/// at their ends stand in double quotes ("" for a quote in them): wx="rate, x". Throws
/// InvalidArgument about `quantity` for a name on the left that is none of ours or is there twice.
std::map<std::string, std::string> parse_columns(std::string_view text,
                                                 const std::string& quantity);

/// The inverse of parse_columns, t first and the others in the order of their kinds.
std::string format_columns(const std::map<std::string, std::string>& columns);

/// The sequences of Euler angles: the six that turn about three different axes, then the others.
const std::vector<std::string>& all_sequences();

/// Returns the sequence in small letters. Throws InvalidArgument about `quantity` unless it is one
/// of the twelve.
std::string parse_sequence(std::string_view text, const std::string& quantity);

/// Returns every convention that the names of the columns leave open, given what was said: one
/// where nothing is ambiguous, which then has all its columns. Where columns of rates or of an
/// attitude are said, no others are looked for, but for the time. Of Euler angles without a
/// sequence all six that turn about three different axes are returned. Throws ColumnError for a
/// column that the file has not, for a time, a rate or a component that is missing, and where there
/// are neither rates nor an attitude; BadTable where the file states another unit than was said.
std::vector<Convention> conventions(const table::Header& header, const Convention& said);

/// The form whose columns the convention has.
AttitudeForm attitude_form(const Convention& convention);

/// Whether the convention has columns of rates.
bool has_rates(const Convention& convention);

}  // namespace twrench::check
