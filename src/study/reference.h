#pragma once

#include <twrench/motion/trajectory.h>

#include <span>
#include <vector>

// The motion with which methods are compared, by motion::reference_method().

namespace twrench::study {

/// Returns the samples of the reference at the times in s.
std::vector<motion::Sample> reference_at(const motion::FreeBody& body,
                                         std::span<const double> times);

/// Returns the attitudes of the reference at the ends of the steps, from their beginnings.
std::vector<Eigen::Matrix3d> reference_ends(const motion::FreeBody& body,
                                            std::span<const motion::AcceptedStep> steps);

/// Returns the flip times in s in a method's own solution, as FlipSearch finds them where there is
/// no closed form. The last may lie beyond t_end, but within the step that contains it.
std::vector<double> flip_times(const motion::FreeBody& body, const motion::Method& method,
                               const motion::StepControl& control, double t_end);

/// Returns the flip times of the reference up to t_end, s, as FlipSearch finds them where there is
/// no closed form.
std::vector<double> reference_flip_times(const motion::FreeBody& body, double t_end);

}  // namespace twrench::study
