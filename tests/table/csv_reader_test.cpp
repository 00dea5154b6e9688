#include "table/csv_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "table/read_table.h"

namespace twrench::table {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

TEST(CsvReader, ReadsNamesAndRows) {
  const Table table = read_table("t,wx,wy\n0,1.5,-2e-3\n0.1,+1.25,3\n");
  EXPECT_THAT(table.names, ElementsAre("t", "wx", "wy"));
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre(0, 1.5, -2e-3), ElementsAre(0.1, 1.25, 3)));
}

// Each separator as other programs write it.
TEST(CsvReader, ReadsEverySeparator) {
  for (const char* text :
       {"t,w\n0,1.5\n2,3\n", "t;w\n0;1.5\n2;3\n", "t\tw\n0\t1.5\n2\t3\n", "t|w\n0|1.5\n2|3\n",
        "t w\n0 1.5\n2 3\n", "  t    w\n  0  1.5\n  2    3\n", "t, w\n0, 1.5\n2, 3\n",
        "t \t w\r\n0 \t 1.5\r\n2 \t 3\r\n"}) {
    const Table table = read_table(text);
    EXPECT_THAT(table.names, ElementsAre("t", "w")) << text;
    EXPECT_THAT(table.rows, ElementsAre(ElementsAre(0, 1.5), ElementsAre(2, 3))) << text;
  }
}

TEST(CsvReader, PassesOverCommentsBlankLinesAndAMark) {
  const Table table =
      read_table("\xEF\xBB\xBF# made by hand\n\nt,w\r\n% more\r\n0,1\r\n   \r\n#2,3\r\n4,5");
  EXPECT_THAT(table.names, ElementsAre("t", "w"));
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre(0, 1), ElementsAre(4, 5)));
}

TEST(CsvReader, ReadsQuotedNamesAndCells) {
  const Table table = read_table("\"t, s\",\"the \"\"rate\"\"\"\n\"0\",\"1.5\"\n2,3\n");
  EXPECT_THAT(table.names, ElementsAre("t, s", "the \"rate\""));
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre(0, 1.5), ElementsAre(2, 3)));
}

TEST(CsvReader, NumbersColumnsWithoutNames) {
  const Table table = read_table("0,1,nan\n2,3,inf\n");
  EXPECT_THAT(table.names, ElementsAre("#1", "#2", "#3"));
  ASSERT_THAT(table.rows, SizeIs(2));
  EXPECT_TRUE(std::isnan(table.rows[0][2]));
  EXPECT_TRUE(std::isinf(table.rows[1][2]));
}

// As numpy.savetxt(..., header="t w") writes them.
TEST(CsvReader, TakesNamesFromTheCommentBeforeTheRows) {
  EXPECT_THAT(read_table("# run 7 of August\n# t w\n0 1\n2 3\n").names, ElementsAre("t", "w"));
  EXPECT_THAT(read_table("#t,w\n0,1\n2,3\n").names, ElementsAre("t", "w"));
  EXPECT_THAT(read_table("# nothing to see\n0,1\n2,3\n").names, ElementsAre("#1", "#2"));
  EXPECT_THAT(read_table("# nothing to see\nt,w\n2,3\n").names, ElementsAre("t", "w"));
}

TEST(CsvReader, TakesARowOfUnitsForWhatItIs) {
  const auto reader = open_table("run", "time,p,name\ns,deg/s,-\n0,1,2\n");
  EXPECT_THAT(reader->header().units, ElementsAre("s", "deg/s", "-"));
  EXPECT_THAT(read_table("time,p\n[s],[rad/s]\n0,1\n").rows, ElementsAre(ElementsAre(0, 1)));
  EXPECT_THAT(table_error_of("time,p\na,b\n0,1\n"),
              StartsWith("run:2: the column 'time': 'a' is no number"));
}

TEST(CsvReader, ReadsDecimalCommas) {
  const Table table = read_table("t;w\n0;1,5\n0,1;2\n1,234;-3,25e2\n");
  EXPECT_THAT(table.rows,
              ElementsAre(ElementsAre(0, 1.5), ElementsAre(0.1, 2), ElementsAre(1.234, -325)));
  EXPECT_THAT(read_table("t,w\n\"0,5\",\"1,5\"\n").rows, ElementsAre(ElementsAre(0.5, 1.5)));
  EXPECT_THAT(read_table("0,0 1,5\n1,0 2,5\n").rows,
              ElementsAre(ElementsAre(0, 1.5), ElementsAre(1, 2.5)));
}

TEST(CsvReader, DoesNotGuessWhatACommaIs) {
  EXPECT_THAT(file_error_of("t;w\n0;1,234\n1;2,345\n"),
              AllOf(StartsWith("run:3: '2,345' may have a decimal comma, or one that groups"),
                    HasSubstr("decimal point")));
  EXPECT_THAT(table_error_of("t;w\n0;1,5\n1;2.5\n"), HasSubstr("run:3: the column 'w': '2.5' is"));
  // Commas separate both cells and decimals, so rows have twice as many cells as the header.
  EXPECT_THAT(file_error_of("t,w\n0,5,1,5\n"),
              AllOf(StartsWith("run:2: the row has 4 cells, but there are 2 columns"),
                    HasSubstr("semicolons")));
}

TEST(CsvReader, ConvertsOnlyWhatIsSelected) {
  const std::string_view text = "t,note,w,more\n0,abc,1,x\n2,\"d,e\",3,\n";
  EXPECT_THAT(read_table(text, {2, 0}).rows, ElementsAre(ElementsAre(1, 0), ElementsAre(3, 2)));
  EXPECT_THAT(table_error_of(text), StartsWith("run:2: the column 'note': 'abc' is no number"));
  EXPECT_THAT(read_table(text, {0, 0}).rows, ElementsAre(ElementsAre(0, 0), ElementsAre(2, 2)));
}

TEST(CsvReader, AllowsASeparatorAtTheEnd) {
  EXPECT_THAT(read_table("t,w\n0,1,\n2,3, \n").rows,
              ElementsAre(ElementsAre(0, 1), ElementsAre(2, 3)));
  EXPECT_THAT(read_table("t,w,\n0,1,\n2,3\n", {0, 1}).rows,
              ElementsAre(ElementsAre(0, 1), ElementsAre(2, 3)));
}

TEST(CsvReader, SaysWhereRowsAreRagged) {
  EXPECT_THAT(file_error_of("t,w\n0,1\n\n2\n"),
              StartsWith("run:4: the row has 1 cell, but there are 2"));
  EXPECT_THAT(file_error_of("t,w\n0,1\n2,3,4\n"), StartsWith("run:3: the row has 3 cells"));
  EXPECT_THAT(file_error_of("t w\n0 1\n2 3 4\n"), StartsWith("run:3: the row has 3 cells"));
}

TEST(CsvReader, SaysWhereACellIsNoNumber) {
  EXPECT_THAT(table_error_of("t,w\n0,1\n1,\n"),
              StartsWith("run:3: the column 'w': the cell is empty"));
  EXPECT_THAT(table_error_of("t,w\n0,1\n1,12:30\n"),
              StartsWith("run:3: the column 'w': '12:30' is no number"));
  EXPECT_THAT(table_error_of("t,w\n0,1\n1,1e999\n"), HasSubstr("beyond what a double can hold"));
  EXPECT_THAT(table_error_of("t,w\n0,1\n1," + std::string(100, 'x') + "\n"),
              HasSubstr("'" + std::string(40, 'x') + "...'"));
}

TEST(CsvReader, SaysThatThereAreNoRows) {
  EXPECT_THAT(table_error_of("t,w\n"), StartsWith("run: it has a header, but no rows"));
  EXPECT_THAT(table_error_of("t,w\ns,rad/s\n# the end"), HasSubstr("a header, but no rows"));
  EXPECT_THAT(table_error_of("\n# nothing\n"), HasSubstr("it has no rows"));
  EXPECT_THAT(file_error_of(""), StartsWith("run: the file is empty"));
}

TEST(CsvReader, RefusesAQuotedCellThatGoesOn) {
  EXPECT_THAT(file_error_of("t,w\n0,\"1\n2\",3\n"),
              StartsWith("run:2: a quotation mark is not closed"));
}

TEST(CsvReader, RefusesLinesOfAnEarlierAge) {
  EXPECT_THAT(file_error_of("t,w\r0,1\r2,3\r"), HasSubstr("its lines end with CR alone"));
}

TEST(CsvReader, RefusesALineWithoutEnd) {
  const std::string line(LineReader::max_bytes + 1, '1');
  EXPECT_THAT(file_error_of("t,w\n0,1\n0," + line), StartsWith("run:3: the line is longer than"));
}

// Buffers end within lines, numbers and line ends.
TEST(CsvReader, ReadsRowsAcrossTheEndsOfItsBuffers) {
  std::string text = "t,w\r\n";
  constexpr int count = 60'000;
  for (int i = 0; i < count; ++i) text += std::to_string(i) + "," + std::to_string(7 * i) + "\r\n";
  const Table table = read_table(text);
  ASSERT_THAT(table.rows, SizeIs(count));
  for (int i = 0; i < count; ++i) {
    ASSERT_THAT(table.rows[static_cast<std::size_t>(i)], ElementsAre(i, 7 * i));
  }
}

TEST(CsvReader, CountsLinesForItsMessages) {
  const auto reader = open_table("run.csv", "# a\n\nt,w\n0,1\n# b\n2,3\n");
  const std::vector<std::size_t> columns{0, 1};
  reader->begin_pass(columns);
  std::vector<Number> numbers(2);
  reader->next(numbers);
  EXPECT_EQ(reader->place(), "run.csv:4");
  reader->next(numbers);
  EXPECT_EQ(reader->place(), "run.csv:6");
}

TEST(CsvReader, ReadsMixedLineEndsAndRefusesMarksWithin) {
  EXPECT_EQ(read_table("t,w\r\n0,1\n2,3\r\n").rows,
            (std::vector<std::vector<double>>{{0, 1}, {2, 3}}));
  EXPECT_THAT(table_error_of("t,w\n0,1\n\xEF\xBB\xBF"
                             "2,3\n"),
              testing::HasSubstr("run:3: the column 't'"));
  EXPECT_THAT(table_error_of("t,w\n0,1\r2\n4,5\n"), testing::HasSubstr("run:2"));
}

TEST(CsvReader, RefusesManyColumnsSoon) {
  std::string names = "t", row = "0";
  for (int i = 0; i < 100'000; ++i) {
    names += ",a" + std::to_string(i);
    row += ",1";
  }
  EXPECT_THAT(file_error_of(names + "\n" + row + "\n" + row + "\n"),
              testing::HasSubstr("it has 100001 columns"));
}

TEST(CsvReader, ReadsDurationsInSeconds) {
  EXPECT_EQ(read_table("Time,w\n0.25 sec,1\n0.5 sec,2\n").rows,
            (std::vector<std::vector<double>>{{0.25, 1}, {0.5, 2}}));
  EXPECT_THAT(table_error_of("Time,w\n0.25 min,1\n0.5 min,2\n"),
              HasSubstr("'0.25 min' is no number"));
}

}  // namespace
}  // namespace twrench::table
