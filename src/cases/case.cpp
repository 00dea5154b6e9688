#include "cases/case.h"

#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/motion/diagnostics.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "base/enumeration.h"
#include "base/words.h"
#include "embedded/cases.h"
#include "scene/limits.h"
#include "scene/toml_table.h"

namespace twrench::cases {
namespace {

namespace limits = scene::limits;

using scene::TomlTable;
using scene::ValueForm;
constexpr limits::Limit unit_component{-1, 1};

std::string text_or_none(TomlTable& table, const std::string& key) {
  const auto value = table.value(key, ValueForm::Kind::text);
  return value ? value->get<std::string>() : std::string();
}

/// Returns a unit of rates and its size in rad/s.
std::pair<std::string, double> read_rate_unit(TomlTable& table) {
  const std::string unit = table.required_text("unit");
  if (unit == "rad/s") return {unit, 1.0};
  if (unit == "deg/s") return {unit, std::numbers::pi / 180};
  throw InvalidArgument(table.place("unit"), fmt::format("is '{}'", unit), "use rad/s or deg/s");
}

Eigen::Quaterniond read_quaternion(TomlTable& table) {
  const auto component = [&](const char* key) {
    return table.required_number(key, unit_component);
  };
  const Eigen::Quaterniond q(component("w"), component("x"), component("y"), component("z"));
  constexpr double rounding = 1e-6;  // published with few digits
  if (std::abs(q.norm() - 1) > rounding) {
    throw InvalidArgument(table.place(""), "is not of unit length");
  }
  return q.normalized();
}

void read_initial_state(TomlTable& table, Case& problem) {
  problem.published_omega = table.required_vector("omega", limits::coordinate);
  const auto [unit, size] = read_rate_unit(table);
  problem.omega_unit = unit;
  problem.omega = limits::check_omega(table.place("omega"), problem.published_omega * size);
  table.table("attitude", [&](TomlTable& q) { problem.attitude = read_quaternion(q); });
}

double parse_digits(const std::string& digits, const std::string& place) {
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error == std::errc{} && stop == end && std::isfinite(value)) return value;
  throw InvalidArgument(place, fmt::format("'{}' is not a number", digits));
}

void read_values(TomlTable& table, Published& published) {
  const auto texts = table.value("values", ValueForm::Kind::texts);
  if (texts) published.digits = texts->get<std::vector<std::string>>();
  const std::size_t count = published.quantity == Quantity::quaternion ? 4 : 3;
  if (published.digits.size() != count) {
    throw InvalidArgument(table.place("values"),
                          fmt::format("must be {} strings of digits", count));
  }
  for (const std::string& digits : published.digits) {
    published.values.push_back(parse_digits(digits, table.place("values")));
  }
}

Published read_published(TomlTable& table, const Case& problem) {
  Published published{};
  published.by = text_or_none(table, "by");
  published.time = table.required_number("time", {0, problem.duration});
  published.quantity =
      find_enumerator<Quantity>(table.required_text("quantity"), table.place("quantity"));
  published.unit_size = 1;
  if (published.quantity == Quantity::omega) {
    std::tie(published.unit, published.unit_size) = read_rate_unit(table);
  } else if (published.quantity == Quantity::momentum) {
    published.unit = momentum_unit(problem);
  }
  read_values(table, published);
  if (table.has("deviation")) {
    published.deviation = table.required_number("deviation", {0, limits::huge});
  }
  return published;
}

Case read_case(TomlTable& file) {
  Case problem;
  problem.title = file.required_text("title");
  problem.source = file.required_text("source");
  problem.url = file.required_text("url");
  problem.note = file.required_text("note");
  problem.duration = file.required_number("duration", limits::duration);
  bool has_inertia = false, has_state = false;
  file.table("inertia", [&](TomlTable& table) {
    problem.moments = limits::check_moments(table.place("moments"),
                                            table.required_vector("moments", limits::moment));
    problem.inertia_unit = table.required_text("unit");
    has_inertia = true;
  });
  file.table("initial", [&](TomlTable& table) {
    read_initial_state(table, problem);
    has_state = true;
  });
  if (!has_inertia) throw InvalidArgument(file.place("inertia"), "is missing");
  if (!has_state) throw InvalidArgument(file.place("initial"), "is missing");
  file.tables("published", [&](TomlTable& table) {
    problem.published.push_back(read_published(table, problem));
  });
  file.finish();
  return problem;
}

}  // namespace

double last_digit(const std::string& digits) {
  const std::size_t letter = digits.find_first_of("eE");
  const std::size_t end = std::min(letter, digits.size());
  const std::size_t point = std::min(digits.find('.'), end);
  int exponent = 0;
  if (letter != std::string::npos) {
    const std::size_t sign = digits.at(letter + 1) == '+' ? 1 : 0;
    std::from_chars(digits.data() + letter + 1 + sign, digits.data() + digits.size(), exponent);
  }
  const int decimals = point == end ? 0 : static_cast<int>(end - point) - 1;
  return std::pow(10.0, exponent - decimals);
}

std::string momentum_unit(const Case& problem) {
  return (problem.inertia_unit.empty() ? "1" : problem.inertia_unit) + "/s";
}

std::string energy_unit(const Case& problem) { return momentum_unit(problem) + "^2"; }

Case parse_case(std::string_view toml, const std::string& source) {
  const toml::table root = scene::parse_toml(toml, source);
  TomlTable file(root, source, "");
  Case problem = read_case(file);
  problem.name = std::filesystem::path(source).stem().string();
  return problem;
}

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const auto& [file, text] : embedded::cases()) {
    names.push_back(std::filesystem::path(file).stem().string());
  }
  return names;
}

Case load_case(const std::string& name, const std::string& what) {
  const std::string file = name + ".toml";
  const auto found = embedded::cases().find(file);
  if (found == embedded::cases().end()) throw unknown_name(what, name, case_names());
  return parse_case(found->second, file);
}

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
