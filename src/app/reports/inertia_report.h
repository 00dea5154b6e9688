#pragma once

#include <twrench/body/mass_properties.h>
#include <twrench/motion/exact.h>

#include <optional>
#include <string>
#include <string_view>

#include "mesh/mesh_file.h"
#include "motion/phase.h"

namespace twrench::app {

/// The units of a report. The numbers are grams and centimetres per unit.
struct InertiaUnits {
  std::string_view mass, length;
  double grams, centimetres;
};

inline constexpr InertiaUnits gram_centimetre{"g", "cm", 1, 1}, kilogram_metre{"kg", "m", 1e3, 1e2};

/// The rotation about L in one period of a scene's motion.
struct Turn {
  Eigen::Vector3d omega;  ///< At t = 0, in body axes, rad/s.
  motion::ExactMotion::Phase phase;
};

/// The body whose properties are printed.
struct Described {
  std::string name;
  body::MassProperties body;
  /// Its mesh, if it is one.
  std::optional<mesh::MeshFile> mesh = {};
  /// For a scene whose motion is periodic in the body.
  std::optional<Turn> turn = {};
  bool is_rigid = true;
  /// A point in the units of the report, about which the inertia is printed too.
  std::optional<Eigen::Vector3d> about = {};
  InertiaUnits units = gram_centimetre;
};

/// The report as text, and as JSON. Throw InvalidArgument about --about if the mass is not given.
std::string inertia_text(const Described& described);
std::string inertia_json(const Described& described);

}  // namespace twrench::app
