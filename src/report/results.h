#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "report/document.h"
#include "scene/scene.h"

namespace twrench::report {

/// The command lines that print or draw what the report shows of an experiment.
struct Commands {
  std::string inertia;     ///< The mass properties.
  std::string start;       ///< The state at t = 0.
  std::string constants;   ///< The flips of the exact motion, or of the reference.
  std::string own_method;  ///< The flips and drifts of the scene's method.
  std::string study;       ///< All methods.
  std::string diagrams;    ///< The diagrams of all methods.
  /// The study of some methods.
  std::function<std::string(const std::vector<std::string>& methods)> study_of;
  /// The flips and drifts of a method with a fixed step in s.
  std::function<std::string(const std::string& method, double step)> solution;
  /// The nine components of the reference, or of a method with a fixed step in s.
  std::string components;
  std::function<std::string(const std::string& method, double step)> components_of;
};

/// The command lines of tasks that belong to no experiment.
struct TaskCommands {
  /// Lie-Euler on the sphere with that omega. X at each time up to the step is a single
  /// exponential.
  std::function<std::string(const std::string& omega, double step,
                            const std::vector<double>& times)>
      exponentials;
  /// The exact motion of the sphere at times in s.
  std::function<std::string(const std::vector<double>& times)> sphere;
  /// A study of methods on the sphere, with steps and a duration in s.
  std::function<std::string(const std::vector<std::string>& methods,
                            const std::vector<double>& steps, double duration)>
      sphere_study;
};

/// A scene whose motion is reported.
struct Experiment {
  scene::Scene scene;
  Commands commands;
};

/// Returns the title of a report: that of the only experiment, or of the subject of several.
std::string title_of(std::span<const Experiment> experiments);

/// Returns a note if the report is not in the language of the first scene; otherwise nothing.
std::string note_on_language(std::span<const Experiment> experiments);

/// Returns the report on motions: the equations, the bodies, each motion, the methods on the first
/// of them, and references. All numbers are computed here. There must be at least one experiment;
/// the language of the first scene is that of the report.
/// Throws MotionError if a scene's own method cannot compute its motion.
std::vector<Section> report_on_motions(std::span<const Experiment> experiments);

/// Returns the report that solves the specification's tasks. The experiments must be the three of
/// task 5. The first defines the T-wrench by its two cylinders. Throws as report_on_motions() does.
std::vector<Section> report_on_tasks(std::span<const Experiment> experiments,
                                     const TaskCommands& commands);

}  // namespace twrench::report
