#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "table/input.h"
#include "table/line_reader.h"
#include "table/reader.h"

namespace twrench::table {

/// Metadata and data of one block of an attitude ephemeris message.
struct AemSegment {
  std::map<std::string, std::string> metadata;
  std::size_t meta_start = 0, data_start = 0, data_stop = 0;  ///< lines with these keywords
};

/// Reads the rows of an attitude ephemeris message (CCSDS 504.0-B, AEM) of version 1.0 or 2.0 in
/// the keyword = value notation, of one object. Times are seconds since 1970.
class AemReader : public Reader {
 public:
  /// Whether a text begins like such a message.
  static bool recognizes(std::string_view start);

  explicit AemReader(Input input);

  void begin_pass(std::span<const std::size_t> columns) override;
  bool next(std::span<Number> numbers) override;
  std::string place() const override { return lines_.place(); }

 private:
  void find_segments();
  bool next_line(std::string_view& line);
  std::string remedy_for_segments() const;
  void require_one_object() const;

  Input input_;
  LineReader lines_;
  std::string version_;
  std::vector<AemSegment> segments_;
  std::size_t segment_ = 0;           ///< of the row read last
  bool begins_segment_ = false;       ///< whether the line read last is the first of another one
  std::optional<double> last_epoch_;  ///< of the row read last
  std::vector<std::size_t> selected_;
  std::vector<std::string_view> cells_;
};

}  // namespace twrench::table
