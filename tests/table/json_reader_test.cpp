#include "table/json_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "table/read_table.h"

namespace twrench::table {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

TEST(JsonReader, ReadsAnArrayOfObjects) {
  const Table table =
      read_table("\xEF\xBB\xBF [{\"t\": 0, \"w\": 1.5},\n {\"w\": -2e-3, \"t\": 1}] ");
  EXPECT_THAT(table.names, ElementsAre("t", "w"));
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre(0, 1.5), ElementsAre(1, -2e-3)));
}

TEST(JsonReader, ReadsAnArrayOfArrays) {
  const Table table = read_table("[[0, 1.5], [1, 2]]");
  EXPECT_THAT(table.names, ElementsAre("#1", "#2"));
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre(0, 1.5), ElementsAre(1, 2)));
}

TEST(JsonReader, ReadsALineForEachRow) {
  EXPECT_THAT(read_table("{\"t\":0,\"w\":1}\n{\"t\":1,\"w\":2}\n").rows,
              ElementsAre(ElementsAre(0, 1), ElementsAre(1, 2)));
}

// As `simulate` writes it, and with other values before and after the samples.
TEST(JsonReader, ReadsTheSamplesOfADocument) {
  const Table table = read_table(
      R"({"scene": {"name": "a]}", "samples": [1]}, "samples": [
          {"t": 0, "X": [1, 0], "omega": [0.5]}, {"t": 1, "X": [0, 1], "omega": [0.25]}],
          "end": null})");
  EXPECT_THAT(table.names, ElementsAre("t", "X[0]", "X[1]", "omega[0]"));
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre(0, 1, 0, 0.5), ElementsAre(1, 0, 1, 0.25)));
}

TEST(JsonReader, NamesWhatIsNested) {
  EXPECT_THAT(read_table(R"([{"R": [[1, 2], [3, 4]], "w": {"x": 5, "y": [6]}, "z": 7}])").names,
              ElementsAre("R[0][0]", "R[0][1]", "R[1][0]", "R[1][1]", "w.x", "w.y[0]", "z"));
  EXPECT_THAT(read_table("[[1, [2, 3], 4]]").names, ElementsAre("#1", "#2[0]", "#2[1]", "#3"));
}

TEST(JsonReader, SaysWhereACellIsNoNumber) {
  EXPECT_THAT(table_error_of("[{\"t\":0},\n{\"t\":null}]"),
              StartsWith("run:2: the column 't': 'null' is no number"));
  EXPECT_THAT(table_error_of("[{\"t\":\"0\"}]"),
              StartsWith("run:1: the column 't': '0' is no number"));
  EXPECT_THAT(file_error_of("[{\"t\":0},\n\n{\"s\":1}]"), StartsWith("run:3: the row has no 't'"));
  EXPECT_THAT(file_error_of("[{\"t\":1e999}]"), HasSubstr("beyond what a double can hold"));
  EXPECT_THAT(file_error_of("[{\"t\":NaN}]"), HasSubstr("is no JSON"));
}

TEST(JsonReader, SaysWhatIsNoTable) {
  EXPECT_THAT(table_error_of("[]"), StartsWith("run: it has no rows"));
  EXPECT_THAT(table_error_of("{\"samples\": []}"), StartsWith("run: it has no rows"));
  EXPECT_THAT(file_error_of("[[1, 2], 3]"), HasSubstr("neither an object nor an array"));
  EXPECT_THAT(file_error_of("[{}]"), StartsWith("run: its first row is empty"));
  EXPECT_THAT(file_error_of("[[1, 2]"), HasSubstr("the file ends"));
  EXPECT_THAT(file_error_of("[[1, 2], [3"), HasSubstr("the file ends within the value"));
  EXPECT_THAT(file_error_of("[{\"a"), HasSubstr("the file ends within a string"));
  EXPECT_THAT(file_error_of("[[1, 2]\n [3, 4]]"),
              StartsWith("run:2: there is '[' where ',' is due"));
  EXPECT_THAT(file_error_of("[[1, 2]] 3"), HasSubstr("more text after the end"));
  EXPECT_THAT(file_error_of("{\"samples\": [[1]], \"a\": 1"), HasSubstr("the file ends where '}'"));
  EXPECT_THAT(file_error_of("[" + std::string(1000, '[')), HasSubstr("nested more than 8 deep"));
  EXPECT_THAT(file_error_of("[[1, 2,,]]"), HasSubstr("is no JSON at its byte 7"));
}

TEST(JsonReader, KeepsItsMemoryBounded) {
  std::string one = "[[0";
  while (one.size() < JsonCursor::max_bytes) one += ",1000000000000";
  EXPECT_THAT(file_error_of(one + "]]"), HasSubstr("longer than 1048576 bytes"));
  // Columns instead of rows.
  EXPECT_THAT(file_error_of("{\"t\": " + one + "]]}"), HasSubstr("expected an array of rows"));
}

TEST(JsonReader, ReadsRowsAcrossTheEndsOfItsBuffers) {
  std::string text = "[";
  constexpr int count = 30'000;
  for (int i = 0; i < count; ++i) {
    text += (i > 0 ? ",\n" : "") + ("{\"t\": " + std::to_string(i) + ", \"w\": [1.25]}");
  }
  const Table table = read_table(text + "]");
  ASSERT_THAT(table.rows, SizeIs(count));
  for (int i = 0; i < count; ++i) {
    ASSERT_THAT(table.rows[static_cast<std::size_t>(i)], ElementsAre(i, 1.25));
  }
}

TEST(JsonReader, TellsTheDigitsAsTheyAreWritten) {
  const auto reader = open_table("run", "[[0.50, 12, 1.5e-3]]");
  const std::vector<std::size_t> columns{0, 1, 2};
  reader->begin_pass(columns);
  std::vector<Number> numbers(3);
  ASSERT_TRUE(reader->next(numbers));
  EXPECT_EQ(numbers[0].decimals, 2);
  EXPECT_EQ(numbers[1].decimals, 0);
  EXPECT_EQ(numbers[2].decimals, 4);
  EXPECT_EQ(numbers[2].significant, 2);
}

TEST(JsonObject, HasItsRowsInAnyMember) {
  const Table rows = read_table(R"([{"t": 0, "w": {"x": 1}}, {"t": 0.5, "w": {"x": 2}}])");
  for (const char* object :
       {R"({"info": {"rate": 2}, "data": [{"t": 0, "w": {"x": 1}}, {"t": 0.5, "w": {"x": 2}}]})",
        R"({"t": [0, 0.5], "w": {"x": [1, 2]}, "axes": [1, 2, 3]})",
        R"({"columns": ["t", "w.x"], "index": [0, 1], "data": [[0, 1], [0.5, 2]]})",
        R"({"t": {"0": 0, "1": 0.5}, "w.x": {"0": 1, "1": 2}})"}) {
    EXPECT_EQ(read_table(object).names, rows.names) << object;
    EXPECT_EQ(read_table(object).rows, rows.rows) << object;
  }
  EXPECT_EQ(read_table(R"({"meta": {"n": 2}, "log": {"t": [0, 1], "w": {"x": [1, 2]}}})").names,
            (std::vector<std::string>{"log.t", "log.w.x"}));
  EXPECT_EQ(read_table(R"({"t": [0, 1], "q": [[1, 2], [3, 4]]})").names,
            (std::vector<std::string>{"t", "q[0]", "q[1]"}));
}

// The names that three.js gives to tracks determine their components.
TEST(JsonObject, HasTheTracksOfAnimations) {
  const Table table = read_table(
      R"({"name": "spin", "duration": 0.1, "tracks": [
        {"name": "box.scale", "type": "vector", "times": [0], "values": [1, 1, 1]},
        {"name": "box.quaternion", "type": "quaternion", "times": [0, 0.1],
         "values": [0, 0, 0, 1, 0.5, 0.5, 0.5, 0.5]},
        {"name": "box.position", "type": "vector", "times": [0, 0.1],
         "values": [1, 2, 3, 4, 5, 6]}]})");
  EXPECT_EQ(table.names,
            (std::vector<std::string>{"time", "box.quaternion.x", "box.quaternion.y",
                                      "box.quaternion.z", "box.quaternion.w", "box.position.x",
                                      "box.position.y", "box.position.z"}));
  EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0, 0, 0, 0, 1, 1, 2, 3},
                                                          {0.1, 0.5, 0.5, 0.5, 0.5, 4, 5, 6}}));
  // Values that do not belong to the times are no track.
  EXPECT_EQ(read_table(R"({"tracks": [{"name": "a.quaternion", "times": [0, 1],
                                       "values": [0, 0, 0, 1]}]})",
                       {1})
                .names[0],
            "name");
}

TEST(JsonObject, StatesNumbersBesideItsRows) {
  const std::string text = R"({"fps": 50, "by": "me", "frames": [{"frame": 0}, {"frame": 1}]})";
  EXPECT_EQ(open_table("run", std::string_view(text))->header().preamble,
            std::vector<std::string>{"fps: 50"});
}

TEST(JsonObject, NamesTheRowOfAMistake) {
  EXPECT_THAT(table_error_of(R"({"t": [0, 1], "w": [3, "x"]})"),
              testing::HasSubstr("run: row 2: the column 'w': 'x' is no number"));
}

TEST(JsonObject, MayBeLargeAndIsNotDeep) {
  std::string text = "{\"t\": [0";
  for (int i = 1; i < 200'000; ++i) text += fmt::format(",{}", i);
  text += "], \"w\": [";
  for (int i = 0; i < 200'000; ++i) text += i == 0 ? "7" : ",7";
  EXPECT_EQ(read_table(text + "]}").rows.size(), 200'000U);
  EXPECT_THAT(file_error_of(text + "]"), testing::HasSubstr("longer than"));
  const std::string deep(100'000, '[');
  EXPECT_NE(file_error_of("{\"data\": " + deep + std::string(100'000, ']') + "}"), "no error");
}

}  // namespace
}  // namespace twrench::table
