#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/document.h"
#include "scene/scene.h"

namespace twrench::report {

/// A scene whose motion is reported.
struct Experiment {
  scene::Scene scene;
  std::string words;  ///< It and the options of its motion, as in "stable-y --duration 20".
  std::string body;   ///< It and the options of its body, as in "stable-y --inertia 1,2,3".
};

/// Returns the results of the experiments: the bodies, the equations, each motion, the methods on
/// the first of them, and references. All numbers are computed here. There must be at least one.
/// Throws MotionError where a scene's own method cannot compute its motion.
std::vector<Section> results(std::span<const Experiment> experiments);

}  // namespace twrench::report
