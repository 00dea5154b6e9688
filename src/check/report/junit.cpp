#include <fmt/format.h>

#include <algorithm>

#include "base/enumeration.h"
#include "check/report/report.h"
#include "text/xml.h"

namespace twrench::check {
namespace {

std::string bound_case(const CheckedFile& file, const CheckBound& bound) {
  const std::string start =
      fmt::format("    <testcase classname=\"{}\" name=\"{} {:.6g}{}{}\"",
                  text::escape_xml(file.name), text::escape_xml(bound.option.substr(2)), bound.most,
                  bound.unit.empty() ? "" : " ", text::escape_xml(bound.unit));
  if (!bound.is_exceeded()) return start + "/>\n";
  return fmt::format(
      "{}>\n      <failure type=\"exceeded\" message=\"{}{}{}: {}\"/>\n    </testcase>\n", start,
      change_text("{:.6g}", bound.value), bound.unit.empty() ? "" : " ",
      text::escape_xml(bound.unit), text::escape_xml(verdict(file).text));
}

/// Without bounds, the only test case is whether the file follows the motion.
std::string follows_case(const CheckedFile& file) {
  const std::string start =
      fmt::format("    <testcase classname=\"{}\" name=\"follows the exact motion\"",
                  text::escape_xml(file.name));
  if (passes(file)) return start + "/>\n";
  const Verdict found = verdict(file);
  return fmt::format("{}>\n      <failure type=\"{}\" message=\"{}\"/>\n    </testcase>\n", start,
                     enumerator_name(found.finding), text::escape_xml(found.text));
}

std::string cases(const CheckedFile& file) {
  if (file.bounds.empty()) return follows_case(file);
  std::string text;
  for (const CheckBound& bound : file.bounds) text += bound_case(file, bound);
  return text;
}

std::size_t tests(const CheckedFile& file) { return std::max<std::size_t>(1, file.bounds.size()); }

std::size_t failures(const CheckedFile& file) {
  if (file.bounds.empty()) return passes(file) ? 0 : 1;
  return static_cast<std::size_t>(std::ranges::count_if(file.bounds, &CheckBound::is_exceeded));
}

std::string suite(const CheckedFile& file) {
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n{}"
      "    <system-out>{}</system-out>\n  </testsuite>\n",
      text::escape_xml(file.name), tests(file), failures(file), cases(file),
      text::escape_xml(verdict(file).text));
}

}  // namespace

std::string check_junit(const CheckResult& result) {
  std::size_t all = 0, failed = 0;
  std::string suites;
  for (const CheckedFile& file : result.files) {
    all += tests(file);
    failed += failures(file);
    suites += suite(file);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"twrench check\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n{}"
      "</testsuites>\n",
      all, failed, suites);
}

}  // namespace twrench::check
