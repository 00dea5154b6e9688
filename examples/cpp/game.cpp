// A game: a spanner tumbles in a space station, and a player strikes it now and then. Each frame of
// 1/60 s takes one exact step, so that between strokes the motion neither gains nor loses energy.
#include <twrench/twrench.h>

#include <cstdio>

using namespace twrench;

namespace {

struct Spanner {
  motion::FreeBody body;

  void advance(double seconds) { body = motion::exact_step(body, seconds); }

  /// Applies an impulse, N s, at a point, both in body axes: L changes by r x p.
  void strike(const Eigen::Vector3d& r, const Eigen::Vector3d& p) {
    const Eigen::Vector3d omega = body.omega() + body.inverse() * r.cross(p);
    body = body.with_start(omega, body.attitude());
  }
};

void print(double t, const motion::FreeBody& body) {
  const Eigen::Quaterniond q(motion::Sample{t, body.attitude(), body.omega()}.quaternion());
  std::printf("%g s: attitude %.17g %.17g %.17g %.17g, energy %.17g J\n", t, q.w(), q.x(), q.y(),
              q.z(), motion::energy(body.inertia(), body.omega()));
}

}  // namespace

int main() {
  const Eigen::Vector3d moments(0.0012, 0.0021, 0.0022);  // kg m^2
  Spanner spanner{motion::FreeBody(moments.asDiagonal(), {1, 4, 0})};
  for (int frame = 0; frame <= 120; ++frame) {
    if (frame % 30 == 0) print(frame / 60.0, spanner.body);
    if (frame == 45) spanner.strike({0.08, 0, 0}, {0, 0, 0.02});
    spanner.advance(1.0 / 60);
  }
}
