#include "report/citations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/motion/method.h>

namespace twrench::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> items_of(const Citations& citations) {
  return std::get<List>(citations.references().content.at(0)).items;
}

TEST(Citations, NumberReferencesInTheirOrder) {
  Citations citations(Language::en);
  EXPECT_EQ(citations.cite(hairer), "[1]");
  EXPECT_EQ(citations.cite(landau), "[2]");
  EXPECT_EQ(citations.cite(hairer), "[1]");
  EXPECT_EQ(citations.specification(), "[3]");
  EXPECT_THAT(items_of(citations), ElementsAre(StartsWith("E. Hairer"), StartsWith("L. D. Landau"),
                                               StartsWith("H. J. Rivertz")));
}

TEST(Citations, NameTheEquationOfTheSpecification) {
  Citations citations(Language::en);
  EXPECT_EQ(citations.cite_method("specification, eq. (25)"), "[1], eq. (25)");
  EXPECT_EQ(citations.cite_method("Kutta (1901); docs/kutta.md"), "[2]");
  EXPECT_EQ(items_of(citations).at(1), "Kutta (1901).");
}

TEST(Citations, HaveTheWordsOfALanguageBesideTheTitles) {
  Citations citations(Language::nb);
  EXPECT_EQ(citations.cite(landau), "[1]");
  EXPECT_EQ(citations.cite_method("specification, 4.5, eq. (39)"), "[2], 4.5, likning (39)");
  EXPECT_THAT(items_of(citations),
              ElementsAre(HasSubstr("Mechanics, 3. utg. (Pergamon, 1976), avsnitt 37"),
                          HasSubstr("prosjektoppgave")));
}

TEST(Citations, GiveTheTitleAndThePagesOfEveryMethodsSource) {
  Citations citations(Language::en);
  for (const motion::Method& method : motion::methods()) citations.cite_method(method.source);
  for (const std::string& item : items_of(citations)) {
    EXPECT_THAT(item, Not(HasSubstr("docs/")));
    EXPECT_THAT(item, testing::AnyOf(StartsWith("H. J. Rivertz"),
                                     testing::MatchesRegex(".*\\), [0-9]+-[0-9]+\\.")));
  }
}

}  // namespace
}  // namespace twrench::report
