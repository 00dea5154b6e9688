#pragma once

#include <twrench/study/study.h>

#include <string>
#include <vector>

#include "app/options/command_line.h"
#include "app/options/command_model.h"
#include "app/terminal/error_report.h"

namespace twrench::app {

/// One-line description of the program in its help.
inline constexpr const char* about = "Turn a rigid body's equations of motion into a film";

// Each adds one command, whose callback does the work and throws an Error on failure.
void add_render(CLI::App& app);
void add_simulate(CLI::App& app);
void add_export(CLI::App& app);
void add_page(CLI::App& app);
void add_report(CLI::App& app);
void add_plot(CLI::App& app);
void add_inertia(CLI::App& app, ExitCode& code);
void add_study(CLI::App& app, ExitCode& code);
void add_encode(CLI::App& app);
void add_compare(CLI::App& app, ExitCode& code);
void add_check(CLI::App& app, ExitCode& code);
void add_doctor(CLI::App& app, ExitCode& code);
void add_methods(CLI::App& app);
void add_cases(CLI::App& app);
void add_scenes(CLI::App& app);
void add_schema(CLI::App& app);

/// Adds all commands and their common options.
void add_commands(CLI::App& app, ExitCode& code);

/// Returns a line for each scene, by name or file: its name, title and motion. The line of a scene
/// with a mistake has the mistake instead.
std::string scene_list(const std::vector<std::string>& names);

/// The options of the program and its commands, for manual pages and completions.
struct ProgramModel {
  Command program;
  std::vector<Command> commands;
};
ProgramModel program_model();

/// Runs the command that the arguments give, reports its error if it fails, and returns the exit
/// code.
ExitCode run(int argc, char** argv);

// Reports of a study. `scene` names the scene that was studied.

/// Returns tables for people to read.
std::string study_text(const study::Study& study, const std::string& scene);

/// Returns CSV with one line per run; a missing value is empty.
std::string study_csv(const study::Study& study);

/// Returns JSON with all results; a missing value is null.
std::string study_json(const study::Study& study, const std::string& scene);

}  // namespace twrench::app
