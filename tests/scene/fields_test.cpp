#include "scene/fields.h"

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <fstream>
#include <string>

namespace twrench::scene {
namespace {

/// The scene file in docs/scene-files.md: the lines indented by four spaces, from the title to the
/// next paragraph.
std::string documented_scene() {
  std::ifstream file(TWRENCH_TESTS_DIR "/../docs/scene-files.md");
  std::string text, line;
  while (std::getline(file, line) && !line.starts_with("    title")) {
  }
  do text += line + "\n";
  while (std::getline(file, line) && (line.empty() || line.starts_with("    ")));
  return text;
}

TEST(Fields, AreThoseThatTheDocumentLists) {
  const toml::table documented = toml::parse(documented_scene());
  for (const Field& field : fields()) {
    const toml::table* table =
        field.table.empty() ? &documented : documented[field.table].as_table();
    ASSERT_NE(table, nullptr) << field.table;
    EXPECT_TRUE(table->contains(field.key)) << field.table << "." << field.key;
  }
  EXPECT_NO_THROW(parse_scene(documented_scene(), "scene-files.md"));  // and no others
}

TEST(Fields, HaveTheDefaultsThatTheDocumentShows) {
  const Scene documented = parse_scene(documented_scene(), "scene-files.md");
  for (const Field& field : fields()) {
    const auto value = field.get(Scene());
    if (value.is_null() || field.key == "title") continue;
    EXPECT_EQ(field.get(documented), value) << field.table << "." << field.key;
  }
}

TEST(Fields, ReturnWhatTheyWereSetTo) {
  const Scene documented = parse_scene(documented_scene(), "scene-files.md");
  for (const Field& field : fields()) {
    const auto value = field.get(documented);
    if (value.is_null()) continue;
    Scene scene;
    scene.overlay.show.clear();
    field.set(scene, value, field.key);
    EXPECT_EQ(field.get(scene), value) << field.table << "." << field.key;
  }
}

TEST(Fields, SayWhatTheValueIs) {
  for (const Field& field : fields()) {
    EXPECT_FALSE(field.help.empty()) << field.key;
    EXPECT_FALSE(field.placeholder.empty()) << field.key;
  }
}

}  // namespace
}  // namespace twrench::scene
