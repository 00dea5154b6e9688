#pragma once

#include <twrench/base/error.h>

namespace twrench::table {

/// A table that was read, but whose columns or values do not serve. What cannot be read at all, or
/// is no table, is a system::FileError.
class BadTable : public InvalidArgument {
 public:
  using InvalidArgument::InvalidArgument;
};

}  // namespace twrench::table
