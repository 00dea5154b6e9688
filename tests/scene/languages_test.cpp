#include "scene/languages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include "scratch_folder.h"
#include "system/file.h"

namespace twrench::scene {
namespace {

using testing::HasSubstr;

TEST(Languages, OfABuiltInStory) {
  EXPECT_EQ(load_scene("explain", "nb", "language").name, "explain-nb");
  EXPECT_EQ(load_scene("explain", "en", "language").name, "explain");
  EXPECT_EQ(load_scene("explain-nb", "en", "language").name, "explain");
  EXPECT_EQ(load_scene("explain-nb", "nb", "language").name, "explain-nb");
  EXPECT_EQ(load_scene("dzhanibekov", "en", "language").name, "dzhanibekov");
}

TEST(Languages, AreThoseOfAScene) {
  for (const std::string& language : languages()) {
    EXPECT_NO_THROW(load_scene("explain", language, "language")) << language;
  }
}

/// The message about a language that the scene does not have.
std::string refusal(const std::string& name, const std::string& language) {
  try {
    load_scene(name, language, "--language");
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(Languages, ThatAreNotThereAreRefusedWithThoseThatAre) {
  EXPECT_EQ(refusal("explain", "de"), "--language: explain has no text in 'de', only in en and nb");
  EXPECT_EQ(refusal("explain-nb", "NB"),
            "--language: explain-nb has no text in 'NB', only in en and nb");
  EXPECT_EQ(refusal("explorer-1", "nb"), "--language: explorer-1 has no text in 'nb', only in en");
  EXPECT_THAT(refusal("explani", "nb"), HasSubstr("unknown name 'explani'"));
  const ScratchFolder folder;
  const std::string file = (folder / "my.toml").string();
  system::write_file_atomically(file, "[body]\nmoments = [3, 4, 5]\n");
  EXPECT_EQ(refusal(file, "nb"), "--language: " + file + " has one language, that of its file");
}

}  // namespace
}  // namespace twrench::scene
