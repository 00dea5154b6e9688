#include "app/options/convention_options.h"

#include <CLI/CLI.hpp>

#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/terminal/message.h"
#include "scene/limits.h"

namespace twrench::app {

void ConventionOptions::add_to(CLI::App& command) {
  for (const recording::Field& field : recording::convention_fields()) add_option(command, field);
}

void ConventionOptions::add_option(CLI::App& command, const recording::Field& field) {
  const std::string name = option_text(field.name, {});
  switch (field.form) {
    case recording::FieldForm::unasked:
      return;
    case recording::FieldForm::flag:
      command.add_flag(name, flags_[field.name], field.help)->group(heading(OptionGroup::data));
      return;
    case recording::FieldForm::text:
    case recording::FieldForm::rotation:
      break;
  }
  CLI::Option* option = command.add_option(name, texts_[field.name], field.help)
                            ->type_name(field.placeholder)
                            ->default_str(field.otherwise)
                            ->group(heading(OptionGroup::data));
  if (!field.words.empty()) option->check(one_of(name, field.words));
}

recording::Convention ConventionOptions::convention() const {
  recording::Convention given;
  for (const recording::Field& field : recording::convention_fields()) {
    const auto flag = flags_.find(field.name);
    if (flag != flags_.end() && flag->second) field.set(given, true);
    const auto text = texts_.find(field.name);
    if (text == texts_.end() || text->second.empty()) continue;
    if (field.form == recording::FieldForm::rotation) {
      const std::string name = option_text(field.name, {});
      const Eigen::Vector4d numbers = parse_quaternion(text->second, name);
      field.set(given, scene::limits::check_rotation(name, numbers));
    } else {
      field.set(given, text->second);
    }
  }
  return given;
}

std::vector<std::string> ConventionOptions::given() const {
  std::vector<std::string> words;
  for (const recording::Field& field : recording::convention_fields()) {
    const auto flag = flags_.find(field.name);
    const auto text = texts_.find(field.name);
    if (flag != flags_.end() && flag->second) words.push_back(option_text(field.name, {}));
    if (text != texts_.end() && !text->second.empty()) {
      words.insert(words.end(), {option_text(field.name, {}), text->second});
    }
  }
  return words;
}

}  // namespace twrench::app
