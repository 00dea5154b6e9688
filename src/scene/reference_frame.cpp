#include "scene/reference_frame.h"

namespace twrench::scene {

motion::RotatingFrame reference_frame(Frame frame, const motion::FreeBody& body,
                                      const motion::Sample& sample) {
  switch (frame) {
    case Frame::space:
      break;
    case Frame::body:
      return motion::body_frame(body, sample);
    case Frame::rotating:
      return motion::steady_frame(body, sample.t);
  }
  return {};
}

}  // namespace twrench::scene
