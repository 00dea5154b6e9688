#include <twrench/motion/error.h>

namespace twrench::motion {

MotionError::~MotionError() = default;

}  // namespace twrench::motion
