#pragma once

#include <twrench/study/study.h>

#include <span>
#include <vector>

#include "report/citations.h"
#include "report/document.h"
#include "report/results.h"
#include "report/solution.h"

// The sections of a report, in the language of the experiments' scenes or in the given one. Those
// of the tasks are for the specification's three experiments.
namespace twrench::report {

/// The tasks and how the report solves them.
Section introduction_to_tasks(Language language, Citations& citations);

/// The contents of a report on motions. `has_interior`: a body has a wheel or loses energy.
Section introduction_to_motions(Language language, Citations& citations, bool has_interior);

/// The equations, the methods, the closed form and the measures of error. Every symbol of the other
/// sections is defined here or where it is used. `has_interior`: also the equations of a wheel and
/// of the energy loss.
Section theory_section(Language language, Citations& citations, bool has_interior);

/// Mass, centre of mass and inertia of a body, and what becomes of a small tilt about each axis.
Section body_section(const Experiment& experiment);

/// The header of a table of quantities with their units.
std::vector<std::string> quantity_header(Language language);

/// The principal moments and axes of a body, and what becomes of a small tilt about each.
Table axes_table(const Experiment& experiment);

/// Task 1: exp(h Omega), the energy, and the inertia of the T-wrench.
Section functions_section(std::span<const PrintedSolution> solutions, const TaskCommands& commands,
                          Citations& citations);

/// Task 2: the sphere solved exactly.
Section sphere_section(const TaskCommands& commands, Language language, Citations& citations);

/// Task 3: the Lie-Euler method on the sphere and, from `study`, on the T-wrench.
Section lie_euler_section(const study::Study& study, const Experiment& studied,
                          const TaskCommands& commands);

/// Task 4: RK4 and RKF45, from the same study.
Section runge_kutta_section(const study::Study& study, const Experiment& studied,
                            Citations& citations);

/// Task 5: the T-wrench with three angular velocities, solved with RK4.
Section wrench_section(std::span<const PrintedSolution> solutions);

/// Task 6: the nine components of X, and an interpretation.
Section components_section(std::span<const PrintedSolution> solutions);

/// A motion: its constants, the nine components of X against time, an interpretation, the predicted
/// flips and those of the scene's method, and how far the method drifts.
Section motion_section(const Solution& solution);

/// All methods on one motion: measured orders, errors, drifts, flips and work.
Section methods_section(const study::Study& study, const Experiment& studied, Citations& citations);

/// Conclusions about the methods, and for the tasks about the motions.
Section discussion_of_tasks(std::span<const PrintedSolution> solutions, const study::Study& study,
                            Citations& citations);
Section discussion_of_motions(const study::Study& study, Language language, Citations& citations);

}  // namespace twrench::report
