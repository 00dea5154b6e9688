#include "robot/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "base/enumeration.h"
#include "text/escape.h"

namespace twrench::robot {
namespace {

using Json = nlohmann::ordered_json;

std::string_view title_of(Format format) {
  switch (format) {
    case Format::urdf:
      return "URDF";
    case Format::sdf:
      return "SDF";
    case Format::mjcf:
      return "MJCF";
  }
  return {};
}

/// How many significant digits the moments of a link have.
int significant_digits(const Inertial& inertial) {
  double most = 2.0;
  for (const Written& entry : inertial.entries) {
    const double size = std::abs(entry.value);
    if (!(size > 0.0) || !std::isfinite(size) || entry.resolution == 0.0) continue;
    const double last = std::floor(std::log10(2 * entry.resolution));
    most = std::max(most, std::floor(std::log10(size)) - last + 1.0);
  }
  return static_cast<int>(std::min(most, 17.0));
}

std::string list_of(const Eigen::Vector3d& v, int digits) {
  return fmt::format("{:.{}g} {:.{}g} {:.{}g}", v[0], digits, v[1], digits, v[2], digits);
}

/// "to 0.02 %"
std::string within(double misfit) {
  constexpr double round_off = 1e-9;
  return misfit < round_off ? "to round-off" : fmt::format("to {:.2g} %", 100 * misfit);
}

std::string mistake_text(const Finding& mistake) {
  if (!mistake.misfit) return fmt::format("it would be possible if {}", mistake.text);
  if (!mistake.undone) {
    return fmt::format("{}: they fit {} {}", mistake.text, mistake.model, within(*mistake.misfit));
  }
  return fmt::format("{}: without this the moments are those of {} {}", mistake.text, mistake.model,
                     within(*mistake.misfit));
}

/// Why a link is not good, one line per reason.
std::vector<std::string> reasons(const Diagnosis& diagnosis) {
  std::vector<std::string> lines;
  for (const Finding& fault : diagnosis.faults) lines.push_back(fault.text);
  for (std::size_t i = 0; i < diagnosis.mistakes.size(); ++i)
    lines.push_back((i == 0 ? "" : "or, equally well: ") + mistake_text(diagnosis.mistakes[i]));
  return lines;
}

Json numbers(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

Json rows(const Eigen::Matrix3d& m) {
  return {numbers(m.row(0)), numbers(m.row(1)), numbers(m.row(2))};
}

Json finding_json(const Finding& finding) {
  Json json{{"fault", enumerator_name(finding.fault)}, {"text", finding.text}};
  if (finding.misfit) json["misfit"] = *finding.misfit, json["geometry"] = finding.model;
  if (finding.undone) {
    json["undone"] = {{"mass", finding.undone->mass}, {"inertia", rows(finding.undone->inertia)}};
  }
  return json;
}

Json link_json(const Link& link, const Diagnosis& diagnosis) {
  Json json{
      {"name", link.name}, {"line", link.line}, {"verdict", enumerator_name(diagnosis.verdict)}};
  if (diagnosis.verdict == Verdict::unstated) return json;
  json["mass"] = diagnosis.body.mass;
  json["centre_of_mass"] = numbers(diagnosis.body.centre);
  json["inertia"] = rows(diagnosis.body.inertia);
  json["principal_moments"] = numbers(diagnosis.moments);
  if (diagnosis.agreement) {
    json["agreement"] = {{"geometry", diagnosis.agreement->model},
                         {"misfit", diagnosis.agreement->misfit}};
  }
  json["faults"] = Json::array();
  for (const Finding& fault : diagnosis.faults) json["faults"].push_back(finding_json(fault));
  json["mistakes"] = Json::array();
  for (const Finding& mistake : diagnosis.mistakes)
    json["mistakes"].push_back(finding_json(mistake));
  return json;
}

using Row = std::array<std::string, 5>;

/// Returns the rows with columns as wide as their widest cell; the second one is to the right.
std::string table_of(const std::vector<Row>& rows) {
  std::array<std::size_t, 4> widths{24, 10, 30, 34};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    text += fmt::format("{:<{}} {:>{}}  {:<{}} {:<{}} {}\n", row[0], widths[0], row[1], widths[1],
                        row[2], widths[2], row[3], widths[3], row[4]);
  }
  return text;
}

Row link_row(const Link& link, const Diagnosis& diagnosis) {
  const std::string name = text::escape(link.name);
  const std::string verdict(enumerator_name(diagnosis.verdict));
  if (diagnosis.verdict == Verdict::unstated) return {name, "-", "-", "-", verdict};
  const int digits = link.inertial ? significant_digits(*link.inertial) : 6;
  const std::string remark = diagnosis.agreement
                                 ? fmt::format("{}: {} {}", verdict, diagnosis.agreement->model,
                                               within(diagnosis.agreement->misfit))
                                 : verdict;
  return {name, fmt::format("{:.6g}", diagnosis.body.mass), list_of(diagnosis.body.centre, 6),
          list_of(diagnosis.moments, digits), remark};
}

}  // namespace

std::size_t count(const JudgedRobot& judged, Verdict verdict) {
  return static_cast<std::size_t>(
      std::ranges::count(judged.diagnoses, verdict, &Diagnosis::verdict));
}

std::vector<std::size_t> worst_first(const JudgedRobot& judged) {
  std::vector<std::size_t> order(judged.diagnoses.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(),
                           [&](std::size_t i) { return judged.diagnoses[i].verdict; });
  return order;
}

std::string verdict_text(const Diagnosis& diagnosis) {
  std::string text(enumerator_name(diagnosis.verdict));
  std::string_view before = ": ";
  for (const std::string& reason : reasons(diagnosis)) {
    text += fmt::format("{}{}", before, reason);
    before = "; ";
  }
  return text;
}

std::string robot_text(const JudgedRobot& judged) {
  const Robot& robot = judged.robot;
  std::string text = fmt::format(
      "{} {}, {} links: {} impossible, {} doubtful, {} good, {} without mass properties\n",
      title_of(robot.format), text::escape(robot.name), robot.links.size(),
      count(judged, Verdict::impossible), count(judged, Verdict::doubtful),
      count(judged, Verdict::good), count(judged, Verdict::unstated));
  std::vector<Row> rows{
      {"link", "mass, kg", "centre of mass, m", "principal moments, kg m^2", "verdict"}};
  const std::vector<std::size_t> order = worst_first(judged);
  for (const std::size_t i : order) rows.push_back(link_row(robot.links[i], judged.diagnoses[i]));
  text += table_of(rows);
  for (const std::size_t i : order) {
    const std::vector<std::string> lines = reasons(judged.diagnoses[i]);
    if (lines.empty()) continue;
    text += fmt::format("\n{} (line {})\n", text::escape(robot.links[i].name), robot.links[i].line);
    for (const std::string& line : lines) text += fmt::format("  {}\n", text::escape(line));
  }
  return text;
}

std::string robot_json(const JudgedRobot& judged, const ArgumentWording& wording) {
  Json json{{"robot", judged.robot.name}, {"format", enumerator_name(judged.robot.format)}};
  json["units"] = {{"mass", "kg"}, {"length", "m"}, {"inertia", "kg m^2"}};
  for (const Verdict verdict : enumerators<Verdict>)
    json["counts"][enumerator_name(verdict)] = count(judged, verdict);
  json["links"] = Json::array();
  for (const std::size_t i : worst_first(judged))
    json["links"].push_back(link_json(judged.robot.links[i], judged.diagnoses[i]));
  json["notes"] = Json::array();
  for (const std::string& note : judged.notes)
    json["notes"].push_back(with_arguments(note, wording));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string robot_junit(const JudgedRobot& judged) {
  const std::string file = text::escape_xml(judged.robot.file.string());
  const std::size_t failed = count(judged, Verdict::impossible);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"twrench inertia\" tests=\"{0}\" failures=\"{1}\" errors=\"0\">\n"
      "  <testsuite name=\"{2}\" tests=\"{0}\" failures=\"{1}\" errors=\"0\">\n",
      judged.robot.links.size(), failed, file);
  for (const std::size_t i : worst_first(judged)) {
    const Diagnosis& diagnosis = judged.diagnoses[i];
    text += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", file,
                        text::escape_xml(judged.robot.links[i].name));
    const std::string sentence = text::escape_xml(verdict_text(diagnosis));
    if (diagnosis.verdict == Verdict::impossible) {
      text += fmt::format(
          ">\n      <failure type=\"impossible\" message=\"{}\"/>\n    </testcase>\n", sentence);
    } else if (diagnosis.verdict == Verdict::doubtful) {
      text += fmt::format(">\n      <system-out>{}</system-out>\n    </testcase>\n", sentence);
    } else {
      text += "/>\n";
    }
  }
  return text + "  </testsuite>\n</testsuites>\n";
}

std::string repair_text(const Repair& repair, const ArgumentWording& wording) {
  std::string text;
  for (const Change& change : repair.changes) {
    const Eigen::Vector3d before = principal_moments(change.before.inertia);
    const Eigen::Vector3d after = principal_moments(change.after.inertia);
    text += fmt::format("{}: {}", text::escape(change.link), text::escape(change.reason));
    if (!before.isApprox(after, 1e-9))
      text += fmt::format(": moments {} -> {} kg m^2", list_of(before, 6), list_of(after, 6));
    text += '\n';
  }
  for (const Unrepaired& link : repair.unrepaired)
    text += fmt::format("{}: not repaired: {}\n", text::escape(link.link),
                        text::escape(with_arguments(link.reason, wording)));
  return text;
}

}  // namespace twrench::robot
