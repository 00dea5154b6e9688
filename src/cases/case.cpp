#include "cases/case.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
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

}  // namespace twrench::cases
