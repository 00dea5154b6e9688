#include "table/aem_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "system/error.h"
#include "system/file_kind.h"
#include "table/calendar.h"
#include "table/error.h"
#include "table/number_text.h"

namespace twrench::table {
namespace {

constexpr std::string_view version_keyword = "CCSDS_AEM_VERS";

/// A line "KEYWORD = value", or a keyword alone.
struct KeywordLine {
  std::string keyword, value;
};

KeywordLine keyword_line(std::string_view line) {
  const std::size_t equals = line.find('=');
  const bool has_value = equals != std::string_view::npos;
  return {std::string(trimmed(line.substr(0, equals))),
          has_value ? std::string(trimmed(line.substr(equals + 1))) : std::string()};
}

bool is_comment_of_message(std::string_view line) {
  return trimmed(line).empty() || trimmed(line).starts_with("COMMENT");
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  for (std::size_t at = line.find_first_not_of(" \t"); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    cells.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(" \t", end);
  }
}

/// The metadata that rows of one table have in common.
std::vector<std::string> common_metadata(const AemSegment& segment) {
  std::vector<std::string> values;
  for (const char* keyword :
       {"OBJECT_NAME", "OBJECT_ID", "REF_FRAME_A", "REF_FRAME_B", "ATTITUDE_DIR", "TIME_SYSTEM",
        "ATTITUDE_TYPE", "QUATERNION_TYPE", "EULER_ROT_SEQ", "RATE_FRAME", "ANGVEL_FRAME"}) {
    const auto found = segment.metadata.values.find(keyword);
    values.push_back(found == segment.metadata.values.end() ? std::string() : found->second);
  }
  return values;
}

void convert(const AemValue& value, Number& number) {
  if (value.sign == 1 && value.offset == 0) return;
  number.value = value.offset + value.sign * number.value;
  number.rest *= value.sign;
}

std::string object_of(const AemSegment& segment) {
  const auto name = segment.metadata.values.find("OBJECT_NAME");
  return name == segment.metadata.values.end() ? "an object without a name" : name->second;
}

}  // namespace

bool AemReader::recognizes(std::string_view start) {
  return trimmed(system::without_byte_order_mark(start)).starts_with(version_keyword);
}

AemReader::AemReader(Input input, bool is_xml)
    : input_(std::move(input)), is_xml_(is_xml), lines_(input_) {
  header_.file = input_.name();
  find_segments();
  if (segments_.empty()) throw BadTable(header_.file, "it has no data");
  require_one_object();
  layout_ = aem_layout(segments_.front().metadata);
  header_.sequence = layout_.sequence;
  header_.states_inverse = layout_.states_inverse;
  header_.names = {"t"};
  header_.units = {"s"};
  for (const AemValue& value : layout_.values) {
    header_.names.push_back(value.column);
    header_.units.push_back(value.unit);
  }
}

void AemReader::find_segments() {
  const auto cut_off = [&](const char* missing) {
    return system::FileError(header_.file, fmt::format("it is cut off: {} is missing", missing),
                             "get the whole message");
  };
  bool in_metadata = false, in_data = false, is_version_1 = false;
  std::string_view line;
  while (lines_.next(line)) {
    if (is_comment_of_message(line)) continue;
    if (in_data && !trimmed(line).starts_with("DATA_STOP")) continue;
    const auto [keyword, value] = keyword_line(line);
    if (keyword == version_keyword) is_version_1 = value.starts_with("1");
    if (keyword == "META_START")
      segments_.push_back({{lines_.place(), is_version_1, {}}, lines_.number(), 0, 0});
    if (keyword == "META_STOP") in_metadata = false;
    if (in_metadata) segments_.back().metadata.values[keyword] = value;
    if (keyword == "META_START") in_metadata = true;
    if (keyword != "DATA_START" && keyword != "DATA_STOP") continue;
    if (segments_.empty()) throw cut_off("META_START");
    in_data = keyword == "DATA_START";
    (in_data ? segments_.back().data_start : segments_.back().data_stop) = lines_.number();
  }
  for (const AemSegment& segment : segments_) {
    if (segment.data_start == 0) throw cut_off("DATA_START");
    if (segment.data_stop == 0) throw cut_off("DATA_STOP");
  }
}

/// A command for each of the first segments that writes it alone.
std::string AemReader::remedy_for_segments() const {
  if (is_xml_) return "keep one of its <segment> elements";
  constexpr std::size_t most = 3;
  std::vector<std::string> commands;
  for (std::size_t i = 0; i < std::min(most, segments_.size()); ++i) {
    const AemSegment& segment = segments_[i];
    commands.push_back(fmt::format("sed -n '1,{}p;{},{}p' '{}' > segment-{}.aem",
                                   segments_.front().meta_start - 1, segment.meta_start,
                                   segment.data_stop, header_.file, i + 1));
  }
  return fmt::format("keep one: {}{}", fmt::join(commands, "; or "),
                     segments_.size() > most ? " ..." : "");
}

void AemReader::require_one_object() const {
  const auto common = common_metadata(segments_.front());
  const auto is_alike = [&](const AemSegment& s) { return common_metadata(s) == common; };
  if (std::ranges::all_of(segments_, is_alike)) return;
  std::vector<std::string> objects;
  for (const AemSegment& segment : segments_) {
    const std::string object = object_of(segment);
    if (std::ranges::find(objects, object) == objects.end()) objects.push_back(object);
  }
  throw BadTable(header_.file,
                 objects.size() > 1
                     ? fmt::format("its {} segments are of {} objects: {}", segments_.size(),
                                   objects.size(), fmt::join(objects, ", "))
                     : fmt::format("its {} segments of {} have different frames or attitudes",
                                   segments_.size(), objects.front()),
                 remedy_for_segments());
}

void AemReader::begin_pass(std::span<const std::size_t> columns) {
  lines_ = LineReader(input_);
  selected_.assign(columns.begin(), columns.end());
  row_ = 0;
  segment_ = 0;
  last_epoch_.reset();
  begins_segment_ = false;
}

std::string AemReader::place() const {
  return is_xml_ ? fmt::format("{}: row {}", header_.file, row_) : lines_.place();
}

bool AemReader::next_line(std::string_view& line) {
  while (segment_ < segments_.size() && lines_.next(line)) {
    const AemSegment& segment = segments_[segment_];
    if (lines_.number() == segment.data_stop) {
      ++segment_;
      begins_segment_ = true;
    } else if (lines_.number() > segment.data_start && !is_comment_of_message(line)) {
      ++row_;
      return true;
    }
  }
  return false;
}

bool AemReader::next(std::span<Number> numbers) {
  std::string_view line;
  Number epoch;
  do {
    if (!next_line(line)) return false;
    split_at_blanks(line, cells_);
    if (cells_.size() != header_.names.size()) {
      throw system::FileError(
          place(),
          fmt::format("the row has {} values, but {} are due", cells_.size(), header_.names.size()),
          "correct the row, or the ATTITUDE_TYPE of the metadata");
    }
    if (read_calendar(cells_[0], epoch) != Calendar::date_time)
      throw no_number(place(), "t", cells_[0]);
    // A segment often begins with the last instant of the one before.
  } while (std::exchange(begins_segment_, false) && last_epoch_ == epoch.value + epoch.rest);
  last_epoch_ = epoch.value + epoch.rest;
  for (std::size_t i = 0; i < selected_.size(); ++i) {
    const std::size_t column = selected_[i];
    if (column == 0) {
      numbers[i] = epoch;
      continue;
    }
    switch (read_number(cells_[column], false, numbers[i])) {
      case table::Reading::number:
        convert(layout_.values[column - 1], numbers[i]);
        break;
      case table::Reading::too_large:
        throw too_large(place(), header_.names[column], cells_[column]);
      case table::Reading::text:
        throw no_number(place(), header_.names[column], cells_[column]);
    }
  }
  return true;
}

}  // namespace twrench::table
