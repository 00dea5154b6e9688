#pragma once

#include <string>
#include <vector>

namespace twrench::torture {

/// A word for an option, or for a place on the command line.
struct Value {
  std::string text;
  /// It may well take longer than a case is given: what counts is that SIGTERM ends it.
  bool may_last = false;
};

/// What may stand after an option.
struct Values {
  std::vector<Value> sensible;  ///< with which a small run ends well
  std::vector<Value> hostile;   ///< at and beyond the edges, of the wrong kind, or not to be had
};

/// Those for the option `--NAME`, or for the argument NAME, of the command, which may read or write
/// what the playground has. An option that nobody thought of here gets values of every kind.
const Values& values_for(const std::string& command, const std::string& name);

}  // namespace twrench::torture
