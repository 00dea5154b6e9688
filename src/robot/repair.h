#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/diagnosis.h"

namespace twrench::robot {

/// A repaired link.
struct Change {
  std::size_t index = 0;  ///< The index of the link.
  std::string link;
  /// "the products of inertia have the other sign"
  std::string reason;
  LinkMass before, after;
};

/// A link that needs a repair but got none.
struct Unrepaired {
  std::string link, reason;
};

/// A robot description with other numbers.
struct Repair {
  /// The bytes of the file, which differ from the original only in the numbers of `changes`.
  std::string text;
  std::vector<Change> changes;
  std::vector<Unrepaired> unrepaired;
};

/// Returns the possible mass properties nearest to the given ones, with the same mass and centre:
/// the nearest second moments in the Frobenius norm (Higham, Linear Algebra Appl. 103 (1988) 103),
/// positive definite, which is the condition on the pseudo-inertia of Wensing, Kim and Slotine
/// (IEEE Robot. Autom. Lett. 3 (2018) 60).
LinkMass nearest_possible(const LinkMass& body);

/// Repairs each link that is impossible or whose moments a mistake explains: undoes the mistake, or
/// else takes the nearest possible moments. With `from_geometry`, links that no mistake explains
/// get the centre and the moments of the geometry with uniform density, also if they are only
/// doubtful.
Repair repair(const JudgedRobot& judged, bool from_geometry);

}  // namespace twrench::robot
