#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "recording/columns/open_conventions.h"
#include "table/error.h"

namespace twrench::recording {

using Names = std::vector<std::string>;

inline table::Header header_of(Names names, Names units = {}) {
  return {"run.csv", std::move(names), std::move(units), {}, {}};
}

/// The columns of each reading, as the user would give them.
inline Names readings_of(const Names& names, const std::string& said = {}) {
  Convention told;
  told.columns = parse_columns(said, "columns");
  Names all;
  for (const Convention& convention : conventions(header_of(names), told)) {
    all.push_back(format_columns(convention.columns));
  }
  return all;
}

inline std::string refusal(const table::Header& header, const Convention& said) {
  try {
    conventions(header, said);
  } catch (const table::BadTable& error) {
    return std::string(error.what()) + " -- " + error.remedy();
  }
  return "no error";
}

inline std::string refusal(const Names& names, const std::string& said = {}) {
  Convention told;
  told.columns = parse_columns(said, "columns");
  return refusal(header_of(names), told);
}

/// The unit of the only reading.
inline std::optional<RateUnit> unit_in(const Names& names, const Names& units = {}) {
  const auto all = conventions(header_of(names, units), {});
  EXPECT_THAT(all, testing::SizeIs(1));
  return all.front().rate_unit;
}

}  // namespace twrench::recording
