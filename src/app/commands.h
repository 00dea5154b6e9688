#pragma once

#include <CLI/CLI.hpp>

#include "base/error.h"

namespace twrench {

// Each adds one command, whose callback does the work and throws an Error when it cannot.
void add_render(CLI::App& app);
void add_simulate(CLI::App& app);
void add_inertia(CLI::App& app);
void add_encode(CLI::App& app);
void add_compare(CLI::App& app, ExitCode& code);
void add_methods(CLI::App& app);
void add_scenes(CLI::App& app);

inline void add_commands(CLI::App& app, ExitCode& code) {
  
  add_simulate(app);
  add_inertia(app);
  
  add_compare(app, code);
  add_methods(app);
  add_scenes(app);
}

}  // namespace twrench
