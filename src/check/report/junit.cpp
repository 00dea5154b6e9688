#include <fmt/format.h>

#include <algorithm>

#include "base/enumeration.h"
#include "check/report/report.h"
#include "text/escape.h"

namespace twrench::check {
namespace {

std::string bound_case(const CheckedFile& file, const CheckBound& bound,
                       const std::string& verdict_text) {
  std::string name = bound.argument;
  std::ranges::replace(name, '_', '-');
  const std::string start = fmt::format(
      "    <testcase classname=\"{}\" name=\"{} {:.6g}{}{}\"", text::escape_xml(file.name), name,
      bound.most, bound.unit.empty() ? "" : " ", text::escape_xml(bound.unit));
  if (!bound.is_exceeded()) return start + "/>\n";
  return fmt::format(
      "{}>\n      <failure type=\"exceeded\" message=\"{}{}{}: {}\"/>\n    </testcase>\n", start,
      change_text("{:.6g}", bound.value), bound.unit.empty() ? "" : " ",
      text::escape_xml(bound.unit), verdict_text);
}

/// Without bounds, the only test case is whether the file follows the motion.
std::string follows_case(const CheckedFile& file, const std::string& verdict_text) {
  const std::string start =
      fmt::format("    <testcase classname=\"{}\" name=\"follows the exact motion\"",
                  text::escape_xml(file.name));
  if (passes(file)) return start + "/>\n";
  return fmt::format("{}>\n      <failure type=\"{}\" message=\"{}\"/>\n    </testcase>\n", start,
                     enumerator_name(verdict(file).finding), verdict_text);
}

std::string cases(const CheckedFile& file, const std::string& verdict_text) {
  if (file.bounds.empty()) return follows_case(file, verdict_text);
  std::string text;
  for (const CheckBound& bound : file.bounds) text += bound_case(file, bound, verdict_text);
  return text;
}

std::size_t tests(const CheckedFile& file) { return std::max<std::size_t>(1, file.bounds.size()); }

std::size_t failures(const CheckedFile& file) {
  if (file.bounds.empty()) return passes(file) ? 0 : 1;
  return static_cast<std::size_t>(std::ranges::count_if(file.bounds, &CheckBound::is_exceeded));
}

std::string suite(const CheckedFile& file, const ArgumentWording& wording) {
  const std::string verdict_text = text::escape_xml(with_arguments(verdict(file).text, wording));
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n{}"
      "    <system-out>{}</system-out>\n  </testsuite>\n",
      text::escape_xml(file.name), tests(file), failures(file), cases(file, verdict_text),
      verdict_text);
}

}  // namespace

std::string check_junit(const CheckResult& result, const ArgumentWording& wording) {
  std::size_t all = 0, failed = 0;
  std::string suites;
  for (const CheckedFile& file : result.files) {
    all += tests(file);
    failed += failures(file);
    suites += suite(file, wording);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"twrench check\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n{}"
      "</testsuites>\n",
      all, failed, suites);
}

}  // namespace twrench::check
