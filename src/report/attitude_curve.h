#pragma once

#include <vector>

#include "plot/attitude_plot.h"
#include "scene/scene.h"

namespace twrench::report {

/// Returns the motion of a scene by its own method, as `twrench plot` draws it, with the flips of
/// the exact motion if the body turns over. Throws as integrate() does.
plot::AttitudeCurve attitude_curve(const scene::Scene& scene);

/// Returns the curves of a scene: its motion or, if it shows a recorded one, that and the exact
/// motion of the body, if it is known. Throws as integrate() does.
std::vector<plot::AttitudeCurve> shown_curves(const scene::Scene& scene);

}  // namespace twrench::report
