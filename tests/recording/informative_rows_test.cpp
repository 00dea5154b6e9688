#include "recording/informative_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "recording/columns/open_conventions.h"
#include "scratch_folder.h"
#include "table/error.h"
#include "table/reader.h"

namespace twrench::recording {
namespace {

using testing::HasSubstr;

/// The error about a row of a file, as a search for the right convention reads it.
std::string refusal_of(const std::string& text) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "run.csv";
  std::ofstream(file) << text;
  const Recording recording(file);
  const auto all = conventions(recording.header(), {});
  try {
    informative_rows(recording, all.front());
  } catch (const table::BadTable& error) {
    return error.what();
  }
  return "no error";
}

TEST(InformativeRows, NameTheRowThatIsWrong) {
  EXPECT_THAT(refusal_of("t,p,q,r\n0,1,1,1\n1,1,nan,1\n2,1,1,1\n"),
              HasSubstr("run.csv:3: the column 'q': nan is not finite"));
  const std::string names = "t,qw,qx,qy,qz\n", rest = "0,1,0,0,0\n1,1,0,0,0\n";
  EXPECT_THAT(refusal_of(names + rest + "2,0,0,0,0\n"),
              HasSubstr("run.csv:4: the quaternion: it is zero"));
}

// Those that are cut off may be the motion of a hand, and no evidence for a reading.
TEST(InformativeRows, AreThoseOfTheExtract) {
  const std::string text = "t,p,q,r\n5,9,9,9\n6,1,2,3\n7,4,5,6\n8,9,9,9\n";
  const Recording recording(table::open_table("run.csv", text));
  const auto convention = conventions(recording.header(), {}).front();
  EXPECT_EQ(informative_rows(recording, convention).size(), 4U);
  const auto rows = informative_rows(recording.between({.from = 1, .to = 2}), convention);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].omega, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(rows[1].omega, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(rows[1].t, 1);
}

}  // namespace
}  // namespace twrench::recording
