#include "table/csv_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "table/read_table.h"

namespace twrench::table {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

const std::string rows = "0,run1,0.5,6\n0.01,run1,0.4,7\n0.02,run2,0.3,8\n";

std::vector<std::string> units_of(const std::string& text) {
  return open_table("run", text)->header().units;
}

// A column of words has a word in each row, so the first row looks like names.
TEST(CsvHeader, IsACommentWithANameForEachColumn) {
  for (const char* header :
       {"# t,label,wx,wy\n", "%t,label,wx,wy\n", "// t,label,wx,wy\n", "; t,label,wx,wy\n",
        "## t,label,wx,wy\n", "# \"t\",\"label\",\"wx\",\"wy\"\n", "# t,label,wx,wy,\n",
        "# run 7\n# t,label,wx,wy\n", "# t,label,wx,wy\n# made at noon, by hand\n\n",
        "\xEF\xBB\xBF# t,label,wx,wy\n", "# t label wx wy\n", "# t\tlabel\twx\twy\n",
        "# t;label;wx;wy\r\n"}) {
    const Table table = read_table(header + rows, {0, 2, 3});
    EXPECT_THAT(table.names, ElementsAre("t", "label", "wx", "wy")) << header;
    ASSERT_THAT(table.rows, SizeIs(3)) << header;
    EXPECT_THAT(table.rows.front(), ElementsAre(0, 0.5, 6)) << header;
  }
}

TEST(CsvHeader, IsNotARow) {
  for (const char* text : {"0,run1,0.5,6\n1,run1,0.4,7\n", "run1,0,0.5,6\nrun1,1,0.4,7\n",
                           "# notes\n0,a,1,2\n1,b,2,3\n", "0,\"run1\",0.5,6\n1,\"run1\",0.4,7\n",
                           "0,run1,NA,6\n1,run1,0.4,7\n", ",run1,1,2\n1,b,2,3\n", "0,run1,0.5,6\n",
                           "run1,0,1,2\nrun2,1,2,3\n"}) {
    const auto reader = open_table("run", text);
    EXPECT_THAT(reader->header().names, ElementsAre("#1", "#2", "#3", "#4")) << text;
  }
  EXPECT_THAT(read_table("# notes\n" + rows, {0, 2}).rows, SizeIs(3));
  EXPECT_THAT(table_error_of("bad,1,2,3\n1,2,3,4\n"),
              StartsWith("run:1: the column '#1': 'bad' is no number"));
}

TEST(CsvHeader, MayHaveNumbersAsNames) {
  EXPECT_THAT(read_table("\"0\",\"1\"\n5,6\n7,8\n").names, ElementsAre("0", "1"));
  EXPECT_THAT(read_table("t,0,1,2\n5,6,7,8\n1,2,3,4\n").names, ElementsAre("t", "0", "1", "2"));
  EXPECT_THAT(read_table("t,wx,wy,100\n5,6,7,8\n1,2,3,4\n").names,
              ElementsAre("t", "wx", "wy", "100"));
  EXPECT_THAT(read_table("\"0\",\"1\"\n\"5\",\"6\"\n").rows, SizeIs(2));
  EXPECT_THAT(read_table("0,1\n5,6\n").rows, SizeIs(2));
}

TEST(CsvHeader, OfTheFirstLineTakesPrecedence) {
  const Table table = read_table("# time,of,day,in s\nt,label,wx,wy\n" + rows, {0, 2});
  EXPECT_THAT(table.names, ElementsAre("t", "label", "wx", "wy"));
  EXPECT_THAT(table.rows, SizeIs(3));
}

TEST(CsvHeader, IsNotProse) {
  EXPECT_THAT(read_table("# made by hand today\n" + rows, {0, 2}).names,
              ElementsAre("#1", "#2", "#3", "#4"));
}

TEST(CsvHeader, HasItsUnitsInACommentOrALine) {
  EXPECT_THAT(units_of("# t,p\n# ms,deg/s\n0,1\n"), ElementsAre("ms", "deg/s"));
  EXPECT_THAT(units_of("# t,p\nms,deg/s\n0,1\n"), ElementsAre("ms", "deg/s"));
  EXPECT_THAT(read_table("# t,p\n# ms,deg/s\n0,1\n").names, ElementsAre("t", "p"));
  EXPECT_THAT(table_error_of("# t,p\nms,deg/s\n"), HasSubstr("a header, but no rows"));
}

TEST(CsvHeader, DoesNotTakeAnEmptyFirstCellForAComment) {
  const Table table = read_table(";t;w\n;0;1\n;2;3\n", {1, 2});
  EXPECT_THAT(table.names, ElementsAre("", "t", "w"));
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre(0, 1), ElementsAre(2, 3)));
  EXPECT_THAT(read_table("t;w\n;1\n2;3\n", {1}).rows, SizeIs(2));
  EXPECT_THAT(read_table("t,w\n; a note\n0,1\n// another\n2,3\n").rows, SizeIs(2));
}

// As OpenSim, LabVIEW, spreadsheets and loggers write them.
TEST(CsvHeader, MayFollowOtherLines) {
  using Rows = std::vector<std::vector<double>>;
  for (const char* before :
       {"motion\nversion=1\nnRows=2\nnColumns=3\ninDegrees=no\nendheader\n",
        "a, b\n***End_of_Header***\n\nChannels 3\n***End_of_Header***\n", "sep=,\n",
        "sep=,\nDevice:,A1\n", "Device:,A1\nRate:,50\n\n", "Exported by a logger\n# a comment\n"}) {
    const std::string text = std::string(before) + "t,wx,wy\n0,1,2\n3,4,5\n6,7,8\n";
    EXPECT_THAT(read_table(text).names, ElementsAre("t", "wx", "wy")) << before;
    EXPECT_EQ(read_table(text).rows, (Rows{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}})) << before;
  }
}

// Motion capture has the names of bodies and quantities above those of the columns.
TEST(CsvHeader, MayHaveGroupsOfColumnsAbove) {
  const auto names_of = [](const std::string& header, const std::string& data) {
    return read_table(header + data).names;
  };
  const std::string vicon = "Segments\n50\n,,body,,\nFrame,Sub Frame,RX,RY,RZ\n,,rad,rad,rad\n";
  EXPECT_THAT(names_of(vicon, "1,0,1,2,3\n2,0,1,2,3\n"),
              ElementsAre("Frame", "Sub Frame", "RX", "RY", "RZ"));
  EXPECT_THAT(units_of(vicon + "1,0,1,2,3\n2,0,1,2,3\n"), ElementsAre("", "", "rad", "rad", "rad"));
  EXPECT_THAT(names_of("50\n,A,,B,\nFrame,RX,RY,RX,RY\n", "1,1,2,3,4\n2,1,2,3,4\n"),
              ElementsAre("Frame", "A: RX", "A: RY", "B: RX", "B: RY"));
  EXPECT_THAT(
      names_of(",Name,A,A,B,B\n,,Turn,Shift,Turn,Shift\nFrame,Time,X,X,X,X\n",
               "1,1,2,3,4,5\n2,1,2,3,4,5\n"),
      ElementsAre("Frame", "Time", "A: Turn: X", "A: Shift: X", "B: Turn: X", "B: Shift: X"));
  EXPECT_THAT(names_of("Version,1.23,Rate,50.0,Type,Quaternion,Unit,m,More,1,2\n\n"
                       ",,1,1,1,1\n,,Rotation,Rotation,Position,Error\nFrame,Time,X,Y,X,\n",
                       "0,0,1,2,3,4\n1,1,1,2,3,4\n"),
              ElementsAre("Frame", "Time", "Rotation: X", "Rotation: Y", "Position: X", ""));
}

TEST(CsvHeader, IsNotARowOfWords) {
  EXPECT_THAT(table_error_of("t,a,b\nidle,idle,idle\n0,1,2\n1,2,3\n"), HasSubstr("run:2: "));
  EXPECT_THAT(table_error_of("t,a,b,c\nx,y,z,NA\n0,1,2,3\n1,2,3,4\n"), HasSubstr("run:2: "));
}

// A row that lacks a cell is an error, not a line before the table.
TEST(CsvHeader, FollowsNoLinesThatMayBeRows) {
  EXPECT_THAT(file_error_of("0,1\n0,1,2\n3,4,5\n6,7,8\n"), HasSubstr("cells"));
  EXPECT_THAT(table_error_of("0,1\nt,wx,wy\n0,1,2\n3,4,5\n6,7,8\n"), HasSubstr("run:2: "));
  EXPECT_THAT(file_error_of("t,wx\n0,1,2\n3,4,5\n6,7,8\n"), HasSubstr("run:2: the row has 3"));
}

}  // namespace
}  // namespace twrench::table
