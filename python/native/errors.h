#pragma once

#include <twrench/base/error.h>

#include <string>
#include <string_view>

namespace twrench::python {

/// A value that a scene cannot have: twrench.SceneError.
struct SceneError : InvalidArgument {
  explicit SceneError(const InvalidArgument& error) : InvalidArgument(error) {}
};

/// Calls `work` on a scene and converts InvalidArgument to SceneError.
template <typename Work>
auto on_scene(Work work) {
  try {
    return work();
  } catch (const InvalidArgument& error) {
    throw SceneError(error);
  }
}

/// Words an argument that a library mentions as one of Python: units="deg".
std::string argument_text(std::string_view name, std::string_view value);

/// Makes errors of the libraries reach Python as the exceptions of twrench.errors.
void register_errors();

}  // namespace twrench::python
