#pragma once

#include <map>
#include <string>
#include <vector>

namespace twrench::table {

/// The metadata of one segment of an attitude ephemeris message (CCSDS 504.0-B, AEM).
struct AemMetadata {
  std::string place;  ///< of the segment, for messages
  bool is_version_1 = false;
  std::map<std::string, std::string> values;  ///< by keyword
};

/// One of the values of a row.
struct AemValue {
  std::string keyword;          ///< of the standard: "Q1"
  std::string column;           ///< its name in the table: "qx"
  std::string unit;             ///< "deg"; empty for quaternions
  double sign = 1, offset = 0;  ///< the table has offset + sign * value
};

/// The layout of the rows, as the metadata state it.
struct AemLayout {
  std::vector<AemValue> values;  ///< after the epoch, in the order of the message
  std::string sequence;          ///< of Euler angles, "zyx"; empty without
  bool states_inverse = false;   ///< whether the attitude is body from space
};

/// Returns the layout of a segment's rows. Rates whose meaning the standard leaves open get names
/// that are not those of rates. Throws system::FileError for attitudes that are not read.
AemLayout aem_layout(const AemMetadata& metadata);

}  // namespace twrench::table
