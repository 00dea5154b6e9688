#include "scene/speed_curve.h"

#include <algorithm>
#include <cmath>

namespace twrench::scene {

double SpeedCurve::at(double time) const {
  const auto next = std::ranges::lower_bound(points, time, {}, &Point::time);
  if (next == points.begin()) return points.front().speed;
  if (next == points.end()) return points.back().speed;
  const Point& last = *std::prev(next);
  return std::lerp(last.speed, next->speed, (time - last.time) / (next->time - last.time));
}

double SpeedCurve::integral(double time) const {
  // The trapezoids between the points before `time`, and the rest to either side.
  double sum = points.front().speed * std::min(time, points.front().time);
  for (std::size_t i = 1; i < points.size() && points[i - 1].time < time; ++i) {
    const double end = std::min(time, points[i].time);
    sum += 0.5 * (points[i - 1].speed + at(end)) * (end - points[i - 1].time);
  }
  return sum + points.back().speed * std::max(0.0, time - points.back().time);
}

double SpeedCurve::fastest() const {
  return std::ranges::max_element(points, {}, &Point::speed)->speed;
}

}  // namespace twrench::scene
