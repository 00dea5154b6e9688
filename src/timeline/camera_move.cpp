#include "timeline/camera_move.h"

#include "timeline/smooth_share.h"

namespace twrench::timeline {

double CameraMove::share(double time) const { return smooth_share(time / length); }

double CameraMove::time_of(double t, double latest) const {
  const auto is_later = [&](double time) { return start + speed.integral(time) > t; };
  if (!is_later(latest)) return latest;
  double low = 0, high = latest;  // times before the start of the shot count as its start
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (is_later(middle) ? high : low) = middle;
  }
  return low;
}

}  // namespace twrench::timeline
