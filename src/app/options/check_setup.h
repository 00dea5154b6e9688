#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/options/command_line.h"
#include "cases/case.h"
#include "check/conventions/convention.h"
#include "check/verdict/problem.h"
#include "scene/scene.h"

namespace twrench::app {

/// The options of `check` that say what a file is held against and how it is read. Must live as
/// long as the command.
class CheckSetup {
 public:
  void add_options(CLI::App& command);

  /// Returns the body and the initial state. Throws InvalidArgument; warns about moments that no
  /// real body has.
  check::Problem problem() const;

  /// Returns how the file is to be read. Throws InvalidArgument where its names leave that open,
  /// with the only reading that fits the physics as the remedy, if there is one.
  check::Convention convention(const std::string& file, const check::Problem& problem) const;

  /// Throws OverwriteError where `output` is the scene file.
  void require_not_input(const std::filesystem::path& output) const;

 private:
  check::Convention said() const;
  Eigen::Matrix3d inertia() const;
  /// Returns the case of --case, if that is given. Throws InvalidArgument if another option gives
  /// the body or the initial rates too.
  std::optional<cases::Case> published_case() const;
  /// Loads the scene, and only once, because a pipe can be read only once.
  const scene::Scene& scene() const;

  std::string inertia_, scene_name_, case_name_, omega_, omega_at_ = "0", frame_ = "first";
  bool fit_ = false;
  std::string columns_, time_unit_, units_, angle_units_, sequence_, rates_ = "body", axes_,
                                                                     offset_;
  bool inverse_ = false;
  mutable std::optional<scene::Scene> scene_;  ///< Set by scene().
};

}  // namespace twrench::app
