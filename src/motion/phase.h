#pragma once

#include <twrench/motion/exact.h>

#include <optional>

namespace twrench::motion {

/// Returns the rotation about L in one period of the momentum in the body (docs/theory.md, "The
/// geometric phase"): in closed form or, where there is none, integrated over the period. With a
/// wheel, a path may circle several equilibria; the area is that of the smaller of the two caps
/// that it bounds. Nothing if the path is not closed (energy loss), for steady motion, or so close
/// to a saddle that the return cannot be distinguished from round-off.
std::optional<ExactMotion::Phase> phase_of(const FreeBody& body);

}  // namespace twrench::motion
