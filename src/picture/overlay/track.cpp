#include "picture/overlay/track.h"

#include <cmath>

namespace twrench::picture {

using Eigen::Vector3d;

void draw_track(const timeline::SolutionState& instant, const TrackStyle& style,
                const std::function<Vector3d(const motion::Sample&)>& place,
                DrawList& translucent) {
  constexpr double dot = 1.15;  // radius in widths of the line
  std::vector<DrawList::Point> line;
  for (const motion::Sample& sample : instant.trail) {
    const double age = instant.trail_age(sample, style.trail_length);
    const double opacity = 0.9 * std::pow(1 - age, 1.4);
    const Vector3d point = place(sample);
    const double across = style.width * (1 - 0.6 * age) * translucent.pixels(point);
    line.push_back({point, across, {style.color, opacity}});
  }
  translucent.line_on_halo(line, style.halo);
  if (line.empty()) return;
  // The dot represents a ball. It is drawn at its near side, which arrows through it do not hide.
  const Vector3d& now = line.back().place;
  const Vector3d near = now + dot * style.width * (translucent.eye() - now).normalized();
  const double size = line.back().width;
  translucent.dot(near, dot * size + DrawList::halo_of(size), {style.halo, 0.9});
  translucent.dot(near, dot * size, {style.color, 1});
}

}  // namespace twrench::picture
