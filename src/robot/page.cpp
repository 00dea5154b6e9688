#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>

#include "base/enumeration.h"
#include "robot/report.h"
#include "text/escape.h"

namespace twrench::robot {
namespace {

constexpr std::string_view style =
    "body{font:16px/1.5 sans-serif;max-width:62rem;margin:2rem auto;padding:0 1rem;color:#222}"
    "table{border-collapse:collapse;width:100%}th,td{text-align:left;padding:.2rem .8rem;"
    "border-bottom:1px solid #ddd}td.n{text-align:right;font-variant-numeric:tabular-nums}"
    "figure{display:inline-block;width:46%;margin:.5rem 1rem .5rem "
    "0}img{max-width:100%;height:auto}"
    "figcaption{color:#555}.impossible{color:#a00}.doubtful{color:#850}";

std::string moments_of(const Eigen::Vector3d& moments) {
  return fmt::format("{:.4g}, {:.4g}, {:.4g}", moments[0], moments[1], moments[2]);
}

std::string row_of(const Link& link, const Diagnosis& diagnosis) {
  const std::string_view verdict = enumerator_name(diagnosis.verdict);
  const bool is_stated = diagnosis.verdict != Verdict::unstated;
  return fmt::format(
      "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
      "class=\"{}\">{}</td></tr>\n",
      text::escape_xml(link.name), is_stated ? fmt::format("{:.6g}", diagnosis.body.mass) : "",
      is_stated ? moments_of(diagnosis.moments) : "", verdict, verdict);
}

std::string figure(const std::string& picture, const std::string& caption) {
  if (picture.empty()) return {};
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", picture, caption);
}

/// The repair of each link that needs one, in one sentence, by the names of the links.
std::map<std::string, std::string> sentences_of(const Repair& repair,
                                                const ArgumentWording& wording) {
  std::map<std::string, std::string> sentences;
  for (const Change& change : repair.changes) {
    sentences[change.link] = fmt::format("Repair: the moments become {} kg m². Reason: {}.",
                                         moments_of(principal_moments(change.after.inertia)),
                                         text::escape_xml(change.reason));
  }
  for (const Unrepaired& link : repair.unrepaired) {
    sentences[link.link] =
        fmt::format("Not repaired: {}.", text::escape_xml(with_arguments(link.reason, wording)));
  }
  return sentences;
}

std::string section_of(const Link& link, const Diagnosis& diagnosis, const std::string& repair,
                       const LinkPictures& pictures) {
  return fmt::format(
      "<h2>{} <small>line {}</small></h2>\n<p>{}.</p>\n<p>{}</p>\n{}{}",
      text::escape_xml(link.name), link.line, text::escape_xml(verdict_text(diagnosis)), repair,
      figure(pictures.before, "as the file states it"), figure(pictures.after, "after the repair"));
}

}  // namespace

std::string robot_html(const JudgedRobot& judged, const Repair& repair,
                       const RobotPictures& pictures, const ArgumentWording& wording) {
  const std::string title = text::escape_xml(judged.robot.file.filename().string());
  const std::map<std::string, std::string> repairs = sentences_of(repair, wording);
  std::string rows, sections;
  for (const std::size_t i : worst_first(judged)) {
    const Link& link = judged.robot.links[i];
    const Diagnosis& diagnosis = judged.diagnoses[i];
    rows += row_of(link, diagnosis);
    if (!diagnosis.is_bad()) continue;
    const auto found = pictures.of_links.find(i);
    sections += section_of(link, diagnosis, repairs.at(link.name),
                           found == pictures.of_links.end() ? LinkPictures() : found->second);
  }
  const std::string left_out =
      pictures.left_out == 0
          ? ""
          : fmt::format(" The worst links have pictures; those of {} others are left out.",
                        pictures.left_out);
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
      "<meta name=\"generator\" content=\"twrench inertia\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>Inertia of {0}</title>\n<style>{1}</style>\n<h1>Inertia of {0}</h1>\n"
      "<p>{2} of {3} links are impossible, {4} are doubtful. A picture shows a link as a free "
      "body, "
      "in a shell of glass: the homogeneous ellipsoid with the same mass and moments. Where the "
      "moments are those of the link, it follows the shape.{7}</p>\n"
      "<table>\n<tr><th>link</th><th>mass, kg</th><th>principal moments, kg m²</th>"
      "<th>verdict</th></tr>\n{5}</table>\n{6}</html>\n",
      title, style, count(judged, Verdict::impossible), judged.robot.links.size(),
      count(judged, Verdict::doubtful), rows, sections, left_out);
}

}  // namespace twrench::robot
