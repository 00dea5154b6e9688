#include "cases/solution.h"

#include <twrench/motion/diagnostics.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/enumeration.h"

namespace twrench::cases {
namespace {

std::vector<double> in_units(const Eigen::VectorXd& values, double unit_size) {
  std::vector<double> result;
  for (const double value : values) result.push_back(value / unit_size);
  return result;
}

Eigen::Vector4d scalar_first(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

Eigen::Vector4d nearer_quaternion(const Published& published, const Eigen::Quaterniond& q) {
  const Eigen::Vector4d exact = scalar_first(q);
  const Eigen::Map<const Eigen::Vector4d> given(published.values.data());
  return exact.dot(given) < 0 ? Eigen::Vector4d(-exact) : exact;
}

}  // namespace

Solution::Solution(const Case& problem)
    : body_(problem.moments.asDiagonal(), problem.omega),
      motion_(body_),
      attitude_(problem.attitude.value_or(Eigen::Quaterniond::Identity())) {}

State Solution::at(double t) const {
  const motion::Sample sample = motion_.at(t);
  Eigen::Quaterniond q = attitude_ * Eigen::Quaterniond(sample.X);
  if (q.w() < 0) q.coeffs() *= -1;
  return {t, sample.omega, q, motion::energy(body_.inertia(), body_.omega()),
          attitude_ * body_.momentum()};
}

std::vector<double> times_of(const Case& problem) {
  std::set<double> times{0, problem.duration};
  for (const Published& published : problem.published) times.insert(published.time);
  return {times.begin(), times.end()};
}

std::vector<double> exact_components(const Published& published, const State& exact) {
  switch (published.quantity) {
    case Quantity::omega:
      return in_units(exact.omega, published.unit_size);
    case Quantity::mrp:
      return in_units(exact.quaternion.vec() / (1 + exact.quaternion.w()), published.unit_size);
    case Quantity::quaternion:
      return in_units(nearer_quaternion(published, exact.quaternion), published.unit_size);
    case Quantity::momentum:
      return in_units(exact.momentum, published.unit_size);
  }
  return {};
}

double largest_difference(const Published& published, const State& exact) {
  const std::vector<double> components = exact_components(published, exact);
  double largest = 0;
  for (std::size_t i = 0; i < components.size(); ++i) {
    largest = std::max(largest, std::abs(published.values[i] - components[i]));
  }
  return largest;
}

bool is_right_to_its_digits(const Published& published, const State& exact) {
  const std::vector<double> components = exact_components(published, exact);
  for (std::size_t i = 0; i < components.size(); ++i) {
    const double half = last_digit(published.digits[i]) / 2;
    if (std::abs(published.values[i] - components[i]) > half) return false;
  }
  return true;
}

namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

Json quaternion_json(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

Json published_json(const Published& published, const State& exact) {
  const std::vector<double> components = exact_components(published, exact);
  std::vector<double> differences;
  for (std::size_t i = 0; i < components.size(); ++i) {
    differences.push_back(published.values[i] - components[i]);
  }
  return {{"by", published.by},
          {"t", published.time},
          {"quantity", enumerator_name(published.quantity)},
          {"unit", published.unit},
          {"digits", published.digits},
          {"values", published.values},
          {"exact", components},
          {"difference", differences},
          {"right_to_its_digits", is_right_to_its_digits(published, exact)}};
}

Json state_json(const State& state) {
  return {{"t", state.t},
          {"omega", vector_json(state.omega)},
          {"quaternion", quaternion_json(state.quaternion)},
          {"energy", state.energy},
          {"momentum", vector_json(state.momentum)}};
}

}  // namespace

Json summary_json(const Case& problem) {
  return {{"name", problem.name},
          {"title", problem.title},
          {"source", problem.source},
          {"url", problem.url},
          {"inertia", vector_json(problem.moments)},
          {"inertia_unit", problem.inertia_unit},
          {"omega", vector_json(problem.omega)},
          {"attitude", problem.attitude ? quaternion_json(*problem.attitude) : Json(nullptr)},
          {"duration", problem.duration}};
}

Json case_json(const Case& problem) {
  const Solution solution(problem);
  Json document = summary_json(problem);
  document["note"] = problem.note;
  document["published"] = Json::array();
  for (const Published& published : problem.published) {
    document["published"].push_back(published_json(published, solution.at(published.time)));
  }
  document["exact"] = Json::array();
  for (const double t : times_of(problem)) document["exact"].push_back(state_json(solution.at(t)));
  return document;
}

}  // namespace twrench::cases
