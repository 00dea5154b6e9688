#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/random_bodies.h"

namespace twrench::motion {

struct BodyOfAKind {
  Eigen::Vector3d moments, omega;
};

/// Returns random bodies and bodies at and near every boundary between cases.
inline std::vector<BodyOfAKind> bodies_of_every_kind() {
  std::vector<BodyOfAKind> bodies = {{{1, 4, 6}, {2, 0, 1}},                // on the separatrix
                                     {{1, 4, 6}, {2, -0.7, 1}},             // on it, already moving
                                     {{1, 2, 3}, {1e-8, 1, 0}},             // 1e-16 from it
                                     {{1, 2, 3}, {0, 1, 3e-8}},             // on the other side
                                     {{1, 2, 3}, {1e-150, 1, 0}},           //
                                     {{1, 2, 2}, {1, 0.3, -0.2}},           // symmetric, prolate
                                     {{2, 2, 3}, {0.4, -0.1, 1}},           // oblate
                                     {{2, 2 + 1e-12, 3}, {0.4, -0.1, 1}},   // nearly
                                     {{1, 1 + 1e-9, 1 - 1e-9}, {1, 2, 3}},  // nearly a sphere
                                     {{1, 1, 1}, {1, 2, 3}},                // a sphere
                                     {{1, 2, 3}, {0, -2, 0}},               // steady spin
                                     {{1, 2, 3}, {0, 0, 0}},                // rest
                                     {{1e-9, 1, 1 + 1e-10}, {3, 0.1, 0.2}},  // a needle
                                     {{1, 1.0000001, 2}, {0.1, 0.2, 5}},     // a disc
                                     {{3, 1, 2}, {0.5, 1.5, -1}}};
  RandomBodies random;
  for (int n = 0; n < 60; ++n) bodies.push_back({random.moments(), random.omega()});
  return bodies;
}

}  // namespace twrench::motion
