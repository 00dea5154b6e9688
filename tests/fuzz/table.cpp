// Tables: CSV, JSON and NumPy files, and the trajectories in them.
#include <twrench/base/error.h>

#include <Eigen/LU>
#include <limits>
#include <string_view>

#include "recording/columns/open_conventions.h"
#include "recording/recording.h"
#include "recording/time_choice.h"
#include "system/error.h"
#include "table/reader.h"
#include "target.h"

namespace {

using namespace twrench;

void read_rows(const recording::Recording& recording, const recording::Convention& convention) {
  recording::RowReader reader = recording.rows(convention);
  double last = -std::numeric_limits<double>::infinity();
  for (recording::Row row; reader.next(row);) {
    require(row.t > last, "times ascend");
    require(row.omega.allFinite() && row.X.allFinite(), "numbers are finite");
    require(row.X.determinant() > 0, "an attitude is no reflection");
    last = row.t;
  }
  require(reader.time_resolution().at(1) > 0, "times have a resolution");
  require(reader.rate_resolution().at(1) > 0, "rates have a resolution");
}

void read_table(std::string_view bytes) {
  const recording::Recording recording(table::open_table("input", bytes));
  require(!recording.header().names.empty(), "a table has columns");
  for (const recording::Convention& convention :
       recording::with_times(recording, recording::conventions(recording.header(), {}))) {
    const auto columns = recording::format_columns(convention.columns);
    require(recording::parse_columns(columns, "columns") == convention.columns,
            "columns are read back");
    read_rows(recording, convention);
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read_table({reinterpret_cast<const char*>(data), size});
  } catch (const InvalidArgument&) {
  } catch (const system::FileError&) {
  }
  return 0;
}
