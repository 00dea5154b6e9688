#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace twrench::motion {

/// A motion known to 25 digits, from a 60-digit Taylor method that conserves energy and momentum to
/// 1e-30. X(0) = Id, and the inertia is diagonal.
struct ReferenceCase {
  std::string name;
  FreeBody body;
  Eigen::Vector3d omega0;
  std::vector<Sample> samples;
};

inline double digits(const nlohmann::json& text) {
  if (text.is_number()) return text.get<double>();
  const auto& string = text.get_ref<const std::string&>();
  double value = 0;
  std::from_chars(string.data(), string.data() + string.size(), value);
  return value;
}

inline Eigen::Vector3d vector_of(const nlohmann::json& v) {
  return {digits(v[0]), digits(v[1]), digits(v[2])};
}

inline Eigen::Matrix3d matrix_of(const nlohmann::json& rows) {
  Eigen::Matrix3d matrix;
  for (int row = 0; row < 3; ++row) matrix.row(row) = vector_of(rows[std::size_t(row)]);
  return matrix;
}

/// Reads cases whose inertia is three moments or a matrix, and which may have a wheel ("rotor") and
/// an energy loss ("tau").
inline std::vector<ReferenceCase> cases_of(const std::string& name) {
  std::ifstream file(TWRENCH_TESTS_DIR "/reference/" + name);
  std::vector<ReferenceCase> cases;
  for (const auto& c : nlohmann::json::parse(file)) {
    const auto& given =
        c.contains("inertia_values_g_cm2") ? c["inertia_values_g_cm2"] : c["inertia"];
    const Eigen::Matrix3d inertia =
        given[0].is_array() ? matrix_of(given) : Eigen::Matrix3d(vector_of(given).asDiagonal());
    const Eigen::Vector3d omega0 = vector_of(c["omega0"]);
    Interior interior;
    if (c.contains("rotor")) interior.wheel = vector_of(c["rotor"]);
    if (c.contains("tau")) interior.energy_loss_time = digits(c["tau"]);
    const FreeBody body(inertia, omega0, Eigen::Matrix3d::Identity(), interior);
    ReferenceCase reference{c["name"], body, omega0, {}};
    for (const auto& s : c["samples"]) {
      reference.samples.push_back({s["t"], matrix_of(s["X"]), vector_of(s["omega"])});
    }
    cases.push_back(std::move(reference));
  }
  return cases;
}

inline std::vector<ReferenceCase> reference_cases() { return cases_of("trajectories.json"); }

/// Motions with a wheel, with energy loss and with both, to 20 digits, from an independent program.
inline std::vector<ReferenceCase> constant_momentum_cases() {
  return cases_of("constant_momentum.json");
}

inline ReferenceCase reference_case(const std::string& name) {
  for (ReferenceCase& c : reference_cases()) {
    if (c.name == name) return c;
  }
  throw std::invalid_argument("no reference case " + name);
}

}  // namespace twrench::motion
