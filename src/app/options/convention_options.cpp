#include "app/options/convention_options.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/terminal/message.h"
#include "scene/recording_table.h"

namespace twrench::app {

std::string name_of_option(const std::string& key) { return option_text(key, {}); }

void ConventionOptions::add_to(CLI::App& command) {
  for (const recording::Field& field : recording::convention_fields()) add_option(command, field);
}

void ConventionOptions::add_option(CLI::App& command, const recording::Field& field) {
  const std::string name = name_of_option(field.name);
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

nlohmann::ordered_json ConventionOptions::values() const {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  for (const recording::Field& field : recording::convention_fields()) {
    const auto flag = flags_.find(field.name);
    if (flag != flags_.end() && flag->second) values[field.name] = true;
    const auto text = texts_.find(field.name);
    if (text == texts_.end() || text->second.empty()) continue;
    if (field.form == recording::FieldForm::rotation) {
      const Eigen::Vector4d q = parse_quaternion(text->second, name_of_option(field.name));
      values[field.name] = std::vector<double>(q.begin(), q.end());
    } else {
      values[field.name] = text->second;
    }
  }
  return values;
}

recording::Convention ConventionOptions::convention() const {
  return scene::convention_of(values(), name_of_option);
}

std::vector<std::string> ConventionOptions::given() const {
  std::vector<std::string> words;
  for (const recording::Field& field : recording::convention_fields()) {
    const auto flag = flags_.find(field.name);
    const auto text = texts_.find(field.name);
    if (flag != flags_.end() && flag->second) words.push_back(name_of_option(field.name));
    if (text != texts_.end() && !text->second.empty()) {
      words.insert(words.end(), {name_of_option(field.name), text->second});
    }
  }
  return words;
}

}  // namespace twrench::app
