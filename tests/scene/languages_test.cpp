#include "scene/languages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <algorithm>

#include "base/enumeration.h"

namespace twrench::scene {
namespace {

std::string name_in(Language language, const std::string& name) {
  try {
    return story_in(language, name, "--language");
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(Languages, OfABuiltInStory) {
  EXPECT_EQ(name_in(Language::nb, "explain"), "explain-nb");
  EXPECT_EQ(name_in(Language::en, "explain"), "explain");
  EXPECT_EQ(name_in(Language::en, "explain-nb"), "explain");
  EXPECT_EQ(name_in(Language::nb, "explain-nb"), "explain-nb");
  EXPECT_EQ(name_in(Language::en, "explain-short"), "explain-short");
  EXPECT_EQ(name_in(Language::nb, "explain-short"),
            "--language: explain-short is not told in 'nb'");
}

TEST(Languages, OfAnotherSceneAreThoseOfItsWords) {
  for (const char* name : {"dzhanibekov", "my.toml", "explani"}) {
    EXPECT_EQ(name_in(Language::nb, name), name);
  }
}

bool has_captions(const Scene& scene) {
  return std::ranges::any_of(scene.shots, [](const Shot& shot) {
    return shot.scene.caption && !shot.scene.caption->empty();
  });
}

// Otherwise a story would be shown with captions in one language and words in another.
TEST(Languages, OfEachBuiltInStoryAreKnown) {
  for (const std::string& name : builtin_scene_names()) {
    const Scene scene = load_scene(name);
    if (!has_captions(scene)) continue;
    for (const Language language : enumerators<Language>) {
      const std::string told = name_in(language, name);
      if (told.starts_with("--language: ")) continue;
      EXPECT_EQ(load_scene(told).language, language) << name;
    }
    EXPECT_EQ(name_in(scene.language, name), name);
  }
}

TEST(Languages, OfAFileAreThoseOfItsShotsToo) {
  const Scene scene = load_scene("explain-nb");
  for (const Shot& shot : scene.shots) EXPECT_EQ(shot.scene.language, Language::nb);
}

}  // namespace
}  // namespace twrench::scene
