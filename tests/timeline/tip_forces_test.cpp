#include "timeline/tip_forces.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/rotating_frame.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench::timeline {
namespace {

using body::PrincipalAxes;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The moments of the T-wrench, of Tao's disc, and of others, also with two nearly alike.
const Vector3d moments_of_bodies[]{
    {723.26, 982.27, 1578.65}, {348, 1104, 1434}, {3, 4, 5}, {1, 10, 10.5}, {5, 5.5, 9},
    {1e-12, 2e-12, 2.5e-12}};

/// Returns a body, in axes that are not its principal ones, that rotates at 1 rad/s about a
/// principal axis, with the momentum's deviations along the next two axes in units of |L|.
motion::FreeBody tilted(const Vector3d& moments, int axis, double next, double after_next) {
  const Matrix3d R = so3::exp(Vector3d(0.4, -1, 0.8));
  Vector3d momentum = Vector3d::Unit(axis) + next * Vector3d::Unit((axis + 1) % 3) +
                      after_next * Vector3d::Unit((axis + 2) % 3);
  momentum *= moments[axis];
  const Matrix3d product = R * moments.asDiagonal() * R.transpose();
  return {(product + product.transpose()) / 2, R * momentum.cwiseQuotient(moments)};
}

/// The components of the forces away from L.
struct Outward {
  double centrifugal, sum;
};

Outward outward(const motion::FreeBody& body, const motion::Sample& sample) {
  const TipForces forces(body);
  const auto [centrifugal, coriolis] = forces.at(sample);
  const Vector3d up = (body.inertia() * sample.omega).normalized();
  const Vector3d lean = forces.axis() - forces.axis().dot(up) * up;
  return {lean.dot(centrifugal), lean.dot(centrifugal + coriolis)};
}

TEST(TipForces, HaveTheTorquesOfTheForcesOnTheWholeBody) {
  for (const char* const name : {"dzhanibekov", "tao-disk", "hammer", "wing-nut"}) {
    scene::Scene scene = scene::load_scene(name);
    for (const Vector3d& omega : {Vector3d(1, 0.3, 0.2), {-0.3, 1, -0.4}, {0.1, 0.3, -1}}) {
      scene.motion.omega = omega;
      const motion::FreeBody body = scene::free_body(scene);
      const TipForces forces(body);
      const double size = body.inertia().norm();
      for (const double t : {0.0, 0.8, 5.0, 21.0}) {
        const motion::Sample sample = motion::ExactMotion(body).at(t);
        const motion::RotatingFrame frame = motion::steady_frame(body, t);
        const motion::FrameForces whole(frame, body, sample);
        Vector3d centrifugal = Vector3d::Zero(), coriolis = centrifugal;
        for (const body::Part& part : scene::visible_parts(scene.body)) {
          for (const auto& [mass, position] : body::equimomental_points(part)) {
            const motion::PointForces on = whole.on(mass, position);
            centrifugal += on.position.cross(on.centrifugal);
            coriolis += on.position.cross(on.coriolis);
          }
        }
        const Matrix3d R = frame.attitude.transpose() * sample.X;  // frame from body
        const Vector3d tip = R * forces.axis();
        const auto across = [&](const Vector3d& torque) -> Vector3d {
          return torque - torque.dot(tip) * tip;
        };
        const auto at_tip = forces.at(sample);
        EXPECT_LE((tip.cross(R * at_tip.centrifugal) - across(centrifugal)).norm(), 1e-9 * size);
        EXPECT_LE((tip.cross(R * at_tip.coriolis) - across(coriolis)).norm(), 1e-9 * size);
        EXPECT_NEAR(forces.axis().dot(at_tip.centrifugal), 0, 1e-9 * size);
        EXPECT_NEAR(forces.axis().dot(at_tip.coriolis), 0, 1e-9 * size);
      }
    }
  }
}

TEST(TipForces, AboutTheGreatestAxisTheCentrifugalForcePointsBack) {
  for (const Vector3d& moments : moments_of_bodies) {
    for (const double tilt : {1e-6, 1e-3, 0.1, 0.3}) {
      for (const double lean : {0.0, 1.0, 2.0, 3.0}) {
        const motion::FreeBody body =
            tilted(moments, PrincipalAxes::greatest, tilt * std::cos(lean), tilt * std::sin(lean));
        for (int i = 0; i < 40; ++i) {
          const auto [centrifugal, sum] = outward(body, motion::ExactMotion(body).at(0.3 * i));
          EXPECT_LT(centrifugal, 0);
          EXPECT_LT(sum, 0);
        }
      }
    }
  }
}

TEST(TipForces, AboutTheLeastAxisTheCentrifugalForcePointsOutAndCoriolisIsStronger) {
  for (const Vector3d& moments : moments_of_bodies) {
    for (const double tilt : {1e-6, 1e-3, 0.1, 0.3}) {
      for (const double lean : {0.0, 1.0, 2.0, 3.0}) {
        const motion::FreeBody body =
            tilted(moments, PrincipalAxes::least, tilt * std::cos(lean), tilt * std::sin(lean));
        for (int i = 0; i < 40; ++i) {
          const auto [centrifugal, sum] = outward(body, motion::ExactMotion(body).at(0.3 * i));
          EXPECT_GT(centrifugal, 0);
          EXPECT_LT(sum, 0) << moments.transpose() << ", tilt " << tilt;
        }
      }
    }
  }
}

TEST(TipForces, AboutTheMiddleAxisAllPointOutWhileTheTiltGrows) {
  for (const Vector3d& moments : moments_of_bodies) {
    // The growing part of the deviation: docs/theory.md, "Which axis is unstable".
    const int next = PrincipalAxes::greatest, after_next = PrincipalAxes::least;
    const double spin = moments[1], b = spin * (1 / moments[1] - 1 / moments[after_next]);
    const double rate = motion::stability(moments, PrincipalAxes::intermediate, 1).rate;
    const double size = std::hypot(b, rate);
    static_assert(next == (PrincipalAxes::intermediate + 1) % 3);
    for (const double tilt : {1e-6, 1e-3, 0.1}) {
      const motion::FreeBody body =
          tilted(moments, PrincipalAxes::intermediate, tilt * b / size, tilt * rate / size);
      const motion::ExactMotion exact(body);
      double before = 0;
      for (double t = 0;; t += 0.1 / rate) {
        const motion::Sample sample = exact.at(t);
        const double now = motion::Tilt(body).of(sample);
        if (now > 0.3) break;
        ASSERT_GT(now, before) << "it grows";
        before = now;
        const auto [centrifugal, sum] = outward(body, sample);
        EXPECT_GT(centrifugal, 0) << moments.transpose() << ", tilt " << now;
        EXPECT_GT(sum, 0) << moments.transpose() << ", tilt " << now;
      }
      EXPECT_GT(before, 0.2);
    }
  }
}

TEST(TipForces, AreAtTheEndNearestToTheMomentum) {
  for (const double spin : {1.0, -1.0}) {
    const motion::FreeBody body(Vector3d(1, 2, 3).asDiagonal(), spin * Vector3d(0.1, 1, 0.1));
    EXPECT_EQ(TipForces(body).axis(), Vector3d(0, spin, 0));
  }
}

}  // namespace
}  // namespace twrench::timeline
