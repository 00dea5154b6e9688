#include "comparison/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include "comparison/film_folders.h"

namespace twrench::comparison {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Folders : public testing::Test {
 protected:
  Comparison compare(const Criteria& criteria = {}) const {
    return compare_folders(folders_.inputs(), criteria, {});
  }

  /// Adds a frame to both folders.
  void add(const std::string& name, int expected, int actual) {
    FilmFolders::write(folders_.expected() / name, expected);
    FilmFolders::write(folders_.actual() / name, actual);
  }

  std::vector<Outcome> outcomes(const Criteria& criteria = {}) const {
    std::vector<Outcome> found;
    for (const FrameResult& frame : compare(criteria).frames) found.push_back(frame.outcome);
    return found;
  }

  const FilmFolders folders_;
};

TEST_F(Folders, TellWhatBecameOfEachFrame) {
  add("1.png", 100, 100);
  add("2.png", 100, 130);
  FilmFolders::write(folders_.expected() / "3.png", 100);
  FilmFolders::write(folders_.actual() / "4.png", 100);
  add("5.png", 100, 100);
  FilmFolders::write(folders_.actual() / "5.png", 100, 9);
  add("6.png", 100, 100);
  system::write_file_atomically(folders_.actual() / "6.png", "no picture");
  EXPECT_THAT(outcomes(), ElementsAre(Outcome::identical, Outcome::different, Outcome::missing,
                                      Outcome::extra, Outcome::other_format, Outcome::unreadable));
  const Comparison comparison = compare();
  EXPECT_FALSE(comparison.passed());
  EXPECT_EQ(comparison.frames[1].difference.max, 30);
  EXPECT_EQ(comparison.frames[4].formats, "8x8 with 3 channels, and 9x8 with 3");
  EXPECT_THAT(comparison.first_unreadable()->failure->what(),
              HasSubstr("actual/6.png: it is not a PNG"));
}

TEST_F(Folders, AreAlikeWithinTheBounds) {
  add("1.png", 100, 110);
  Criteria criteria;
  criteria.threshold = 10;
  EXPECT_THAT(outcomes(criteria), ElementsAre(Outcome::alike));
  EXPECT_TRUE(compare(criteria).passed());
  criteria.threshold = 9;
  EXPECT_THAT(outcomes(criteria), ElementsAre(Outcome::different));
  criteria.share = 1.0 / 64;
  EXPECT_THAT(outcomes(criteria), ElementsAre(Outcome::alike));
  criteria.share = 0.99 / 64;
  EXPECT_THAT(outcomes(criteria), ElementsAre(Outcome::different));
}

TEST_F(Folders, AreJudgedBySimilarity) {
  add("1.png", 100, 110);
  add("2.png", 100, 100);
  Criteria criteria;
  criteria.metric = Metric::ssim;
  const Comparison comparison = compare(criteria);
  EXPECT_LT(*comparison.frames[0].similarity, 1.0);
  EXPECT_EQ(comparison.frames[1].similarity, 1.0);
  EXPECT_EQ(comparison.frames[0].outcome, Outcome::different);
  criteria.min_similarity = *comparison.frames[0].similarity;
  EXPECT_TRUE(compare(criteria).passed());
}

TEST_F(Folders, AreAlikeWhereTheDifferenceIsIgnored) {
  add("1.png", 100, 110);
  Criteria criteria;
  criteria.ignored = {{0, 0, 2, 1}};
  EXPECT_THAT(outcomes(criteria), ElementsAre(Outcome::alike));
}

TEST_F(Folders, RefuseAnIgnoredAreaOutsideOfIdenticalFramesToo) {
  add("1.png", 100, 100);
  Criteria criteria;
  criteria.ignored = {{0, 0, 9, 1}};
  EXPECT_THROW(compare(criteria), InvalidArgument);
}

TEST_F(Folders, FindDamageInIdenticalFiles) {
  add("1.png", 100, 100);
  auto bytes = system::read_file(folders_.actual() / "1.png", 1000);
  bytes[bytes.size() - 20] ^= 1;
  for (const auto& folder : {folders_.expected(), folders_.actual()}) {
    system::write_file_atomically(folder / "1.png", bytes);
  }
  EXPECT_THAT(outcomes(), ElementsAre(Outcome::unreadable));
}

TEST_F(Folders, FindDamageInFramesThatAreMissingOrExtra) {
  system::write_file_atomically(folders_.expected() / "1.png", "no picture");
  system::write_file_atomically(folders_.actual() / "2.png", "no picture");
  EXPECT_THAT(outcomes(), ElementsAre(Outcome::unreadable, Outcome::unreadable));
}

TEST_F(Folders, WithoutFramesCannotBeCompared) {
  EXPECT_THAT([&] { compare(); },
              testing::ThrowsMessage<system::FileError>(HasSubstr("neither has a frame")));
}

TEST_F(Folders, HaveTheSameResultsHoweverManyFrames) {
  for (int i = 0; i < 60; ++i) add("f" + std::to_string(i) + ".png", 100, 100 + i % 7);
  int last = 0;
  const Comparison comparison = compare_folders(folders_.inputs(), {}, [&](int done, int total) {
    EXPECT_EQ(done, ++last);
    EXPECT_EQ(total, 60);
  });
  EXPECT_EQ(last, 60);
  EXPECT_TRUE(std::ranges::is_sorted(comparison.frames, {}, &FrameResult::name));
  for (const FrameResult& frame : comparison.frames) {
    EXPECT_EQ(frame.difference.max, std::stoi(frame.name.substr(1)) % 7) << frame.name;
  }
}

}  // namespace
}  // namespace twrench::comparison
