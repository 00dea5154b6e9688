#include "check/wrong_simulator.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "base/enumeration.h"
#include "check/hypotheses/hypotheses.h"
#include "check/verdict/judge.h"
#include "recording/conventions/names.h"
#include "scene_dice.h"
#include "system/file.h"
#include "table/error.h"

namespace twrench::check {
namespace {

using recording::Kind;

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// The derivatives of the rates and of the quaternion that a simulator computes, and its limit of
/// the speed.
struct Simulator {
  std::function<Vector3d(const Vector3d& w, const Quaterniond& q)> acceleration;
  std::function<Quaterniond(const Vector3d& w, const Quaterniond& q)> turn;
  double most = std::numeric_limits<double>::infinity();
};

struct Point {
  Vector3d w;
  Eigen::Vector4d q;
};

Point derivative(const Simulator& simulator, const Point& at) {
  const Quaterniond q(at.q);
  return {simulator.acceleration(at.w, q), simulator.turn(at.w, q).coeffs()};
}

Point moved(const Point& from, const Point& rate, double time) {
  return {from.w + time * rate.w, from.q + time * rate.q};
}

Point stepped(const Simulator& simulator, const Point& at, double h) {
  const Point a = derivative(simulator, at);
  const Point b = derivative(simulator, moved(at, a, h / 2));
  const Point c = derivative(simulator, moved(at, b, h / 2));
  const Point d = derivative(simulator, moved(at, c, h));
  Point next = moved(moved(moved(moved(at, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
  next.q.normalize();
  if (next.w.norm() > simulator.most) next.w *= simulator.most / next.w.norm();
  return next;
}

Quaterniond pure(const Vector3d& w) { return {0, w.x(), w.y(), w.z()}; }

Quaterniond half(Quaterniond q) {
  q.coeffs() *= 0.5;
  return q;
}

/// The simulator with the mistake. The rates and angles of the last two are made below.
Simulator simulator_with(Mistake mistake, const Matrix3d& I, double speed, SceneDice& dice) {
  const Matrix3d inverse = I.inverse();
  const double moment = I.diagonal().maxCoeff();
  const auto term = [I](const Vector3d& w) { return Vector3d((I * w).cross(w)); };
  Simulator right{
      [=](const Vector3d& w, const Quaterniond&) { return Vector3d(inverse * term(w)); },
      [](const Vector3d& w, const Quaterniond& q) { return half(q * pure(w)); }};
  const auto euler = right.acceleration;
  const auto of_other_body = [&](const Matrix3d& other) {
    const Matrix3d other_inverse = other.inverse();
    right.acceleration = [=](const Vector3d& w, const Quaterniond&) {
      return Vector3d(other_inverse * (other * w).cross(w));
    };
  };
  const Vector3d torque =
      dice.spread(0.01, 0.1) * moment * speed * speed * dice.vector(-1, 1).normalized();
  const double damping = dice.spread(0.003, 0.03) * speed;
  switch (mistake) {
    case Mistake::gyroscopic_factor: {
      const double factor = dice.pick(std::vector{-1.0, 0.5, 0.0, 2.0});
      right.acceleration = [=](const Vector3d& w, const Quaterniond& q) {
        return Vector3d(factor * euler(w, q));
      };
      break;
    }
    case Mistake::undivided:
      right.acceleration = [=](const Vector3d& w, const Quaterniond&) { return term(w); };
      break;
    case Mistake::multiplied:
      right.acceleration = [=](const Vector3d& w, const Quaterniond&) {
        return Vector3d(I * term(w));
      };
      break;
    case Mistake::body_torque:
      right.acceleration = [=](const Vector3d& w, const Quaterniond& q) {
        return Vector3d(euler(w, q) + inverse * torque);
      };
      break;
    case Mistake::space_torque:
      right.acceleration = [=](const Vector3d& w, const Quaterniond& q) {
        return Vector3d(euler(w, q) + inverse * (q.conjugate() * torque));
      };
      break;
    case Mistake::damping:
      right.acceleration = [=](const Vector3d& w, const Quaterniond& q) {
        return Vector3d(euler(w, q) - damping * w);
      };
      break;
    case Mistake::quadratic_damping:
      right.acceleration = [=](const Vector3d& w, const Quaterniond& q) {
        return Vector3d(euler(w, q) - damping / speed * w.norm() * w);
      };
      break;
    case Mistake::speed_limit:
      right.most = dice.uniform(0.97, 1.0) * speed;
      break;
    case Mistake::products_sign:
      of_other_body(2 * Matrix3d(I.diagonal().asDiagonal()) - I);
      break;
    case Mistake::inverse_inertia:
      of_other_body(inverse);
      break;
    case Mistake::moments: {
      Matrix3d other = I;
      const int axis = dice.whole(0, 2);
      other(axis, axis) *= dice.pick(std::vector{0.9, 1.1, 1.2});
      of_other_body(other);
      break;
    }
    case Mistake::attitude_factor: {
      const double factor = dice.pick(std::vector{2.0, 0.5, -1.0});
      right.turn = [=](const Vector3d& w, const Quaterniond& q) {
        return half(q * pure(factor * w));
      };
      break;
    }
    case Mistake::swapped_factors:
      right.turn = [](const Vector3d& w, const Quaterniond& q) { return half(pure(w) * q); };
      break;
    case Mistake::delayed_rates:
    case Mistake::integrated_angles:
      break;
  }
  return right;
}

/// In attitudes alone, a factor of the attitude is one of the gyroscopic term.
bool is_named_by(const Explanation& explanation, const WrongSimulation& simulation) {
  const bool is_factor = !simulation.has_rates && simulation.mistake == Mistake::attitude_factor &&
                         explanation.mistake == Mistake::gyroscopic_factor;
  return is_factor || explanation.mistake == simulation.mistake;
}

}  // namespace

WrongSimulation wrong_simulation(std::uint32_t seed, std::uint32_t number) {
  SceneDice dice(seed, number);
  static const std::vector<Mistake> drawn{
      Mistake::gyroscopic_factor, Mistake::gyroscopic_factor, Mistake::undivided,
      Mistake::multiplied,        Mistake::body_torque,       Mistake::space_torque,
      Mistake::damping,           Mistake::quadratic_damping, Mistake::speed_limit,
      Mistake::products_sign,     Mistake::inverse_inertia,   Mistake::moments,
      Mistake::attitude_factor,   Mistake::swapped_factors,   Mistake::delayed_rates,
      Mistake::integrated_angles};
  const Mistake mistake = dice.pick(drawn);
  // The moments of a box.
  const double a = dice.uniform(0.5, 2), b = dice.uniform(0.5, 2), c = dice.uniform(0.5, 2);
  Matrix3d I = Vector3d(b * b + c * c, a * a + c * c, a * a + b * b).asDiagonal();
  if (mistake == Mistake::products_sign) {
    const Matrix3d R =
        Eigen::AngleAxisd(dice.uniform(0.2, 1), dice.vector(-1, 1).normalized()).toRotationMatrix();
    I = (R * I * R.transpose()).eval();
    I = (0.5 * (I + I.transpose())).eval();
  }
  const double speed = dice.spread(0.3, 5);
  Vector3d w;
  for (double& component : w) component = (dice.chance(0.5) ? 1 : -1) * dice.uniform(0.1, 1);
  w *= speed / w.norm();
  const auto rows = static_cast<std::size_t>(dice.whole(200, 1200));
  const double step = dice.spread(0.02, 0.1) / speed;
  const Simulator simulator = simulator_with(mistake, I, speed, dice);
  const int digits = dice.whole(6, 17);
  const double noise = dice.chance(0.25) ? dice.spread(1e-5, 3e-3) : 0;
  const auto error = [&] {
    double sum = -6;
    for (int n = 0; n < 12; ++n) sum += dice.uniform(0, 1);
    return noise * sum;
  };
  constexpr std::uint32_t kinds = 4;
  const bool has_rates = number % kinds != kinds - 1;
  WrongSimulation result{
      mistake, has_rates, has_rates ? "t,qw,qx,qy,qz,wx,wy,wz\n" : "t,qw,qx,qy,qz\n", I,
      fmt::format("{}, {} digits, noise {:.1g}, {} rows{}", enumerator_name(mistake), digits, noise,
                  rows, has_rates ? "" : ", attitude alone")};
  constexpr int substeps = 20;
  Point at{w, Eigen::Vector4d(0, 0, 0, 1)};
  Vector3d angles = Vector3d::Zero();  // of integrated_angles: about z, y and x
  std::vector<Point> points;
  for (std::size_t i = 0; i < rows; ++i) {
    Point shown = at;
    if (mistake == Mistake::integrated_angles) {
      shown.q = (Eigen::AngleAxisd(angles.z(), Vector3d::UnitZ()) *
                 Eigen::AngleAxisd(angles.y(), Vector3d::UnitY()) *
                 Eigen::AngleAxisd(angles.x(), Vector3d::UnitX()))
                    .coeffs();
    }
    points.push_back(shown);
    for (int k = 0; k < substeps; ++k) {
      const Vector3d before = at.w;
      at = stepped(simulator, at, step / substeps);
      angles += step / substeps / 2 * (before + at.w);
      // The rates that belong to half an interval later.
      if (mistake == Mistake::delayed_rates && k == substeps / 2 - 1) points.back().w = at.w;
    }
  }
  for (std::size_t i = 0; i < rows; ++i) {
    const Point& point = points[i];
    result.text += fmt::format("{:.17g}", static_cast<double>(i) * step);
    const Quaterniond apart(
        Eigen::AngleAxisd(noise > 0 ? error() : 0, dice.vector(-1, 1).normalized()));
    const Quaterniond q = Quaterniond(point.q) * apart;
    for (const double value : {q.w(), q.x(), q.y(), q.z()})
      result.text += fmt::format(",{:.{}g}", value, digits);
    for (int k = 0; k < 3 && has_rates; ++k) {
      const double value = point.w[k];
      result.text += fmt::format(",{:.{}g}", value + (noise > 0 ? speed * error() : 0), digits);
    }
    result.text += "\n";
  }
  return result;
}

VerdictOnLaw verdict_on(const WrongSimulation& simulation,
                        const std::filesystem::path& folder) try {
  const std::filesystem::path file = folder / "simulation.csv";
  system::write_file_atomically(file, simulation.text);
  recording::Convention told;
  for (const Kind kind : {Kind::time, Kind::quaternion, Kind::rates}) {
    if (kind == Kind::rates && !simulation.has_rates) continue;
    for (const std::string& name : names_of(kind)) told.columns[name] = name;
  }
  const Problem problem{.inertia = simulation.inertia};
  const recording::Recording recording(file);
  const Judgement as_read = judge(recording, told, problem);
  const bool is_right = !simulation.has_rates && simulation.mistake == Mistake::delayed_rates;
  if (as_read.within_noise) return {is_right, {}};
  const Alternatives found = better_readings(recording, problem, as_read);
  for (const Reading& reading : found.fitting) {
    const Judgement again = judge(recording, reading.convention, problem);
    if (!again.within_noise && relative_error(again) > 1e-4)
      return {false,
              fmt::format("another reading is proposed, axes {}, offset {}, inverse {}",
                          format_body_axes(reading.convention.axes),
                          reading.convention.offset.has_value(), reading.convention.inverse)};
  }
  VerdictOnLaw verdict;
  std::string named;
  for (const auto* list : {&found.laws.of_rates, &found.laws.of_attitude}) {
    for (const Explanation& one : *list) {
      verdict.names_mistake = verdict.names_mistake || is_named_by(one, simulation);
      named += fmt::format(" {} ({:.1g})", enumerator_name(one.mistake), one.miss);
    }
  }
  if (!verdict.names_mistake && !named.empty()) verdict.fault = "it names" + named;
  return verdict;
} catch (const Error& error) {
  return {false, error.what()};
}

}  // namespace twrench::check
