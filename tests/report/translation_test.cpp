// Compares the reports in Norwegian with the same reports in English.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "report/command_lines.h"
#include "report/results.h"

namespace twrench::report {
namespace {

Experiment experiment(const std::string& name, double duration, Language language) {
  scene::Scene scene = scene::load_scene(name);
  scene.title = "X";  // a report leaves the titles of scenes as they are
  scene.motion.duration = duration;
  scene.language = language;
  const Commands commands = commands_of(scene, {name}, {}, {});
  return {std::move(scene), commands};
}

std::vector<Section> of_tasks(Language language) {
  const std::vector<Experiment> experiments{experiment("dzhanibekov", 20, language),
                                            experiment("stable-y", 20, language),
                                            experiment("stable-z", 20, language)};
  return report_on_tasks(experiments, task_commands());
}

/// Motions of every kind that a report describes. The first says that it has no flip yet.
std::vector<Section> of_motions(Language language) {
  std::vector<Experiment> experiments(12, experiment("dzhanibekov", 5, language));
  const auto motion = [&](std::size_t i) -> scene::Motion& { return experiments[i].scene.motion; };
  motion(1).duration = 30;  // a flip
  motion(2).duration = 30;
  motion(2).attitude = Eigen::Quaterniond(0, 0, 1, 0);  // x is not x
  motion(3).omega = {0, 1, 0.05};                       // about least
  motion(4).omega = {0.05, 0, 1};                       // about greatest
  motion(5).omega = {0, 0, 1};                          // steady
  motion(6).omega = {0, 0, 0};                          // at rest
  experiments[7].scene.body = {{}, Eigen::Vector3d(1, 2, 2).asDiagonal()};
  experiments[8].scene.body = {{}, Eigen::Vector3d(1, 4, 6).asDiagonal()};
  motion(8).omega = {2, 0.5, 1};  // the separatrix
  for (const std::size_t i : {9, 10, 11}) motion(i).method = "taylor";
  motion(9).wheel = Eigen::Vector3d(2000, 0, 0);
  motion(10).wheel = Eigen::Vector3d(1, 0, 0);
  motion(10).duration = 30;  // a flip
  motion(11).energy_loss_time = 20;
  return report_on_motions(experiments);
}

/// What the only group of a regular expression matches in a text.
std::vector<std::string> matches(const std::string& text, const std::regex& regex) {
  return {std::sregex_token_iterator(text.begin(), text.end(), regex, 1), {}};
}

/// The texts of a report in the order in which they stand. `words`: those that are in a language;
/// titles of references are not. `others`: those that are the same in all languages.
struct Texts {
  std::vector<std::string> words, others;

  void operator()(const Paragraph& part) { words.push_back(part.text); }
  void operator()(const Subheading& part) { words.push_back(part.text); }
  void operator()(const Formula& part) {
    static const std::regex regex(R"(\\text\{([^}]*)\})");
    for (const std::string& text : matches(part.tex, regex)) words.push_back(text);
    words.push_back(part.says);
  }
  void operator()(const List& part) {
    others.push_back(fmt::format("{} references", part.items.size()));
  }
  void operator()(const Figure& part) {
    words.push_back(part.caption);
    others.insert(others.end(), {part.name, part.command});
    static const std::regex regex("(?:title|label) ['\"]([^'\"]*)['\"]");
    for (const std::string& label : matches(part.plot.script, regex)) words.push_back(label);
  }
  void operator()(const Table& part) {
    words.push_back(part.caption);
    words.insert(words.end(), part.header.begin(), part.header.end());
    others.insert(others.end(), part.commands.begin(), part.commands.end());
    for (const auto& row : part.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (part.header.at(i) != "CPU, ms") words.push_back(row[i]);
      }
    }
  }
};

Texts texts_of(const std::vector<Section>& sections) {
  Texts texts;
  for (const Section& section : sections) {
    texts.words.push_back(section.heading);
    for (const auto& part : section.content) std::visit(texts, part);
  }
  return texts;
}

/// The words of a text, which are of two letters or more.
std::vector<std::string> words_of(const std::string& text) {
  static const std::regex regex("([A-Za-z]{2,}[A-Za-z0-9]*(?:-[a-z]+)*)");
  return matches(text, regex);
}

std::vector<std::string> numbers_of(const std::string& text) {
  static const std::regex regex("([0-9]+(?:\\.[0-9]+)?(?:e[-+][0-9]+)?)");
  std::vector<std::string> numbers = matches(text, regex);
  std::ranges::sort(numbers);  // the order of words differs
  return numbers;
}

void expect_same_parts(const Texts& en, const Texts& nb) {
  EXPECT_EQ(en.others, nb.others);
  ASSERT_EQ(en.words.size(), nb.words.size());
  for (std::size_t i = 0; i < en.words.size(); ++i) {
    EXPECT_EQ(numbers_of(en.words[i]), numbers_of(nb.words[i])) << en.words[i] << "\n"
                                                                << nb.words[i];
  }
}

/// Expects that texts differ unless all their words are the same in both languages: names, symbols,
/// and a few that Norwegian has as well.
void expect_translated(const Texts& en, const Texts& nb) {
  std::set<std::string> same{"CPU",         "Id",       "ms",      "cm",  "rad",   "Radius",
                             "Moment",      "Drift",    "drift",   "RK4", "RKF45", "Ixx",
                             "Iyy",         "Izz",      "exp",     "cos", "sin",   "det",
                             "dzhanibekov", "stable-y", "stable-z"};
  for (const motion::Method& method : motion::methods()) same.emplace(method.name);
  for (std::size_t i = 0; i < std::min(en.words.size(), nb.words.size()); ++i) {
    if (en.words[i] != nb.words[i]) continue;
    for (const std::string& word : words_of(nb.words[i])) {
      EXPECT_TRUE(same.contains(word)) << word << " in: " << nb.words[i];
    }
  }
}

/// Expects none of the words without which hardly any English sentence is written.
void expect_no_english(const Texts& nb) {
  const std::set<std::string> english{"the",  "The",  "of",    "and",  "with",  "is",
                                      "are",  "not",  "in",    "step", "error", "time",
                                      "axis", "flip", "flips", "body"};
  for (const std::string& text : nb.words) {
    for (const std::string& word : words_of(text)) {
      EXPECT_FALSE(english.contains(word)) << word << " in: " << text;
    }
  }
}

void expect_translation(std::vector<Section> (*report)(Language)) {
  const Texts en = texts_of(report(Language::en)), nb = texts_of(report(Language::nb));
  expect_same_parts(en, nb);
  expect_translated(en, nb);
  expect_no_english(nb);
}

TEST(Translation, OfTheTasks) { expect_translation(of_tasks); }

TEST(Translation, OfMotions) { expect_translation(of_motions); }

}  // namespace
}  // namespace twrench::report
