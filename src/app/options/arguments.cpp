#include "app/options/arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "base/words.h"

namespace twrench::app {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

}  // namespace

std::vector<std::string> parse_words(const std::string& text) { return split(text, ','); }

double parse_number(const std::string& text, const std::string& what) {
  const char* const end = text.data() + text.size();
  const char* begin = text.data();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') ++begin;
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end) {
    throw InvalidArgument(what, fmt::format("'{}' is not a number", text));
  }
  return value;
}

double parse_number(const std::string& text, const std::string& what,
                    const scene::limits::Limit& limit) {
  return scene::limits::check(limit, what, parse_number(text, what));
}

int parse_whole(const std::string& text, const std::string& what,
                const scene::limits::Limit& limit) {
  return scene::limits::check_whole(limit, what, parse_number(text, what));
}

std::vector<double> parse_numbers(const std::string& text, const std::string& what) {
  std::vector<double> values;
  for (const std::string& word : parse_words(text)) values.push_back(parse_number(word, what));
  return values;
}

Eigen::Vector3d parse_vector(const std::string& text, const std::string& what) {
  const std::vector<double> v = parse_numbers(text, what);
  if (v.size() == 3) return {v[0], v[1], v[2]};
  throw InvalidArgument(what, fmt::format("'{}' is not three numbers separated by commas", text));
}

Eigen::Vector4d parse_quaternion(const std::string& text, const std::string& what) {
  const std::vector<double> q = parse_numbers(text, what);
  if (q.size() == 4) return {q[0], q[1], q[2], q[3]};
  throw InvalidArgument(what, fmt::format("has {} numbers", q.size()),
                        "give the four of a quaternion, the scalar first");
}

Eigen::Matrix3d parse_inertia(const std::string& text, const std::string& what) {
  std::vector<double> v = parse_numbers(text, what);
  if (v.size() == 3) v.resize(6);
  if (v.size() != 6) {
    throw InvalidArgument(what,
                          fmt::format("'{}' is not three or six numbers separated by commas", text),
                          "give A,B,C or Ixx,Iyy,Izz,Ixy,Ixz,Iyz");
  }
  Eigen::Matrix3d inertia;
  inertia << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
  return scene::limits::check_inertia(what, inertia);
}

std::vector<Eigen::Vector3d> parse_vectors(const std::string& text, const std::string& what) {
  std::vector<Eigen::Vector3d> vectors;
  for (const std::string& word : split(text, ';')) vectors.push_back(parse_vector(word, what));
  return vectors;
}

Eigen::Vector2d parse_size(const std::string& text, const std::string& what) {
  const std::vector<std::string> words = split(text, 'x');
  if (words.size() != 2 || words[0].empty() || words[1].empty()) {
    throw InvalidArgument(what, fmt::format("'{}' is not WIDTHxHEIGHT", text), "such as 1920x1080");
  }
  return {parse_number(words[0], what), parse_number(words[1], what)};
}

std::vector<std::string> given_options(const CLI::App& command,
                                       const std::vector<std::string>& names) {
  std::vector<std::string> words;
  for (const std::string& name : names) {
    const CLI::Option& option = *command.get_option(name);
    if (option.count() == 0) continue;
    for (const std::string& value : option.results()) {
      // "--omega -1,0,0" would be an option's name.
      words.push_back(name + (value.starts_with('-') ? "=" + value : ""));
      if (!value.starts_with('-')) words.push_back(value);
    }
  }
  return words;
}

CLI::Validator one_of(const std::string& what, std::vector<std::string> names) {
  const std::string description = fmt::format("{{{}}}", fmt::join(names, ","));
  const auto check = [what, names = std::move(names)](const std::string& word) -> std::string {
    if (std::ranges::find(names, word) == names.end()) throw unknown_name(what, word, names);
    return {};
  };
  return {check, description};
}

CLI::Option* add_format_option(CLI::App& command, std::string& format,
                               const std::vector<std::string>& formats) {
  return command
      .add_option("--format", format,
                  fmt::format("output format: {} or {}",
                              fmt::join(formats.begin(), formats.end() - 1, ", "), formats.back()))
      ->check(one_of("--format", formats))
      ->type_name("FORMAT")
      ->capture_default_str()
      ->group(heading(OptionGroup::output));
}

void add_progress_option(CLI::App& command, std::string& style) {
  command
      .add_option("--progress", style,
                  "progress: auto, bar, plain, json, openjd or none; auto = bar on a terminal")
      ->check(one_of("--progress", {"auto", "bar", "plain", "json", "openjd", "none"}))
      ->type_name("STYLE")
      ->capture_default_str()
      ->group(heading(OptionGroup::run));
}

bool is_progress_json(const CLI::App& command) {
  const CLI::Option* const option = command.get_option_no_throw("--progress");
  return option != nullptr && option->count() > 0 && option->results().back() == "json";
}

void add_overwrite_option(CLI::App& command, bool& overwrite) {
  command
      .add_flag("--overwrite", overwrite,
                "replace existing files that twrench did not write, or that are of another kind")
      ->group(heading(OptionGroup::output));
}

void require_no_terminal(const std::string& example) {
  if (::isatty(STDOUT_FILENO) == 0) return;
  throw InvalidArgument("--output -", "standard output is a terminal",
                        "redirect it to a file or a program" + example);
}

OutputOptions::OutputOptions(CLI::App& command, const system::OutputKind& kind, Otherwise otherwise)
    : kind_(kind) {
  using Choice = system::OutputKind::Choice;
  const bool streams = kind.choice != Choice::files_only;
  CLI::Option* const output =
      command
          .add_option("-o,--output", path_,
                      fmt::format("output file, {}{}", system::listed_endings(kind),
                                  streams ? "; - for standard output" : ""))
          ->type_name("FILE")
          ->group(heading(OptionGroup::output));
  otherwise == Otherwise::none ? output->required() : output->capture_default_str();
  if (kind.has_format_option()) {
    std::vector<std::string> names;
    for (const system::OutputFormat& format : kind.formats) names.emplace_back(format.name);
    add_format_option(command, format_, names)
        ->default_str("the ending of the file" +
                      (kind.choice == Choice::by_default ? ", else " + names.front() : ""));
  }
  add_overwrite_option(command, overwrite_);
}

system::OutputFile OutputOptions::add_to(system::FileList& files,
                                         const system::OutputKind& kind) const {
  const system::OutputFile file = files.add_output(kind, path_, format_);
  if (path_ == "-" && file.format().is_binary) require_no_terminal();
  return file;
}

}  // namespace twrench::app
