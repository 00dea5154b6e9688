#include "app/options/command_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "app/options/arguments.h"

namespace twrench::app {
namespace {

using testing::ElementsAre;

TEST(CommandModel, HasTheNamesAndThePlaceOfEachOption) {
  CLI::App app("Try it", "try");
  app.set_help_flag();
  std::string text;
  app.add_option("FILE", text, "a file")->required();
  app.add_option("MORE", text, "more")->expected(1, 3);
  app.add_option("-o,--output", text, "where to")
      ->type_name("PATH")
      ->default_str("here")
      ->group("Output");
  app.add_flag("--timing{text}", text, "tell times")
      ->check(one_of("--timing", {"text", "json"}))
      ->group("Run");
  const Command command = read_command(app);
  EXPECT_EQ(command.name, "try");
  EXPECT_THAT(command.usage, ElementsAre("FILE", "[MORE...]"));
  ASSERT_EQ(command.arguments.size(), 2U);
  EXPECT_EQ(command.arguments[0].placeholder, "");
  ASSERT_EQ(command.options.size(), 2U);
  EXPECT_THAT(command.options[0].names, ElementsAre("-o", "--output"));
  EXPECT_EQ(command.options[0].placeholder, "PATH");
  EXPECT_EQ(command.options[0].otherwise, "here");
  EXPECT_THAT(command.options[1].names, ElementsAre("--timing"));
  EXPECT_EQ(command.options[1].placeholder, "");
  EXPECT_EQ(command.arguments[0].group, std::nullopt);
  EXPECT_EQ(command.options[0].group, OptionGroup::output);
}

TEST(CommandModel, RejectsAnOptionWithoutAGroup) {
  CLI::App app;
  app.set_help_flag();
  std::string text;
  app.add_option("--style", text);
  EXPECT_THROW(read_command(app), std::logic_error);
}

TEST(CommandModel, OffersTheWordsThatAnOptionAllows) {
  CLI::App app;
  app.set_help_flag();
  std::string text;
  app.add_option("--style", text)
      ->check(one_of("--style", {"plain", "wide"}))
      ->type_name("STYLE")
      ->group("Run");
  const Option style = read_command(app).options.at(0);
  EXPECT_EQ(style.placeholder, "STYLE");
  EXPECT_EQ(style.candidates.kind, Candidates::Kind::words);
  EXPECT_THAT(style.candidates.words, ElementsAre("plain", "wide"));
}

}  // namespace
}  // namespace twrench::app
