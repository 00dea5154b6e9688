#include "check/random_recording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/enumeration.h"
#include "check/hypotheses/hypotheses.h"
#include "check/verdict/judge.h"
#include "recording/conventions/attitude.h"
#include "recording/conventions/names.h"
#include "recording/conventions/units.h"
#include "scene_dice.h"
#include "system/file.h"
#include "table/error.h"

namespace twrench::check {
namespace {

using recording::AttitudeForm;
using recording::Convention;
using recording::Kind;

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// How numbers are written; `floats` are the shortest decimals of a float, as NumPy prints them.
enum class Numbers { doubles, nine_digits, floats };

std::string written(double value, Numbers numbers) {
  switch (numbers) {
    case Numbers::doubles:
      return fmt::format("{:.17g}", value);
    case Numbers::nine_digits:
      return fmt::format("{:.9g}", value);
    case Numbers::floats:
      return fmt::format("{}", static_cast<float>(value));
  }
  return {};
}

Vector3d moments_of(RecordedBody body, SceneDice& dice) {
  switch (body) {
    case RecordedBody::t_wrench:
      return {982.27130302240869, 722.67103008077208, 1578.6503084288711};
    case RecordedBody::nearly_symmetric:
      return {2, 2.002, 3};
    case RecordedBody::toutatis:
      return {1.8389417888224342e26, 5.8684714781718553e25, 1.928153997104942e26};
    case RecordedBody::any:
      break;
  }
  // The moments of a box, so that the body is possible.
  const double a = dice.spread(0.2, 5), b = dice.spread(0.2, 5), c = dice.spread(0.2, 5);
  const double size = dice.spread(1e-10, 1e10);
  return size * Vector3d(b * b + c * c, a * a + c * c, a * a + b * b);
}

/// No component is so small that the motion is almost steady.
Vector3d random_omega(SceneDice& dice, double speed) {
  Vector3d omega;
  for (double& component : omega) component = (dice.chance(0.5) ? 1 : -1) * dice.uniform(0.25, 1);
  return speed * omega;
}

Quaterniond random_rotation(SceneDice& dice) {
  return Quaterniond(Eigen::AngleAxisd(dice.uniform(0.3, 3), dice.vector(-1, 1).normalized()));
}

/// The common part of all recordings of a body.
struct Motion {
  Vector3d moments, omega;
  std::size_t rows;
  double step;
};

Motion random_motion(RecordedBody body, SceneDice& dice) {
  const Vector3d moments = moments_of(body, dice);
  // Times in ns of a slower motion, taken for s, would exceed the limit of times.
  const double speed = body == RecordedBody::toutatis ? dice.spread(1e-6, 1e-4)
                       : body == RecordedBody::any    ? dice.spread(1e-3, 1e6)
                                                      : dice.spread(0.3, 30);
  const Vector3d omega = random_omega(dice, speed);
  // The motion covers a dozen to hundreds of rad.
  const auto rows = static_cast<std::size_t>(dice.whole(300, 900));
  return {moments, omega, rows, dice.spread(0.04, 0.4) / omega.norm()};
}

/// Our names of the columns, in the order in which they are written.
std::vector<std::string> names_in(AttitudeForm form, bool has_rates, bool has_momentum) {
  std::vector<std::string> names = names_of(Kind::time);
  const auto add = [&](Kind kind) {
    names.insert(names.end(), names_of(kind).begin(), names_of(kind).end());
  };
  if (has_rates) add(has_momentum ? Kind::momentum : Kind::rates);
  switch (form) {
    case AttitudeForm::none:
      break;
    case AttitudeForm::matrix:
      add(Kind::matrix);
      break;
    case AttitudeForm::quaternion:
      add(Kind::quaternion);
      break;
    case AttitudeForm::euler:
      add(Kind::euler);
      break;
    case AttitudeForm::rotation_vector:
      add(Kind::rotation_vector);
      break;
    case AttitudeForm::axis_angle:
      add(Kind::axis_angle);
      break;
    case AttitudeForm::mrp:
      add(Kind::mrp);
      break;
    case AttitudeForm::rodrigues:
      add(Kind::rodrigues);
      break;
  }
  return names;
}

std::map<std::string, std::string> columns_of(AttitudeForm form, bool has_rates,
                                              bool has_momentum = false) {
  std::map<std::string, std::string> columns;
  for (const std::string& name : names_in(form, has_rates, has_momentum)) columns[name] = name;
  return columns;
}

/// The angles of X about the axes of a sequence, in the order of the columns.
Vector3d euler_angles(const Matrix3d& X, const std::string& sequence) {
  const recording::Axes axes = recording::axes_of(sequence);
  const Vector3d angles = X.eulerAngles(axes[0], axes[1], axes[2]);
  Vector3d placed;
  const auto places = recording::angle_places(axes);
  for (std::size_t i = 0; i < 3; ++i)
    placed[static_cast<Eigen::Index>(places[i])] = angles[static_cast<Eigen::Index>(i)];
  return placed;
}

/// The numbers of an attitude, in the order of the columns above.
std::vector<double> attitude_numbers(const Matrix3d& X, const Convention& right) {
  switch (attitude_form(right)) {
    case AttitudeForm::none:
      return {};
    case AttitudeForm::matrix: {
      std::vector<double> entries;
      for (int i = 0; i < 9; ++i) entries.push_back(X(i / 3, i % 3));
      return entries;
    }
    case AttitudeForm::quaternion: {
      const Quaterniond q(X);
      return {q.w(), q.x(), q.y(), q.z()};
    }
    case AttitudeForm::euler: {
      const Vector3d angles = euler_angles(X, right.sequence) / name_of(angle_unit(right)).in_rad;
      return {angles[0], angles[1], angles[2]};
    }
    case AttitudeForm::rotation_vector: {
      const Vector3d v = so3::log(X) / name_of(angle_unit(right)).in_rad;
      return {v[0], v[1], v[2]};
    }
    case AttitudeForm::axis_angle: {
      const Eigen::AngleAxisd turn(X);
      const Vector3d& axis = turn.axis();
      return {axis[0], axis[1], axis[2], turn.angle() / name_of(angle_unit(right)).in_rad};
    }
    case AttitudeForm::mrp: {
      const Eigen::AngleAxisd turn(X);
      const Vector3d s = std::tan(turn.angle() / 4) * turn.axis();
      return {s[0], s[1], s[2]};
    }
    case AttitudeForm::rodrigues: {
      // hat(g) = (X - 1) (X + 1)^-1, Cayley's formula.
      const Matrix3d one = Matrix3d::Identity();
      const Vector3d g = so3::vee((X - one) * (X + one).inverse());
      return {g[0], g[1], g[2]};
    }
  }
  return {};
}

/// The names of the columns in the file, in its order.
std::vector<std::string> header_of(const Convention& right) {
  std::vector<std::string> header;
  for (const std::string& ours :
       names_in(attitude_form(right), has_rates(right), has_momentum(right))) {
    header.push_back(right.columns.at(ours));
  }
  return header;
}

/// Writes the motion in a convention: the inverse of RowDecoder, derived independently.
std::string text_of(const Motion& motion, const Convention& right, Numbers numbers, double noise,
                    SceneDice& dice) {
  const motion::ExactMotion exact({motion.moments.asDiagonal(), motion.omega});
  const bool rates = has_rates(right);
  std::string text = fmt::format("{}\n", fmt::join(header_of(right), ","));
  const Matrix3d P = right.axes.matrix();
  // Half turns, which axes alone may be, have no Rodrigues parameters.
  const bool turns_space = attitude_form(right) == AttitudeForm::rodrigues;
  const Matrix3d space = turns_space ? so3::exp({0.3, -0.5, 0.7}) : Matrix3d::Identity();
  for (std::size_t i = 0; i < motion.rows; ++i) {
    const double t = static_cast<double>(i) * motion.step;
    const motion::Sample sample = exact.at(t);
    Vector3d w = sample.omega;
    if (has_momentum(right)) w = motion.moments.cwiseProduct(w).eval();
    w = (P * w).eval();
    Matrix3d X = P.determinant() * space * sample.X * P.transpose();
    if (right.rates_in_space) w = (X * w).eval();
    if (right.offset) X = (X * right.offset->toRotationMatrix()).eval();
    if (right.inverse) X.transposeInPlace();
    text += fmt::format("{:.17g}", t / name_of(time_unit(right)).in_s);
    const double size = noise * motion.omega.norm();  // of rates
    for (int k = 0; k < 3 && rates; ++k) {
      // The sum of twelve uniform numbers is nearly normal.
      double error = -6;
      for (int n = 0; n < 12 && noise > 0; ++n) error += dice.uniform(0, 1);
      const double rate = w[k] + (noise > 0 ? size * error : 0);
      text += ',';
      text += written(rate / name_of(rate_unit(right)).in_rad_s, numbers);
    }
    for (const double number : attitude_numbers(X, right)) {
      text += ',';
      text += written(number, numbers);
    }
    text += '\n';
  }
  return text;
}

RandomRecording recording_of(const Motion& motion, const Convention& told, const Convention& right,
                             Numbers numbers, double noise, SceneDice& dice) {
  return {text_of(motion, right, numbers, noise, dice),
          told,
          right,
          {.inertia = motion.moments.asDiagonal()},
          {}};
}

/// Shifts the columns of the quaternion (w, x, y, z) by one place.
void move_scalar(Convention& convention) {
  auto& columns = convention.columns;
  const std::string w = columns["qw"];
  columns["qw"] = columns["qx"];
  columns["qx"] = columns["qy"];
  columns["qy"] = columns["qz"];
  columns["qz"] = w;
}

std::string description_of(const Convention& c) {
  return fmt::format("{} {} {} {} inverse {} space {} axes {} offset {} columns {}",
                     name_of(time_unit(c)).option, name_of(rate_unit(c)).option,
                     name_of(angle_unit(c)).option, c.sequence, c.inverse, c.rates_in_space,
                     format_body_axes(c.axes), c.offset.has_value(),
                     recording::format_columns(c.columns));
}

}  // namespace

const std::vector<std::string>& single_mistakes() {
  static const std::vector<std::string> all{
      "none",  "ms",     "us",          "min",   "deg",         "rpm",     "rev",
      "x,z,y", "-x,y,z", "left-handed", "y,z,x", "nine digits", "float32", "noise"};
  return all;
}

RandomRecording recording_with(std::string_view mistake, RecordedBody body, std::uint32_t seed,
                               std::uint32_t number) {
  SceneDice dice(seed, number);
  const Motion motion = random_motion(body, dice);
  Convention told;
  told.columns = columns_of(AttitudeForm::none, true);
  Convention right = told;
  for (const recording::TimeUnitName& name : recording::common_units_of_times()) {
    if (mistake == name.option) right.time_unit = name.unit;
  }
  for (const recording::RateUnitName& name : recording::units_of_rates()) {
    if (mistake == name.option) right.rate_unit = name.unit;
  }
  if (mistake.find(',') != std::string_view::npos)
    right.axes = recording::parse_body_axes(mistake, "axes");
  if (mistake == "left-handed") right.axes = recording::parse_body_axes("x,y,-z", "axes");
  const Numbers numbers = mistake == "nine digits" ? Numbers::nine_digits
                          : mistake == "float32"   ? Numbers::floats
                                                   : Numbers::doubles;
  const double noise = mistake == "noise" ? 1e-3 : 0;
  RandomRecording recording = recording_of(motion, told, right, numbers, noise, dice);
  recording.description = fmt::format("{} of body {}", mistake, static_cast<int>(body));
  return recording;
}

RandomRecording random_recording(std::uint32_t seed, std::uint32_t number) {
  SceneDice dice(seed, number);
  const Motion motion = random_motion(RecordedBody::any, dice);
  const auto& forms = enumerators<AttitudeForm>;
  const auto form = dice.pick(std::vector(forms.begin(), forms.end()));
  const bool rates = form == AttitudeForm::none || dice.chance(0.85);
  const bool momentum = rates && dice.chance(0.2);
  Convention told;
  told.columns = columns_of(form, rates, momentum);
  told.inertia = motion.moments.asDiagonal();
  if (form == AttitudeForm::euler) told.sequence = "zyx";
  Convention right = told;
  if (dice.chance(0.5)) right.time_unit = dice.pick(recording::common_units_of_times()).unit;
  if (rates && !momentum && dice.chance(0.5))
    right.rate_unit = dice.pick(recording::units_of_rates()).unit;
  if (dice.chance(0.5)) right.axes = dice.pick(recording::all_body_axes());
  right.angle_unit = angle_unit(told);
  if (form == AttitudeForm::euler) {
    if (dice.chance(0.5)) right.sequence = dice.pick(recording::all_sequences());
  }
  if (has_angles(form) && dice.chance(0.5))
    right.angle_unit = dice.pick(recording::units_of_angles()).unit;
  if (form == AttitudeForm::quaternion && dice.chance(0.5)) move_scalar(right);
  if (form != AttitudeForm::none) right.inverse = dice.chance(0.5);
  if (form != AttitudeForm::none && rates) {
    right.rates_in_space = dice.chance(0.3);
    if (!right.rates_in_space && dice.chance(0.2)) right.offset = random_rotation(dice);
  }
  const Numbers numbers =
      dice.pick(std::vector{Numbers::doubles, Numbers::nine_digits, Numbers::floats});
  RandomRecording recording = recording_of(motion, told, right, numbers, 0, dice);
  // Attitudes alone do not determine it.
  if (!rates || dice.chance(0.3)) recording.problem.omega = motion.omega;
  recording.description = description_of(right);
  return recording;
}

std::string fault_of_verdict(const RandomRecording& recording,
                             const std::filesystem::path& folder) try {
  system::write_file_atomically(folder / "recording.csv", recording.text);
  const recording::Recording file(folder / "recording.csv");
  const Judgement as_read = judge(file, recording.told, recording.problem);
  if (as_read.within_noise) return {};
  const Alternatives found = better_readings(file, recording.problem, as_read);
  if (found.fitting.empty()) {
    return fmt::format("nothing is proposed; the nearest misses {}",
                       found.nearest ? *found.nearest->misfit.worst() : -1);
  }
  if (found.fitting.size() > 2) {
    std::string list;
    for (const Reading& reading : found.fitting) {
      list += fmt::format("\n  misses {}: {}", *reading.misfit.worst(),
                          description_of(reading.convention));
    }
    return fmt::format("{} readings are proposed{}", found.fitting.size(), list);
  }
  for (const Reading& reading : found.fitting) {
    const Judgement again = judge(file, reading.convention, recording.problem);
    if (again.within_noise || relative_error(again) < 1e-6) return {};
  }
  return "the proposed convention is wrong: " + description_of(found.fitting.front().convention);
} catch (const Error& error) {
  return error.what();
}

}  // namespace twrench::check
