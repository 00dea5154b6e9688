// The formulas in TeX and in MathML are the same: they have the same symbols in the same order, and
// as many fractions, roots, scripts and cells.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "report/document.h"

namespace twrench::report {
namespace {

std::vector<Formula> all_formulas() {
  std::ifstream file(TWRENCH_TESTS_DIR "/../src/report/formulas.txt");
  std::vector<Formula> all;
  for (std::string name, tex, mathml, blank;
       std::getline(file, name) && std::getline(file, tex) && std::getline(file, mathml);
       std::getline(file, blank)) {
    all.push_back({tex, mathml, name});
  }
  return all;
}

using Replacements = std::vector<std::pair<const char*, const char*>>;

std::string replaced(std::string text, const Replacements& replacements) {
  for (const auto& [from, to] : replacements) text = std::regex_replace(text, std::regex(from), to);
  return text;
}

std::string symbols_of_tex(const std::string& tex) {
  return replaced(
      tex, {{R"(\\begin\{pmatrix\}|\\left\()", "("},
            {R"(\\end\{pmatrix\}|\\right\))", ")"},
            {R"(\\begin\{cases\})", "CASES"},
            {R"(\\begin\{aligned\}|\\end\{\w+\}|\\\\|\\(frac|sqrt|text|mathrm|quad)|\\[,;])", ""},
            {R"([ {}&_^])", ""},
            {R"(\\hat(\\omega|[A-Za-z]))", "$1^"},
            {R"(\\dot([A-Za-z]))", "$1˙"},
            {R"(\\\|)", "‖"},
            {R"(\\omega)", "ω"},
            {R"(\\Omega)", "Ω"},
            {R"(\\lambda)", "λ"},
            {R"(\\varphi)", "φ"},
            {R"(\\theta)", "θ"},
            {R"(\\times)", "×"},
            {R"(\\tau)", "τ"},
            {R"(\\pi)", "π"},
            {R"(\\cdot)", "·"},
            {R"(\\sum)", "∑"},
            {R"(\\int)", "∫"},
            {R"(\\le)", "≤"},
            {R"(\\)", ""},
            {"-", "−"},
            {"'", "′"},
            {"CASES", "{"}});
}

std::string symbols_of_mathml(const std::string& mathml) {
  return replaced(mathml, {{"<[^>]*>", ""}, {"&lt;", "<"}, {" |\u00a0", ""}});
}

std::ptrdiff_t count(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  return std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {});
}

TEST(Formulas, AreTheSameInTexAndInMathMl) {
  ASSERT_GT(all_formulas().size(), 10U);
  for (const auto& [tex, mathml, name] : all_formulas()) {
    EXPECT_EQ(symbols_of_tex(tex), symbols_of_mathml(mathml)) << name;
    EXPECT_EQ(count(tex, R"(\\frac)"), count(mathml, "<mfrac>")) << name;
    EXPECT_EQ(count(tex, R"(\\sqrt)"), count(mathml, "<msqrt>")) << name;
    EXPECT_EQ(count(tex, "_"), count(mathml, "<msub(sup)?>")) << name;
    EXPECT_EQ(count(tex, R"(\^)"), count(mathml, "<msu(p|bsup)>")) << name;
    EXPECT_EQ(count(tex, R"(&|\\\\|\\begin)"), count(mathml, "<mtd>")) << name;
  }
}

TEST(Formulas, AreFoundByName) {
  EXPECT_EQ(formula("lie_euler", "says").tex.substr(0, 4), "W' =");
  EXPECT_EQ(formula("nutation", "says").says, "says");
  EXPECT_THROW(formula("nutations", ""), std::logic_error);
}

}  // namespace
}  // namespace twrench::report
