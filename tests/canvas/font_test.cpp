#include "canvas/font.h"

#include <gmock/gmock.h>
#include <twrench/base/error.h>

#include <optional>
#include <random>
#include <set>

#include "canvas/canvas.h"
#include "canvas/font_bytes.h"
#include "scratch_folder.h"
#include "system/file.h"

namespace twrench::canvas {
namespace {

std::string refusal(std::vector<std::uint8_t> file) {
  try {
    Font(std::move(file), "F");
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "none";
}

std::string refusal_to_load(const std::string& name) {
  try {
    load_typeface(name);
  } catch (const InvalidArgument& error) {
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

TEST(Font, HasGlyphsForTheCharactersOfItsMap) {
  const Font font(sans_file(), "F");
  EXPECT_NE(font.glyph(U'W'), 0U);
  EXPECT_EQ(font.glyph(U'\uE123'), 0U);
  EXPECT_TRUE(font.can_draw(font.glyph(U'W')));
  EXPECT_FALSE(font.can_draw(65'000)) << "beyond the last";
}

TEST(Font, OutlivesThatFromWhichItWasCopiedOrMoved) {
  std::optional<Font> first(Font(sans_file(), "F"));
  const double advance = first->advance(first->glyph(U'W'));
  const Font copy(*first), second(std::move(*first));
  first.reset();
  for (const Font& font : {copy, second}) {
    EXPECT_EQ(font.advance(font.glyph(U'W')), advance);
    EXPECT_TRUE(font.can_draw(font.glyph(U'W')));
  }
}

TEST(Font, RefusesWhatIsNoFont) {
  EXPECT_EQ(refusal(std::vector<std::uint8_t>{}), "F: is not a TrueType or OpenType font");
  EXPECT_EQ(refusal({'P', 'N', 'G', 0, 0, 0, 0, 0}), "F: is not a TrueType or OpenType font");
  EXPECT_EQ(refusal({'t', 't', 'c', 'f', 0, 1}), "F: is not a TrueType or OpenType font");
}

TEST(Font, RefusesAFileCutAnywhere) {
  const std::vector<std::uint8_t> whole = sans_file();
  const auto cut_at = [&](std::size_t size) {
    return refusal({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
  };
  for (const std::size_t size : {4UL, 11UL, 12UL, 100UL}) {
    EXPECT_EQ(cut_at(size), "F: is not a TrueType or OpenType font") << size;
  }
  for (const std::size_t size : {1000UL, whole.size() / 2, whole.size() - 9}) {
    EXPECT_EQ(cut_at(size), "F: is a damaged font: not all of its tables can be read") << size;
  }
}

TEST(Font, RefusesAFontThatLacksATable) {
  std::vector<std::uint8_t> file = sans_file();
  for (std::size_t at = 12; at < 12U + 16U * file[5]; at += 16) {
    if (std::string(&file[at], &file[at + 4]) == "cmap") file[at] = 'x';
  }
  EXPECT_EQ(refusal(file), "F: is a font without outlines or without a character map");
}

TEST(Font, RefusesDamagedOutlines) {
  std::vector<std::uint8_t> file = sans_file();
  std::ranges::fill(table(file, "glyf"), std::uint8_t{0x7F});
  EXPECT_EQ(refusal(file), "F: is a damaged font: its character U+00D7 cannot be read");
}

/// Draws with the font if the file is one, and returns whether it is.
bool draw_with(std::vector<std::uint8_t> file) {
  try {
    const Font font(std::move(file), "F");
    image::Image image(200, 40, 4);
    Canvas(image, 0, 0).text(typeset(font, "The Dzhanibekov e\u0301 10⁻³ سلام"), 20, {0, 30}, {});
    return true;
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("F: "));
    return false;
  }
}

TEST(Font, IsRefusedOrDrawsWhereBytesAreDamaged) {
  const std::vector<std::uint8_t> whole = sans_file();
  std::mt19937 random(7);
  const auto below = [&](std::size_t limit) { return random() % limit; };
  int usable = 0;
  constexpr int count = 300;
  for (int i = 0; i < count; ++i) {
    std::vector<std::uint8_t> file = whole;
    // The directory of tables, and the first table of each kind, are at the beginning.
    const std::size_t range = i % 2 == 0 ? file.size() : 4096;
    for (std::size_t flips = 1 + below(8); flips > 0; --flips) {
      file[below(range)] = static_cast<std::uint8_t>(below(256));
    }
    for (const char* tag : {"GPOS", "GSUB", "cmap", "loca", "head"}) {
      if (below(4) == 0) {
        const std::span<std::uint8_t> bytes = table(file = whole, tag);
        bytes[below(std::min<std::size_t>(bytes.size(), 512))] ^=
            static_cast<std::uint8_t>(1 + below(255));
      }
    }
    usable += draw_with(std::move(file)) ? 1 : 0;
  }
  EXPECT_GT(usable, count / 10) << "damage that matters little";
  EXPECT_LT(usable, count) << "damage that is noticed";
}

TEST(Font, IsRefusedOrDrawsWhereItIsCut) {
  const std::vector<std::uint8_t> whole = sans_file();
  for (std::size_t size = 0; size < whole.size(); size += size < 400 ? 7 : 4999) {
    EXPECT_FALSE(draw_with({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}))
        << size;
  }
}

TEST(Font, HasWhatItCanCompose) {
  const Font font(many_scripts_file(U"e\u0301"), "F");
  EXPECT_TRUE(font.has(U'e'));
  EXPECT_TRUE(font.has(U'é'));
  EXPECT_FALSE(font.has(U'è'));
  EXPECT_FALSE(font.has(U'a'));
}

TEST(Font, IsMeasuredByItsOwnLettersWhereItHasThem) {
  const Font sans(sans_file(), "F"), latin(many_scripts_file(U"H0123456789"), "F");
  ASSERT_NE(latin.cap_height(), sans.cap_height());
  ASSERT_NE(latin.digit_advance(), sans.digit_advance());
  EXPECT_EQ(latin.with_fallback(sans).cap_height(), latin.cap_height());
  EXPECT_EQ(latin.with_fallback(sans).digit_advance(), latin.digit_advance());
  const Font arabic = Font(many_scripts_file(U"س"), "F").with_fallback(sans);
  EXPECT_EQ(arabic.cap_height(), sans.cap_height());
  EXPECT_EQ(arabic.digit_advance(), sans.digit_advance());
  EXPECT_EQ(&arabic.digits(), arabic.fallback());
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
  system::write_file_atomically(folder / "text.ttf", "not a font");
  EXPECT_THAT(refusal_to_load((folder / "text.ttf").string()),
              testing::HasSubstr("text.ttf: is not a TrueType or OpenType font"));
}

TEST(LoadTypeface, ReadsAFile) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "my font", sans_file());
  EXPECT_EQ(load_typeface((folder / "my font").string()).strong.digit_advance(),
            load_typeface("sans").regular.digit_advance());
}

TEST(LoadTypeface, HasAllOfOurOwnTextInTheBuiltInSans) {
  const Typeface sans = load_typeface("sans");
  for (const Font* font : {&sans.regular, &sans.strong}) {
    EXPECT_EQ(font->fallback(), nullptr);
    for (char32_t c = U'!'; c <= U'~'; ++c) EXPECT_TRUE(font->has(c)) << static_cast<int>(c);
    for (const char32_t c : std::u32string_view(U"×−…ω\u2007\u2009"))
      EXPECT_TRUE(font->has(c)) << static_cast<int>(c);
  }
}

TEST(LoadTypeface, PutsTheSansBehindAFileAndTheMono) {
  const ScratchFolder folder;
  const std::vector<std::uint8_t> file = many_scripts_file(U"س");
  system::write_file_atomically(folder / "arabic.ttf", file);
  const Typeface typeface = load_typeface((folder / "arabic.ttf").string());
  const Typeface sans = load_typeface("sans");
  ASSERT_NE(typeface.regular.fallback(), nullptr);
  ASSERT_NE(typeface.strong.fallback(), nullptr);
  EXPECT_TRUE(std::ranges::equal(typeface.regular.file(), file));
  EXPECT_TRUE(std::ranges::equal(typeface.regular.fallback()->file(), sans.regular.file()));
  EXPECT_TRUE(std::ranges::equal(typeface.strong.fallback()->file(), sans.regular.file()))
      << "of one weight, as the file is";
  const Typeface mono = load_typeface("mono");
  EXPECT_TRUE(std::ranges::equal(mono.regular.fallback()->file(), sans.regular.file()));
  EXPECT_TRUE(std::ranges::equal(mono.strong.fallback()->file(), sans.strong.file()));
}

TEST(TypefaceDigest, TellsTheFontsAndTheirFallbacksApart) {
  const Font sans(sans_file(), "F"), arabic(many_scripts_file(U"س"), "F");
  const std::set<std::string> digests{
      typeface_digest({sans, sans}), typeface_digest({sans, arabic}),
      typeface_digest({arabic, arabic}), typeface_digest({arabic.with_fallback(sans), arabic}),
      typeface_digest({arabic, arabic.with_fallback(sans)})};
  EXPECT_EQ(digests.size(), 5U);
}

}  // namespace
}  // namespace twrench::canvas
