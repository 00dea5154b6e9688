// A plotting tool: prints tables for gnuplot, separated by blank lines. They are the components of
// omega over time, the curves of constant energy on the sphere of directions of L, and the time of
// the first flip over the initial tilt. The caller provides the arrays, in row-major order as in
// NumPy.
#include <twrench/twrench.h>

#include <cstdio>
#include <numbers>
#include <vector>

using namespace twrench;

int main() {
  const Eigen::Vector3d moments(722.671030, 982.271303, 1578.650308);  // g cm^2
  const motion::FreeBody body(moments.asDiagonal(), {0.05, 1, 0});     // rad/s

  std::vector<double> times;
  for (int i = 0; i <= 24; ++i) times.push_back(i);
  std::vector<double> X(9 * times.size()), omega(3 * times.size());
  motion::ExactMotion(body).at(times, X, omega);
  std::puts("# t in s, omega in rad/s, and where the body's y axis points");
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Eigen::Vector3d y = motion::attitude_at(X, i).col(1);
    std::printf("%g %.17g %.17g %.17g %.17g %.17g %.17g\n", times[i], omega[3 * i],
                omega[3 * i + 1], omega[3 * i + 2], y.x(), y.y(), y.z());
  }

  std::puts("\n\n# curves of constant energy: the direction of L in principal axes");
  for (const motion::EnergyLevel& level : motion::level_family(moments, 2)) {
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d mu = level.at(2 * std::numbers::pi * i / 8);
      std::printf("%.17g %.17g %.17g\n", mu.x(), mu.y(), mu.z());
    }
    const motion::Annulus annulus = motion::herpolhode_annulus(level);
    std::printf("# herpolhode from %.17g to %.17g\n", annulus.inner, annulus.outer);
  }

  std::puts("\n\n# tilt in rad, first flip in s");
  std::vector<double> tilts, starts;
  for (double tilt = 0.1; tilt > 1e-6; tilt /= 10) {
    tilts.push_back(tilt);
    starts.insert(starts.end(), {tilt, 1, 0});
  }
  std::vector<double> first(tilts.size());
  motion::first_flip_times({{moments.data(), 3}, starts}, first);
  for (std::size_t i = 0; i < tilts.size(); ++i) std::printf("%.17g %.17g\n", tilts[i], first[i]);
}
