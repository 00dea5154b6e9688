#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "comparison/comparison.h"
#include "comparison/film_folders.h"

namespace twrench::comparison {
namespace {

class Update : public testing::Test {
 protected:
  std::size_t update(const Criteria& criteria = {}) const {
    return update_expected(compare_folders(folders_.inputs(), criteria, {}));
  }

  void add(const std::string& name, int expected, int actual) {
    FilmFolders::write(folders_.expected() / name, expected);
    FilmFolders::write(folders_.actual() / name, actual);
  }

  /// The value of a frame in the expected folder; -1 if it does not exist.
  int expected(const std::string& name) const {
    const auto file = folders_.expected() / name;
    return std::filesystem::exists(file) ? image::read_png(file).pixels[0] : -1;
  }

  const FilmFolders folders_;
};

TEST_F(Update, CopiesOnlyWhatDiffers) {
  add("same.png", 100, 100);
  add("within.png", 100, 101);
  add("over.png", 100, 120);
  FilmFolders::write(folders_.actual() / "extra.png", 70);
  FilmFolders::write(folders_.expected() / "missing.png", 80);
  const auto time = std::filesystem::last_write_time(folders_.expected() / "same.png");
  Criteria criteria;
  criteria.threshold = 5;
  EXPECT_EQ(update(criteria), 2U);
  EXPECT_EQ(expected("over.png"), 120);
  EXPECT_EQ(expected("extra.png"), 70);
  EXPECT_EQ(expected("within.png"), 100);
  EXPECT_EQ(expected("missing.png"), 80);
  EXPECT_EQ(std::filesystem::last_write_time(folders_.expected() / "same.png"), time);
}

TEST_F(Update, CopiesNothingIfAFrameCannotBeRead) {
  add("1.png", 100, 120);
  add("2.png", 100, 120);
  system::write_file_atomically(folders_.actual() / "2.png", "no picture");
  EXPECT_EQ(update(), 0U);
  EXPECT_EQ(expected("1.png"), 100);
}

TEST_F(Update, CreatesTheFolder) {
  FilmFolders::write(folders_.actual() / "1.png", 120);
  std::filesystem::remove(folders_.expected());
  EXPECT_EQ(update(), 1U);
  EXPECT_EQ(expected("1.png"), 120);
}

TEST_F(Update, ReplacesLinksAndNotWhatTheyLeadTo) {
  FilmFolders::write(folders_.expected() / "elsewhere", 100);
  std::filesystem::create_symlink("elsewhere", folders_.expected() / "1.png");
  FilmFolders::write(folders_.actual() / "1.png", 120);
  EXPECT_EQ(update(), 1U);
  EXPECT_EQ(expected("1.png"), 120);
  EXPECT_EQ(expected("elsewhere"), 100);
}

}  // namespace
}  // namespace twrench::comparison
