#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "picture/hud/text_block.h"
#include "timeline/timeline.h"

// The texts that explain the picture, in UTF-8.
namespace twrench::picture::captions {

/// Returns the meaning of the component of an axis along its direction at t = 0; `starts_in_space`
/// states that this is the space axis of the same name. A body has a leg if one part lies along the
/// x axis on the positive side and reaches farther from the centre of mass than all others in that
/// direction or the opposite one.
std::string curve(const scene::Body& body, const std::string& axis, bool starts_in_space,
                  scene::Language language);

/// The remarks on a motion: around each flip of the method's own solution, that the body turns
/// over; once the matrix is 1 % off, that it is no rotation.
class Remarks {
 public:
  Remarks(const timeline::Solution& solution, scene::Language language);

  /// Returns the remark on that state of the motion.
  Remark at(const timeline::SolutionState& state) const;

 private:
  double share_of_flip(const motion::Sample& sample) const;

  scene::Language language_;
  std::optional<motion::ExactMotion::Flips> flips_;
  std::vector<double> flip_times_;
  Eigen::Vector3d axis_;      ///< The intermediate axis, in body axes.
  Eigen::Vector3d momentum_;  ///< L in space, of any length.
};

/// Returns the longest remark, which determines the room for one.
std::string longest_remark(scene::Language language);

}  // namespace twrench::picture::captions
