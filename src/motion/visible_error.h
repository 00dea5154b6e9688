#pragma once

#include <twrench/motion/free_body.h>
#include <twrench/motion/method.h>

#include <string>

namespace twrench::motion {

/// Returns whether and how far the attitude of a sample, computed by the method, deviates visibly
/// from the exact motion, such as "rkmk45 is off by 180 degrees at 10 s; the method exact is not".
/// Empty if it does not, if there is no closed form, or if the closed form is not sure then.
std::string visible_error(const FreeBody& body, const Method& method, const Sample& sample);

}  // namespace twrench::motion
