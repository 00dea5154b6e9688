#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/options/command_line.h"
#include "app/options/convention_options.h"
#include "app/options/recording_options.h"
#include "cases/case.h"
#include "check/verdict/problem.h"
#include "scene/scene.h"
#include "system/output.h"

namespace twrench::app {

/// The options of `check` that specify the motion to compare a file with, and how to read the file.
/// Must live as long as the command.
class CheckSetup {
 public:
  void add_options(CLI::App& command);

  /// Returns the body and the initial state. Throws InvalidArgument; warns about moments that no
  /// real body has.
  check::Problem problem() const;

  /// Returns how files are to be read, as far as the options determine it. Throws InvalidArgument.
  recording::Convention convention() const { return convention_.convention(); }

  /// Returns the rows that are judged. Throws InvalidArgument.
  recording::Extract extract() const { return extract_.extract(); }

  /// Adds the scene file, and all files that it names, to the inputs. Throws OverwriteError.
  void add_inputs(system::FileList& files) const;

 private:
  Eigen::Matrix3d inertia() const;
  /// Returns whether the inertia is fitted. Throws InvalidArgument if an option gives it, too.
  bool fits_inertia() const;
  /// Returns the case named by --case, if any. Throws InvalidArgument if another option also gives
  /// the body or the initial rates.
  std::optional<cases::Case> published_case() const;
  /// Loads the scene, and only once, because a pipe can be read only once.
  const scene::Scene& scene() const;

  std::string inertia_, scene_name_, case_name_, omega_, omega_at_ = "0", frame_ = "first", fit_;
  ExtractOptions extract_;
  ConventionOptions convention_;
  mutable std::optional<scene::Scene> scene_;  ///< Set by scene().
};

}  // namespace twrench::app
