#include "canvas/font.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "base/file.h"
#include "scratch_folder.h"

namespace twrench {
namespace {

/// The file of "sans", from its package.
std::vector<std::uint8_t> sans_file() { return read_file(TWRENCH_SANS_FILE, 1 << 24); }

std::string refusal(std::vector<std::uint8_t> file) {
  try {
    Font(std::move(file), "F");
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

std::string refusal_to_load(const std::string& name) {
  try {
    load_typeface(name);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

TEST(Font, MeasuresInEm) {
  const Font font(sans_file(), "F");
  EXPECT_NEAR(font.cap_height(), 1456.0 / 2048, 1e-6) << "Roboto's";
  EXPECT_NEAR(font.digit_advance(), 1151.0 / 2048, 1e-6);
  EXPECT_GT(font.advance(font.glyph(U'W')), font.advance(font.glyph(U'i')));
}

TEST(Font, KernsByGpos) {
  const Font font(sans_file(), "F");
  EXPECT_LT(font.kerning(font.glyph(U'T'), font.glyph(U'o')), -0.02);
  EXPECT_EQ(font.kerning(font.glyph(U'H'), font.glyph(U'H')), 0);
}

TEST(Font, OutlinesStandOnTheBaseline) {
  const Font font(sans_file(), "F");
  double top = 0, bottom = -1;
  for (const Font::Segment& segment : font.outline(font.glyph(U'H'))) {
    top = std::min(top, segment.end.y);
    bottom = std::max(bottom, segment.end.y);
  }
  EXPECT_NEAR(bottom, 0, 1e-9);
  EXPECT_NEAR(top, -font.cap_height(), 1e-6) << "y is down";
  EXPECT_TRUE(font.outline(font.glyph(U' ')).empty());
}

TEST(Font, StaysWholeWhereItIsMoved) {
  Font first(sans_file(), "F");
  const double advance = first.advance(first.glyph(U'W'));
  const Font second(std::move(first));
  EXPECT_EQ(second.advance(second.glyph(U'W')), advance);
}

TEST(Font, RefusesWhatIsNoFont) {
  EXPECT_EQ(refusal(std::vector<std::uint8_t>{}), "F: is not a TrueType or OpenType font");
  EXPECT_EQ(refusal({'P', 'N', 'G', 0, 0, 0, 0, 0}), "F: is not a TrueType or OpenType font");
  EXPECT_EQ(refusal({'t', 't', 'c', 'f', 0, 1}), "F: is not a TrueType or OpenType font");
}

TEST(Font, RefusesAFileCutAnywhere) {
  const std::vector<std::uint8_t> whole = sans_file();
  for (const std::size_t size : {4UL, 11UL, 12UL, 100UL, whole.size() / 2, whole.size() - 9}) {
    const std::vector<std::uint8_t> cut(whole.begin(),
                                        whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(refusal(cut), "F: is a damaged font: it ends before its tables do") << size;
  }
}

TEST(Font, RefusesAFontThatLacksATable) {
  std::vector<std::uint8_t> file = sans_file();
  for (std::size_t at = 12; at < 12U + 16U * file[5]; at += 16) {
    if (std::string(&file[at], &file[at + 4]) == "cmap") file[at] = 'x';
  }
  EXPECT_EQ(refusal(file), "F: is a font without outlines or without a map from characters");
}

TEST(LoadTypeface, KnowsItsNames) {
  EXPECT_NE(load_typeface("sans").regular.cap_height(), load_typeface("mono").regular.cap_height());
  const Typeface mono = load_typeface("mono");
  EXPECT_EQ(mono.regular.advance(mono.regular.glyph(U'i')),
            mono.regular.advance(mono.regular.glyph(U'W')));
}

TEST(LoadTypeface, NamesWhatIsWrong) {
  EXPECT_THAT(refusal_to_load("sens"), testing::HasSubstr("font: unknown name 'sens'"));
  EXPECT_THAT(refusal_to_load("missing.ttf"), testing::HasSubstr("missing.ttf"));
  EXPECT_THAT(refusal_to_load("./"), testing::HasSubstr("./"));
  const ScratchFolder folder;
  write_file_atomically(folder / "text.ttf", "not a font");
  EXPECT_THAT(refusal_to_load((folder / "text.ttf").string()),
              testing::HasSubstr("text.ttf: is not a TrueType or OpenType font"));
}

TEST(LoadTypeface, ReadsAFile) {
  const ScratchFolder folder;
  write_file_atomically(folder / "my font", sans_file());
  EXPECT_EQ(load_typeface((folder / "my font").string()).strong.digit_advance(),
            load_typeface("sans").regular.digit_advance());
}

}  // namespace
}  // namespace twrench
