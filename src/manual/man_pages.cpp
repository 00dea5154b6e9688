// Manual pages in the macros of man(7).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/options/scene_options.h"
#include "manual/manual.h"
#include "scene/fields.h"
#include "scene/keys.h"

namespace twrench::manual {
namespace {

using app::Command;
using app::Option;

/// Breaks long lines of filled text, which man joins again; short lines are the convention.
std::string with_short_lines(const std::string& page) {
  constexpr std::size_t longest = 78;
  std::string result;
  std::istringstream lines(page);
  bool filled = true;
  for (std::string line; std::getline(lines, line);) {
    if (line == ".nf") filled = false;
    if (line == ".fi") filled = true;
    while (filled && !line.starts_with('.') && line.size() > longest) {
      const std::size_t end = line.rfind(' ', longest);
      if (end == std::string::npos) break;
      result += line.substr(0, end) + "\n";
      line.erase(0, end + 1);
      if (line.starts_with('.') || line.starts_with('\'')) line.insert(0, "\\&");
    }
    result += line + "\n";
  }
  return result;
}

/// Escapes text for roff. A hyphen stays a hyphen, as in an option, instead of a dash.
std::string roff(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  const bool is_request = result.starts_with('.') || result.starts_with('\'');
  return is_request ? "\\&" + result : result;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string heading(const std::string& page, int section, const Release& release) {
  return fmt::format(".TH {} {} {} \"twrench {}\" \"twrench manual\"\n", roff(upper(page)), section,
                     release.date, release.version);
}

/// "Compute X" as a description after the name of the page: "compute X".
std::string as_clause(std::string description) {
  description[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(description[0])));
  return description;
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// "Text; the default is X."
std::string sentence(const std::string& help, const std::string& otherwise) {
  const std::string text = roff(capitalised(help)) + ".\n";
  return otherwise.empty() ? text : text + "Default: " + bold(otherwise) + ".\n";
}

std::string entry(const Option& option, bool is_argument) {
  std::vector<std::string> names;
  for (const std::string& name : option.names)
    names.push_back(is_argument ? italic(name) : bold(name));
  std::string left = fmt::format("{}", fmt::join(names, ", "));
  if (!is_argument && !option.placeholder.empty()) left += " " + italic(option.placeholder);
  return ".TP\n" + left + "\n" + sentence(option.help, option.otherwise);
}

std::string section(const std::string& title, const std::vector<Option>& options,
                    bool are_arguments) {
  std::string text;
  for (const Option& option : options) text += entry(option, are_arguments);
  return text.empty() ? text : ".SH " + title + "\n" + text;
}

/// Text with fixed line breaks, as in an example or a table.
std::string verbatim(std::string_view text) {
  std::string result = ".nf\n.RS 4\n";
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);)
    result += line.empty() ? ".sp\n" : roff(line) + "\n";
  return result + ".RE\n.fi\n";
}

/// The footer of --help, with separate sections for examples and for exit codes.
std::string footer_sections(const std::string& footer) {
  std::string notes, examples, status;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    constexpr std::string_view example = "Example: ";
    if (line.starts_with(example)) {
      examples += line.substr(example.size()) + "\n";
    } else if (line.starts_with("Exit code")) {
      status += roff(line) + "\n";
    } else {
      notes += roff(line) + "\n";
    }
  }
  std::string text;
  if (!notes.empty()) text += ".SH NOTES\n" + notes;
  if (!status.empty())
    text += ".SH EXIT STATUS\n" + status + "All codes are listed in\n.BR twrench (1).\n";
  if (!examples.empty()) text += ".SH EXAMPLES\n" + verbatim(examples);
  return text;
}

/// The form of a value in a scene file; `placeholder` represents a number or a string.
std::string value_form(scene::ValueForm::Kind kind, const std::string& placeholder) {
  using enum scene::ValueForm::Kind;
  switch (kind) {
    case number:
    case integer:
    case rate:
      return italic(placeholder);
    case vector:
      return "[" + italic("x") + ", " + italic("y") + ", " + italic("z") + "]";
    case quaternion:
      return "[" + italic("w") + ", " + italic("x") + ", " + italic("y") + ", " + italic("z") + "]";
    case size:
      return "[" + italic("width") + ", " + italic("height") + "]";
    case text:
      return "\"" + italic(placeholder) + "\"";
    case texts:
      return "[\"" + italic("name") + "\", ...]";
    case vectors:
      return "[[" + italic("x") + ", " + italic("y") + ", " + italic("z") + "], ...]";
    case flag:
      return "true|false";
  }
  return {};
}

/// The default of a key: its description or, if there is none, its value.
std::string default_text(const std::string& otherwise, const nlohmann::ordered_json& value) {
  // NOLINTNEXTLINE(readability-container-size-empty): empty() is false for every JSON string
  const bool has_value = !value.is_null() && value != "";
  return has_value ? value.dump() : otherwise;
}

std::string field_entry(const scene::Field& field) {
  return ".TP\n" + bold(field.key) + " = " + value_form(field.form.kind, field.placeholder) + "\n" +
         sentence(app::help_of(field), default_text(field.otherwise, field.get(scene::Scene())));
}

std::string key_entries(const std::vector<scene::Key>& keys) {
  std::string text;
  for (const scene::Key& key : keys) {
    const std::string names = fmt::format("{}", fmt::join(key.form.names, ", "));
    const bool are_named = !names.empty() && !key.form.is_color;
    const std::string form = value_form(key.form.kind, "value");
    text += ".TP\n" + bold(key.name) + " = " + form + "\n" +
            sentence(are_named ? key.help + ": " + names : key.help,
                     default_text(key.otherwise, key.value));
  }
  return text;
}

std::string about_bodies() {
  std::string text =
      ".SS [[part]]\nOne table for each homogeneous solid of the body. Parts may overlap; each "
      "counts in full.\n" +
      key_entries(scene::part_keys());
  for (const scene::ShapeKeys& shape : scene::shape_keys()) {
    text += ".SS [[part]] of the shape " + roff(shape.shape) + "\n" + key_entries(shape.keys);
  }
  return text + ".SS [body]\nInstead of parts, with moments or inertia:\n" +
         key_entries(scene::body_keys());
}

}  // namespace

std::string program_page(const Command& program, const std::vector<Command>& commands,
                         const Release& release) {
  std::string page = heading("twrench", 1, release);
  page += ".SH NAME\ntwrench \\- " + roff(as_clause(program.description)) + "\n";
  page += ".SH SYNOPSIS\n.B twrench\n" + italic("COMMAND") + "\n[" + italic("OPTIONS") + "]\n";
  page += ".SH DESCRIPTION\nEach command has a separate page.\n";
  for (const Command& command : commands) {
    page +=
        ".TP\n.BR twrench\\-" + roff(command.name) + " (1)\n" + roff(command.description) + ".\n";
  }
  page += section("OPTIONS", program.options, false);
  page += ".SH EXIT STATUS\n";
  std::istringstream lines(program.footer);
  std::string line;
  std::getline(lines, line);  // the heading
  while (std::getline(lines, line)) {
    const std::size_t begin = line.find_first_not_of(' ');
    const std::size_t end = line.find("  ", begin);
    const std::size_t text = line.find_first_not_of(' ', end);
    page += ".TP\n" + bold(line.substr(begin, end - begin)) + "\n" +
            roff(capitalised(line.substr(text))) + ".\n";
  }
  return with_short_lines(page + ".SH SEE ALSO\n.BR twrench\\-scene (5),\n.BR ffmpeg (1)\n");
}

std::string command_page(const Command& command, const Release& release) {
  std::string page = heading("twrench-" + command.name, 1, release);
  page += ".SH NAME\ntwrench\\-" + roff(command.name) + " \\- " +
          roff(as_clause(command.description)) + "\n";
  page += ".SH SYNOPSIS\n.B twrench " + roff(command.name) + "\n[" + italic("OPTIONS") + "]\n";
  for (const std::string& argument : command.usage) page += italic(argument) + "\n";
  page += section("ARGUMENTS", command.arguments, true);
  page += section("OPTIONS", command.options, false);
  page += footer_sections(command.footer);
  return with_short_lines(page + ".SH SEE ALSO\n.BR twrench (1),\n.BR twrench\\-scene (5)\n");
}

std::string scene_page(const std::string& example, const Release& release) {
  std::string page = heading("twrench-scene", 5, release);
  page +=
      ".SH NAME\ntwrench\\-scene \\- scene files of twrench\n.SH DESCRIPTION\n"
      "A scene is a TOML file that describes a rigid body, its motion and its film. Lengths are "
      "in\n"
      "cm, masses in g, times in s and angles in rad. All keys but the body's are optional. An "
      "unknown\n"
      "key, or a value that is not allowed, is an error that names the file, the line and the "
      "key.\n.BR twrench\\-schema (1)\nprints a JSON Schema. Editors complete and check scene "
      "files "
      "with it.\n"
      "The options of\n.BR twrench\\-render (1)\noverride the file.\n.SH TABLES\n.SS Top level\n";
  std::string table;
  for (const scene::Field& field : scene::fields()) {
    if (field.table != table) {
      if (table.empty()) page += about_bodies();
      table = field.table;
      page += ".SS [" + roff(table) + "]\n";
    }
    page += field_entry(field);
  }
  page += ".SS [motion] of a recording\nInstead of omega and method, the file of a motion:\n" +
          key_entries(scene::recording_keys());
  page +=
      ".SS [[shot]]\nOne table for each shot of a film. It may also have the "
      "tables of the body, motion, look, camera and overlay.\n" +
      key_entries(scene::shot_keys());
  page += ".SH EXAMPLES\nThe built\\-in scene\n.BR dzhanibekov :\n.PP\n" + verbatim(example);
  return with_short_lines(page + ".SH SEE ALSO\n.BR twrench (1),\n.BR twrench\\-render (1)\n");
}

}  // namespace twrench::manual
