#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "comparison/comparison.h"
#include "comparison/film_folders.h"

namespace twrench::comparison {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Frames : public testing::Test {
 protected:
  void touch(const std::filesystem::path& file) { system::write_file_atomically(file, "x"); }

  /// "name", with a + if it is extra and a - if it is missing.
  std::vector<std::string> found() const {
    std::vector<std::string> names;
    for (const FrameName& frame : frames_of(folders_.inputs())) {
      names.push_back(frame.name + (!frame.is_expected ? "+" : frame.is_actual ? "" : "-"));
    }
    return names;
  }

  const FilmFolders folders_;
};

TEST_F(Frames, ArePairedByNameAndSorted) {
  for (const char* name : {"b.png", "d.png", "a.png"}) touch(folders_.expected() / name);
  for (const char* name : {"d.png", "c.png", "a.png"}) touch(folders_.actual() / name);
  EXPECT_THAT(found(), ElementsAre("a.png", "b.png-", "c.png+", "d.png"));
}

TEST_F(Frames, AreVisiblePngFilesAlone) {
  for (const char* name : {"manifest.json", ".frame_000001.png.17-0.tmp", ".hidden.png", "png",
                           ".png", "notes.png.txt", "UPPER.PNG"}) {
    touch(folders_.expected() / name);
  }
  std::filesystem::create_directory(folders_.expected() / "folder.png");
  EXPECT_THAT(found(), ElementsAre("UPPER.PNG-"));
}

TEST_F(Frames, OfAFolderThatIsNotThereAreNone) {
  std::filesystem::remove(folders_.expected());
  EXPECT_THAT(found(), IsEmpty());
}

TEST_F(Frames, OfAFolderThatCannotBeReadAreAnError) {
  std::filesystem::remove(folders_.expected());
  touch(folders_.expected());
  EXPECT_THROW(found(), system::FileError);
}

}  // namespace
}  // namespace twrench::comparison
