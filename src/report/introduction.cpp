#include <fmt/format.h>
#include <twrench/motion/method.h>

#include "report/sections.h"

namespace twrench::report {
namespace {

/// States the source of the numbers; part of every introduction.
Paragraph about_numbers(Citations& citations) {
  return {fmt::format(
      "The motion is also known in closed form {}, which gives the error of every method. All "
      "numbers were computed when this report was written; below each table and figure stand the "
      "commands that give the same.",
      citations.cite_method(motion::find_method("exact").source))};
}

}  // namespace

Section introduction_to_tasks(Citations& citations) {
  const std::string effect = citations.cite(ashbaugh);
  Section section{.heading = "Introduction", .content = {}};
  section.content.emplace_back(Paragraph{fmt::format(
      "A rigid body on which no external torque acts turns about its centre of mass, and its "
      "motion "
      "can be surprising: a T-shaped wrench that spins about its intermediate axis turns over "
      "again "
      "and again, although nothing pushes it {}. This report solves the tasks of {}: it computes "
      "how such a body turns, by methods that keep its attitude a rotation, tests the methods, and "
      "explains what the solutions show.",
      effect, citations.specification())});
  section.content.emplace_back(Paragraph{
      "Task 1 provides the functions: the exponential, the energy, and the inertia of the "
      "T-wrench. Task 2 solves the motion of a sphere exactly, and task 3 tests the "
      "Lie-Euler method with it. Task 4 is about the Runge-Kutta methods RK4 and RKF45. "
      "Task 5 computes the motion of the T-wrench from three initial angular velocities, "
      "and task 6 draws the nine components of its attitude and interprets them. Then all "
      "methods are compared, and the results discussed."});
  section.content.emplace_back(about_numbers(citations));
  return section;
}

Section introduction_to_motions(Citations& citations, bool has_interior) {
  Section section{.heading = "Introduction", .content = {}};
  section.content.emplace_back(Paragraph{fmt::format(
      "This report is about the rotation of a rigid body about its centre of mass when no external "
      "torque acts on it. It contains the equations of {}, the body, its motion, and a comparison "
      "of methods that compute the motion.",
      citations.specification())});
  section.content.emplace_back(about_numbers(citations));
  if (has_interior) {
    section.content.emplace_back(Paragraph{fmt::format(
        "If a body contains a wheel or loses energy, its motion has no closed form. There the "
        "errors are differences from the method taylor with the tolerance {}.",
        motion::min_tolerance)});
  }
  return section;
}

}  // namespace twrench::report
