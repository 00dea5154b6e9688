// When does a spinning T-wrench turn over? A Runge-Kutta-Munthe-Kaas method integrates the free
// rotation on SO(3); a search on its own steps finds the instants at which the component of omega
// along the intermediate axis changes its sign. The closed form of the motion gives the same
// instants without integration.
#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>
#include <twrench/study/flip_search.h>

#include <cstdio>

using namespace twrench;

int main() {
  const Eigen::Vector3d moments(982.271303, 722.671030, 1578.650308);  // g cm^2
  const motion::FreeBody body(moments.asDiagonal(), {1, 0.05, 0});     // rad/s, body axes
  const motion::Method& method = motion::find_method("rkmk45");
  study::FlipSearch search(body, method);
  motion::visit_steps(body, method, {.tolerance = 1e-12}, 96,
                      [&](const motion::AcceptedStep& step) { search.visit(step); });
  for (const double t : search.times()) std::printf("integrated  %.6f s\n", t);
  for (const double t : motion::ExactMotion(body).flip_times(96)) {
    std::printf("exact       %.6f s\n", t);
  }
}
