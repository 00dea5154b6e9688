#include "scene/languages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <algorithm>

#include "base/enumeration.h"

namespace twrench::scene {
namespace {

std::string name_in(const std::string& tag, const std::string& name) {
  try {
    return story_in(tag, name, "--language");
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(Languages, OfABuiltInStory) {
  EXPECT_EQ(name_in("nb", "explain"), "explain-nb");
  EXPECT_EQ(name_in("en", "explain"), "explain");
  EXPECT_EQ(name_in("en", "explain-nb"), "explain");
  EXPECT_EQ(name_in("nb", "explain-nb"), "explain-nb");
  EXPECT_EQ(name_in("en", "explain-short"), "explain-short");
  EXPECT_EQ(name_in("nb", "explain-short"), "--language: explain-short is not told in 'nb'");
  EXPECT_EQ(name_in("sv", "explain"), "--language: explain is not told in 'sv'");
  EXPECT_EQ(name_in("no-NO", "explain"), "explain-nb");
}

std::string remedy_for(const std::string& tag, const std::string& name) {
  try {
    return story_in(tag, name, "--language");
  } catch (const Error& error) {
    return error.remedy();
  }
}

TEST(Languages, OfAStoryThatIsNotToldInThemHaveARemedyThatWorks) {
  EXPECT_EQ(remedy_for("sv", "explain"), "use en or nb, or write the captions in a scene file");
  EXPECT_EQ(remedy_for("sv", "explorer-1"), "use en, or write the captions in a scene file");
  EXPECT_EQ(remedy_for("nb", "explorer-1"), "leave it out, or take the story 'explain'");
}

TEST(Languages, AreTagsOfWhichSomeHaveWords) {
  struct Case {
    const char *given, *tag;
    Language words;
  };
  for (const auto& [given, tag, words] :
       {Case{"nb", "nb", Language::nb}, Case{"no", "nb", Language::nb},
        Case{"NO-no", "nb-no", Language::nb}, Case{"en-GB", "en-GB", Language::en},
        Case{"sv", "sv", Language::en}, Case{"zh-Hant-TW", "zh-Hant-TW", Language::en},
        Case{"de-1996-x-mine", "de-1996-x-mine", Language::en}}) {
    Scene scene;
    set_language(scene, given, "language");
    EXPECT_EQ(scene.language_tag, tag);
    EXPECT_EQ(scene.language, words) << given;
    EXPECT_EQ(note_on_language(scene).empty(),
              scene.language_tag.starts_with("nb") || scene.language_tag.starts_with("en"));
  }
  for (const char* wrong :
       {"", "s", "svenska", "sv-", "-sv", "sv--SE", "sv_SE", "sv-123456789", "s\u00f6", "12"}) {
    Scene scene;
    EXPECT_THROW(set_language(scene, wrong, "language"), InvalidArgument) << wrong;
    EXPECT_EQ(scene.language_tag, "en");
  }
}

TEST(Languages, OfAnotherSceneAreThoseOfItsWords) {
  for (const char* name : {"dzhanibekov", "my.toml", "explani"}) {
    EXPECT_EQ(name_in("nb", name), name);
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
      const std::string told = name_in(std::string(enumerator_name(language)), name);
      if (told.starts_with("--language: ")) continue;
      EXPECT_EQ(load_scene(told).language, language) << name;
    }
    EXPECT_EQ(name_in(scene.language_tag, name), name);
  }
}

TEST(Languages, OfAFileAreThoseOfItsShotsToo) {
  const Scene scene = load_scene("explain-nb");
  for (const Shot& shot : scene.shots) EXPECT_EQ(shot.scene.language, Language::nb);
}

}  // namespace
}  // namespace twrench::scene
