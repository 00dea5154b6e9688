#include "table/aem_xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "base/words.h"
#include "system/error.h"
#include "system/file_kind.h"
#include "table/aem_header.h"
#include "table/calendar.h"
#include "table/number_text.h"

namespace twrench::table {
namespace {

/// The name without the prefix of its namespace.
std::string_view name_without_prefix(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::vector<pugi::xml_node> elements(const pugi::xml_node& parent) {
  std::vector<pugi::xml_node> found;
  for (const pugi::xml_node& node : parent.children()) {
    if (node.type() == pugi::node_element && name_without_prefix(node) != "COMMENT")
      found.push_back(node);
  }
  return found;
}

std::vector<pugi::xml_node> elements(const pugi::xml_node& parent, std::string_view name) {
  std::vector<pugi::xml_node> found = elements(parent);
  std::erase_if(found, [&](const auto& node) { return name_without_prefix(node) != name; });
  return found;
}

/// The text of an element in one line.
std::string text_of(const pugi::xml_node& node) {
  std::string text;
  for (const std::string& word : words_of(std::string(node.text().get())))
    text += (text.empty() ? "" : " ") + word;
  return text;
}

/// A value of a row with the keyword that it has in the other notation.
struct XmlValue {
  std::string keyword, text, unit;
};

/// Version 1.0 has <rotation1 angle="Z_ANGLE"> in <rotationAngles> for the first rotation, and the
/// same with rate="Z_RATE" in <rotationRates>.
std::string keyword_of(const pugi::xml_node& node) {
  const std::string_view name = name_without_prefix(node);
  const std::string_view group = name_without_prefix(node.parent());
  if (!name.starts_with("rotation") || name.size() != 9) return std::string(name);
  const char number = name.back();
  if (group == "rotationAngles") return fmt::format("ANGLE_{}", number);
  const std::string rate = node.attribute("rate").value();
  if (!rate.empty() && name_without_prefix(node.parent().parent()) == "quaternionEulerRate")
    return rate;
  return number >= '1' && number <= '3' ? fmt::format("{}_RATE", "XYZ"[number - '1']) : "";
}

/// Reads one row after the other.
class XmlRows {
 public:
  XmlRows(std::string file, std::string& text) : file_(std::move(file)), text_(&text) {}

  void add_segment(const pugi::xml_node& segment, const std::string& version);
  std::size_t segments() const { return segments_; }

 private:
  void add_row(const pugi::xml_node& state, const AemLayout& layout);
  system::FileError bad_row(const std::string& why) const {
    return {fmt::format("{}: row {}", file_, rows_), why,
            "correct the row, or the ATTITUDE_TYPE of the metadata"};
  }
  void require_axis(const pugi::xml_node& node, const AemLayout& layout) const;
  void require_unit(const pugi::xml_node& node, const AemValue& value) const;

  std::string file_;
  std::string* text_;
  std::size_t segments_ = 0, rows_ = 0;
};

void XmlRows::add_segment(const pugi::xml_node& segment, const std::string& version) {
  ++segments_;
  AemMetadata metadata{
      fmt::format("{}: segment {}", file_, segments_), version.starts_with("1"), {}};
  *text_ += "META_START\n";
  for (const pugi::xml_node& group : elements(segment, "metadata")) {
    for (const pugi::xml_node& node : elements(group)) {
      const std::string keyword(name_without_prefix(node));
      metadata.values[keyword] = text_of(node);
      *text_ += fmt::format("{} = {}\n", keyword, metadata.values[keyword]);
    }
  }
  *text_ += "META_STOP\nDATA_START\n";
  const AemLayout layout = aem_layout(metadata);
  for (const pugi::xml_node& data : elements(segment, "data")) {
    for (const pugi::xml_node& state : elements(data, "attitudeState")) {
      ++rows_;
      add_row(state, layout);
    }
  }
  *text_ += "DATA_STOP\n";
}

void XmlRows::add_row(const pugi::xml_node& state, const AemLayout& layout) {
  std::map<std::string, pugi::xml_node> nodes;
  const auto add = [&](const pugi::xml_node& node) {
    const std::string keyword = keyword_of(node);
    if (!nodes.emplace(keyword, node).second) {
      throw bad_row(fmt::format("it has more than one {}", keyword));
    }
  };
  for (const pugi::xml_node& form : elements(state)) {
    for (const pugi::xml_node& node : elements(form)) {
      const std::vector<pugi::xml_node> inner = elements(node);
      if (inner.empty()) add(node);
      for (const pugi::xml_node& value : inner) add(value);
    }
  }
  const auto take = [&](const std::string& keyword) {
    const auto found = nodes.find(keyword);
    if (found == nodes.end()) throw bad_row(fmt::format("it has no {}", keyword));
    const pugi::xml_node node = found->second;
    nodes.erase(found);
    return node;
  };
  const std::string epoch = text_of(take("EPOCH"));
  Number number;
  if (read_calendar(epoch, number) != Calendar::date_time) {
    throw bad_row(fmt::format("its EPOCH is '{}'", epoch.substr(0, 40)));
  }
  *text_ += epoch;
  for (const AemValue& value : layout.values) {
    const pugi::xml_node node = take(value.keyword);
    require_axis(node, layout);
    require_unit(node, value);
    const std::string text = text_of(node);
    if (text.empty() || text.find(' ') != std::string::npos) {
      throw bad_row(fmt::format("its {} is '{}'", value.keyword, text.substr(0, 40)));
    }
    *text_ += ' ' + text;
  }
  *text_ += '\n';
  if (nodes.empty()) return;
  throw bad_row(
      fmt::format("it has {}, which is not a value of its ATTITUDE_TYPE", nodes.begin()->first));
}

/// Throws if the axis of a rotation is not that of the sequence.
void XmlRows::require_axis(const pugi::xml_node& node, const AemLayout& layout) const {
  const std::string stated = to_lower(node.attribute("angle").value());
  const auto rotation = static_cast<std::size_t>(name_without_prefix(node).back() - '1');
  if (stated.empty() || rotation >= layout.sequence.size()) return;
  if (stated.front() == layout.sequence[rotation]) return;
  throw bad_row(fmt::format("its rotation {} is {}, but the EULER_ROT_SEQ is {}", rotation + 1,
                            node.attribute("angle").value(), layout.sequence));
}

void XmlRows::require_unit(const pugi::xml_node& node, const AemValue& value) const {
  const std::string unit = node.attribute("units").value();
  if (unit.empty() || to_lower(unit) == value.unit) return;
  throw bad_row(fmt::format("the unit of its {} is {}, but the standard has {}", value.keyword,
                            unit, value.unit.empty() ? "none" : value.unit));
}

/// The messages: the root, or the elements of an <ndm>.
std::vector<pugi::xml_node> messages_in(const pugi::xml_document& document) {
  const pugi::xml_node root = document.document_element();
  if (name_without_prefix(root) == "aem") return {root};
  return name_without_prefix(root) == "ndm" ? elements(root, "aem") : std::vector<pugi::xml_node>();
}

std::string whole_text(const Input& input) {
  constexpr std::size_t most = std::size_t{64} << 20;
  if (input.size() > most) {
    throw system::FileError(input.name(), "the XML document is larger than 64 MiB",
                            "write the message as keywords and values, or in several files");
  }
  std::string text(input.size(), '\0');
  input.read(0, text.data(), text.size());
  return text;
}

}  // namespace

bool is_xml(std::string_view start) {
  start = system::without_byte_order_mark(start);
  start.remove_prefix(std::min(start.find_first_not_of(" \t\r\n"), start.size()));
  return start.starts_with("<?xml") || start.starts_with("<aem") || start.starts_with("<ndm");
}

Input aem_from_xml(const Input& input) {
  std::string source = whole_text(input);
  pugi::xml_document document;
  // Entities other than the five of XML are not expanded, and nothing else is loaded.
  const pugi::xml_parse_result parsed = document.load_buffer_inplace(
      source.data(), source.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed) {
    throw system::FileError(input.name(),
                            fmt::format("the XML document is cut off or damaged at byte {}: {}",
                                        parsed.offset, to_lower(parsed.description())),
                            "get the whole document");
  }
  auto text = std::make_shared<std::string>();
  XmlRows rows(input.name(), *text);
  std::string version;
  for (const pugi::xml_node& message : messages_in(document)) {
    const std::string its_version = message.attribute("version").value();
    if (version.empty()) *text += fmt::format("CCSDS_AEM_VERS = {}\n", version = its_version);
    if (its_version != version) {
      throw system::FileError(
          input.name(),
          fmt::format("it has messages of the versions {} and {}", version, its_version),
          "keep one of its <aem> elements");
    }
    for (const pugi::xml_node& body : elements(message, "body")) {
      for (const pugi::xml_node& segment : elements(body, "segment"))
        rows.add_segment(segment, version);
    }
  }
  if (rows.segments() > 0) return {input.name(), std::shared_ptr<const std::string>(text)};
  throw system::FileError(input.name(), "the file is an XML document without attitude ephemerides",
                          "of XML, the attitude ephemeris messages of CCSDS (AEM) are read");
}

}  // namespace twrench::table
