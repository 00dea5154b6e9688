#include "scene/phrase.h"

#include <gtest/gtest.h>

namespace twrench::scene {
namespace {

TEST(Phrase, HasItsValuesInEachLanguage) {
  constexpr Phrase phrase{"{}, step {:.3g} s", "{}, steg {:.3g} s"};
  EXPECT_EQ(phrase.in(Language::en, "rk4", 0.01), "rk4, step 0.01 s");
  EXPECT_EQ(phrase.in(Language::nb, std::string("rk4"), 1 / 3.0), "rk4, steg 0.333 s");
  EXPECT_EQ(Phrase("none", "ingen").in(Language::nb), "ingen");
}

}  // namespace
}  // namespace twrench::scene
