#include "report/mathml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace twrench::report {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(MathMl, HasLettersNumbersAndOperators) {
  EXPECT_EQ(mathml("2 K"), "<mn>2</mn><mi>K</mi>");
  EXPECT_EQ(mathml("a - b"), "<mi>a</mi><mo stretchy=\"false\">−</mo><mi>b</mi>");
  EXPECT_EQ(mathml(R"(\lambda < 0)"), "<mi>λ</mi><mo stretchy=\"false\">&lt;</mo><mn>0</mn>");
}

TEST(MathMl, HasScripts) {
  EXPECT_EQ(mathml("X^T"), "<msup><mi>X</mi><mi>T</mi></msup>");
  EXPECT_EQ(mathml("M_1^2"), "<msubsup><mi>M</mi><mn>1</mn><mn>2</mn></msubsup>");
  EXPECT_EQ(mathml("W'"), R"(<mrow><mi>W</mi><mo lspace="0" rspace="0">′</mo></mrow>)");
}

TEST(MathMl, DistinguishesASignFromADifference) {
  const std::string sign = R"(<mo form="prefix" stretchy="false">−</mo>)";
  EXPECT_THAT(mathml("I^{-1}"), HasSubstr(sign));
  EXPECT_THAT(mathml(R"(\exp(-h))"), HasSubstr(sign));
  EXPECT_THAT(mathml("T / T_0 - 1"), Not(HasSubstr(sign)));
}

TEST(MathMl, PutsNoSpaceAroundBarsAndSlashes) {
  for (const char* tex : {"|", R"(\|)", "/"}) {
    EXPECT_THAT(mathml(tex), HasSubstr(R"(<mo stretchy="false" lspace="0" rspace="0">)")) << tex;
  }
}

TEST(MathMl, SpacesFunctions) {
  const std::string space = "<mspace width=\".17em\"/>";
  EXPECT_EQ(mathml(R"(\sin w)"), "<mi>sin</mi>" + space + "<mi>w</mi>");
  EXPECT_EQ(mathml(R"(W \exp(h))"), "<mi>W</mi>" + space + mathml(R"(\exp(h))"));
  EXPECT_THAT(mathml(R"(1 - \cos w)"), HasSubstr("</mo><mi>cos</mi>"));
}

TEST(MathMl, HasConstructions) {
  EXPECT_EQ(mathml(R"(\frac{h}{2})"),
            "<mfrac><mrow><mi>h</mi></mrow><mrow><mn>2</mn></mrow></mfrac>");
  EXPECT_EQ(mathml(R"(\sqrt{m})"), "<msqrt><mrow><mi>m</mi></mrow></msqrt>");
  EXPECT_EQ(mathml(R"(\dot X)"),
            "<mover accent=\"false\"><mi>X</mi><mo stretchy=\"false\">˙</mo></mover>");
  EXPECT_EQ(mathml(R"(\left(a\right))"), "<mrow><mo>(</mo><mi>a</mi><mo>)</mo></mrow>");
  EXPECT_EQ(mathml(R"(\text{if not})"), "<mtext>if\u00a0not</mtext>");
}

TEST(MathMl, HasTables) {
  EXPECT_EQ(mathml(R"(\begin{pmatrix} a & b \\ c & d \end{pmatrix})"),
            "<mrow><mo>(</mo><mtable class=\"pmatrix\"><mtr><mtd><mi>a</mi></mtd><mtd><mi>b</mi>"
            "</mtd></mtr><mtr><mtd><mi>c</mi></mtd><mtd><mi>d</mi></mtd></mtr></mtable><mo>)</mo>"
            "</mrow>");
  EXPECT_THAT(mathml(R"(\begin{cases} a & b \end{cases})"), HasSubstr("<mo>{</mo>"));
}

TEST(MathMl, RefusesWhatItDoesNotKnow) {
  for (const char* tex :
       {R"(\alpha)", R"(\widehat{X})", R"(\frac{a}{b)", "a}", R"(\begin{matrix} a \end{matrix})",
        R"(\begin{pmatrix} a)", R"(\left(a)", "a & b"}) {
    EXPECT_THROW(mathml(tex), std::invalid_argument) << tex;
  }
}

}  // namespace
}  // namespace twrench::report
