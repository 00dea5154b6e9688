#include "app/options/command_model.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>

#include "app/options/arguments.h"
#include "app/options/scene_options.h"
#include "base/enumeration.h"
#include "cases/case.h"
#include "scene/fields.h"
#include "scene/scene.h"
#include "video/codec.h"

namespace twrench::app {
namespace {

Candidates words(std::vector<std::string> all) { return {Candidates::Kind::words, std::move(all)}; }
Candidates list(std::vector<std::string> all) { return {Candidates::Kind::list, std::move(all)}; }

/// The names that a field may have.
std::vector<std::string> names_of(const std::string& key) {
  return std::ranges::find(scene::fields(), key, &scene::Field::key)->form.names;
}

/// The candidates of the options that set a field.
std::map<std::string, Candidates> values_of_fields() {
  std::map<std::string, Candidates> values;
  for (const scene::Field& field : scene::fields()) {
    if (field.form.names.empty()) continue;
    const bool are_several = field.form.kind == scene::ValueForm::Kind::texts;
    values[option_of(field)] = are_several ? list(field.form.names) : words(field.form.names);
  }
  return values;
}

/// The candidates of the other options whose values are neither free nor checked by one_of().
std::map<std::string, Candidates> other_values() {
  return {
      {"--methods", list(names_of("method"))},
      {"--hide", list(names_of("show"))},
      {"--shape", words(enumerator_names<scene::Equimomental>())},
      {"--language", words(enumerator_names<scene::Language>())},
      {"--container", words(video::format_texts(&video::OutputFormat::ending))},
      {"--egl-device", words({"software"})},
      {"SCENE",
       {Candidates::Kind::scene,
        scene::builtin_scene_names(),
        {"toml", "stl", "obj", "ply", "gltf", "glb", "dae", "3mf", "urdf", "sdf", "xml"}}},
      {"--case", words(cases::case_names())},
      {"NAME", words(cases::case_names())},
      {"--font", {Candidates::Kind::file, {}}},
      {"--output", {Candidates::Kind::file, {}}},
      {"--plot", {Candidates::Kind::file, {}}},
      {"--diff", {Candidates::Kind::file, {}}},
      {"--report", {Candidates::Kind::file, {}}},
      {"EXPECTED", {Candidates::Kind::file, {}}},
      {"ACTUAL", {Candidates::Kind::file, {}}},
      {"--frames-dir", {Candidates::Kind::folder, {}}},
      {"FRAMES_DIR", {Candidates::Kind::folder, {}}},
  };
}

std::map<std::string, Candidates> named_values() {
  std::map<std::string, Candidates> values = values_of_fields();
  values.merge(other_values());
  return values;
}

/// The words that one_of() allows. CLI11 formats a checked value FORMAT as "FORMAT:{csv,json}".
std::string checked_words(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t brace = type.find('{');
  return brace == std::string::npos ? "" : type.substr(brace + 1, type.size() - brace - 2);
}

Candidates candidates_of(const CLI::App& command, const CLI::Option& option,
                         const std::string& name) {
  const std::string checked = checked_words(option);
  if (!checked.empty()) return words(parse_words(checked));
  if (name == "COMMAND") {
    std::vector<std::string> names;
    for (const CLI::App* other : command.get_parent()->get_subcommands({})) {
      names.push_back(other->get_name());
    }
    return words(names);
  }
  static const std::map<std::string, Candidates> known = named_values();
  const auto found = known.find(name);
  return found == known.end() ? Candidates() : found->second;
}

/// "--timing{text}" is CLI11's notation for a flag with a default value.
std::string without_default(const std::string& name) { return name.substr(0, name.find('{')); }

Option read_option(const CLI::App& command, const CLI::Option& option) {
  Option result;
  if (option.get_positional()) {
    result.names = {option.get_name(true)};
  } else {
    if (option.get_expected_max() > 0) result.placeholder = placeholder_of(option);
    for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) {
      result.names.push_back(without_default("--" + name));
    }
    result.group = group_with(option.get_group(), result.names.back());
  }
  result.help = option.get_description();
  result.otherwise = option.get_default_str();
  result.candidates = candidates_of(command, option, result.names.back());
  return result;
}

std::string usage_of(const CLI::Option& argument) {
  const std::string name = argument.get_name(true) + (argument.get_expected_max() > 1 ? "..." : "");
  return argument.get_required() ? name : "[" + name + "]";
}

}  // namespace

Command read_command(const CLI::App& app) {
  Command result{app.get_name(), app.get_description(), {}, {}, {}, app.get_footer()};
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
    if (option->get_positional()) {
      result.arguments.push_back(read_option(app, *option));
      result.usage.push_back(usage_of(*option));
    } else {
      result.options.push_back(read_option(app, *option));
    }
  }
  return result;
}

std::vector<Command> read_commands(const CLI::App& app) {
  std::vector<Command> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(read_command(*command));
  }
  return commands;
}

std::string placeholder_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

std::string heading(OptionGroup group) {
  std::string text(enumerator_name(group));
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

OptionGroup group_with(const std::string& text, const std::string& option) {
  const auto found = std::ranges::find(enumerators<OptionGroup>, text, heading);
  if (found != enumerators<OptionGroup>.end()) return *found;
  throw std::logic_error("the option " + option + " names no group");
}

}  // namespace twrench::app
