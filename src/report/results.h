#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/document.h"
#include "scene/scene.h"

namespace twrench::report {

/// What makes the numbers and figures of an experiment, as a reader can repeat it.
struct Commands {
  std::string inertia;     ///< The mass properties.
  std::string constants;   ///< What the exact motion is.
  std::string components;  ///< The nine components of X.
  std::string own_method;  ///< The flips and drifts of the scene's method.
  std::string methods;     ///< All methods.
  std::string diagrams;    ///< Their order and work.
};

/// A scene whose motion is reported.
struct Experiment {
  scene::Scene scene;
  Commands commands;
};

/// Returns the results of the experiments: the bodies, the equations, each motion, the methods on
/// the first of them, and references. All numbers are computed here. There must be at least one.
/// Throws MotionError where a scene's own method cannot compute its motion.
std::vector<Section> results(std::span<const Experiment> experiments);

}  // namespace twrench::report
