#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "table/aem_header.h"
#include "table/input.h"
#include "table/line_reader.h"
#include "table/reader.h"

namespace twrench::table {

/// Metadata and data of one block of an attitude ephemeris message.
struct AemSegment {
  AemMetadata metadata;
  std::size_t meta_start = 0, data_start = 0, data_stop = 0;  ///< lines with these keywords
};

/// Reads the rows of an attitude ephemeris message (CCSDS 504.0-B, AEM) of version 1.0 or 2.0 in
/// the keyword = value notation, or converted to it from XML, of one object. Times are seconds
/// since 1970.
class AemReader : public Reader {
 public:
  /// Whether a text begins like such a message.
  static bool recognizes(std::string_view start);

  /// `is_xml` is whether the message was converted: rows are then counted, because the lines are
  /// not those of the file.
  AemReader(Input input, bool is_xml);

  void begin_pass(std::span<const std::size_t> columns) override;
  bool next(std::span<Number> numbers) override;
  std::string place() const override;

 private:
  void find_segments();
  bool next_line(std::string_view& line);
  std::string remedy_for_segments() const;
  void require_one_object() const;

  Input input_;
  bool is_xml_;
  LineReader lines_;
  AemLayout layout_;
  std::vector<AemSegment> segments_;
  std::size_t row_ = 0;               ///< read last, from 1
  std::size_t segment_ = 0;           ///< of this row
  bool begins_segment_ = false;       ///< whether the line read last is the first of another one
  std::optional<double> last_epoch_;  ///< of the row read last
  std::vector<std::size_t> selected_;
  std::vector<std::string_view> cells_;
};

}  // namespace twrench::table
