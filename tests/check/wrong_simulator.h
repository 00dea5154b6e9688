#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "check/law/mistakes.h"

namespace twrench::check {

/// A file of a simulator with a mistake that people reported.
struct WrongSimulation {
  Mistake mistake;
  bool has_rates;
  std::string text;  ///< CSV: times, quaternion, perhaps rates in the body's axes
  Eigen::Matrix3d inertia;
  std::string description;
};

/// A motion of a random body from a random start, computed with a mistake that is drawn as well,
/// and written with 6 to 17 digits or with noise. One in four has the attitude alone; delayed rates
/// are no mistake then.
WrongSimulation wrong_simulation(std::uint32_t seed, std::uint32_t number);

/// The verdict on a wrong simulation.
struct VerdictOnLaw {
  bool names_mistake = false;
  std::string fault;  ///< a wrong statement; empty if there is none
};

/// Writes the simulation into the folder and checks it. Wrong statements are another mistake that
/// does not explain the rows as well, and another reading of the file.
VerdictOnLaw verdict_on(const WrongSimulation& simulation, const std::filesystem::path& folder);

}  // namespace twrench::check
