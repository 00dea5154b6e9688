#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace twrench::motion {

/// A motion known to 25 digits, from a 60-digit Taylor method whose energy and momentum hold to
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

inline std::vector<ReferenceCase> reference_cases() {
  std::ifstream file(TWRENCH_TESTS_DIR "/reference/trajectories.json");
  std::vector<ReferenceCase> cases;
  for (const auto& c : nlohmann::json::parse(file)) {
    const Eigen::Vector3d moments =
        vector_of(c.contains("inertia_values_g_cm2") ? c["inertia_values_g_cm2"] : c["inertia"]);
    const Eigen::Vector3d omega0 = vector_of(c["omega0"]);
    ReferenceCase reference{c["name"], FreeBody(moments.asDiagonal(), omega0), omega0, {}};
    for (const auto& s : c["samples"]) {
      Sample sample{s["t"], {}, vector_of(s["omega"])};
      for (int row = 0; row < 3; ++row) {
        sample.X.row(row) = vector_of(s["X"][static_cast<std::size_t>(row)]);
      }
      reference.samples.push_back(sample);
    }
    cases.push_back(std::move(reference));
  }
  return cases;
}

inline ReferenceCase reference_case(const std::string& name) {
  for (ReferenceCase& c : reference_cases()) {
    if (c.name == name) return c;
  }
  throw std::invalid_argument("no reference case " + name);
}

}  // namespace twrench::motion
