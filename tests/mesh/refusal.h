#pragma once

#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <string>

#include "mesh/mesh_file.h"

namespace twrench::mesh {

/// Returns the exit code and the message with which a file of these bytes is rejected, or "nothing"
/// if it is accepted.
inline std::string refusal(const std::string& bytes, const std::string& name,
                           const ReadOptions& options = {.scale = 1.0}) {
  try {
    read_mesh(bytes, name, options);
  } catch (const InvalidArgument& error) {
    return std::string("2 ") + error.what();
  } catch (const system::FileError& error) {
    return std::string("5 ") + error.what();
  }
  return "nothing";
}

}  // namespace twrench::mesh
