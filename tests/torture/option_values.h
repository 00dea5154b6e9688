#pragma once

#include <string>
#include <vector>

namespace twrench::torture {

/// A value for an option, or for an argument.
struct Value {
  std::string text;
  /// Whether the run may exceed the time of a case; SIGTERM must then end it.
  bool may_last = false;
};

/// Values of an option.
struct Values {
  std::vector<Value> sensible;  ///< a small run succeeds with these
  std::vector<Value> hostile;   ///< at and beyond limits, of the wrong kind, or inaccessible
};

/// Returns the values for the option `--NAME`, or for the argument NAME, of the command. The
/// command may read or write the playground's files. Unknown options get values of every kind.
const Values& values_for(const std::string& command, const std::string& name);

}  // namespace twrench::torture
