#include "timeline/reference_frame.h"

namespace twrench::timeline {

motion::RotatingFrame reference_frame(scene::Frame frame, const motion::FreeBody& body,
                                      const motion::Sample& sample) {
  if (frame == scene::Frame::body) return motion::body_frame(body, sample);
  if (frame == scene::Frame::rotating) return motion::steady_frame(body, sample.t);
  return {};
}

}  // namespace twrench::timeline
