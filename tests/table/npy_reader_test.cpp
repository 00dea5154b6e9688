#include "table/npy_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include "table/read_table.h"

namespace twrench::table {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

/// A file that NumPy wrote (tests/reference/numpy_files.py).
std::string numpy_file(const std::string& name) {
  std::ifstream file(TWRENCH_TESTS_DIR "/reference/numpy/" + name, std::ios::binary);
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A file of version 1 with this header, followed by zeros.
std::string npy(const std::string& header, std::size_t zeros) {
  std::string file = "\x93NUMPY";
  file += '\x01';
  file += '\0';
  file += static_cast<char>(header.size() % 256);
  file += static_cast<char>(header.size() / 256);
  return file + header + std::string(zeros, '\0');
}

TEST(NpyReader, ReadsEveryOrderVersionAndType) {
  const auto rows = ElementsAre(ElementsAre(0, 1.5, -2.25), ElementsAre(0.1, 2.5, 1e-3),
                                ElementsAre(0.2, 3.5, 7));
  for (const char* name : {"f8.npy", "f8_fortran.npy", "version2.npy", "version3.npy"}) {
    const Table table = read_table(numpy_file(name));
    EXPECT_THAT(table.names, ElementsAre("#1", "#2", "#3")) << name;
    EXPECT_THAT(table.rows, rows) << name;
  }
  EXPECT_THAT(read_table(numpy_file("f4_big_endian.npy")).rows,
              ElementsAre(ElementsAre(0, 1.5, -2.25), ElementsAre(0.1F, 2.5, 1e-3F),
                          ElementsAre(0.2F, 3.5, 7)));
  EXPECT_THAT(read_table(numpy_file("i2.npy")).rows,
              ElementsAre(ElementsAre(0, 6, -9), ElementsAre(0, 10, 0), ElementsAre(0, 14, 28)));
}

TEST(NpyReader, NamesTheFieldsOfAStructuredArray) {
  const std::string file = numpy_file("structured.npy");
  const auto reader = open_table("run", file);
  EXPECT_THAT(reader->header().names, ElementsAre("t", "w[0]", "w[1]", "w[2]", "X[0][0]", "X[0][1]",
                                                  "X[1][0]", "X[1][1]", "note", "n"));
  EXPECT_THAT(read_table(file, {0, 2, 5, 6, 9}).rows,
              ElementsAre(ElementsAre(0, 1.5, 1, 2, 1), ElementsAre(0.5, 2.5, 5, 6, 2),
                          ElementsAre(1, 3.5, 9, 10, 255)));
  EXPECT_THAT(read_table(numpy_file("nested.npy")).names, ElementsAre("t", "rates.x", "rates.y"));
  EXPECT_THAT(read_table(numpy_file("nested.npy")).rows,
              ElementsAre(ElementsAre(0, 0, 5), ElementsAre(0, 0, 6)));
  EXPECT_THAT(read_table(numpy_file("padded.npy"), {2}).rows,
              ElementsAre(ElementsAre(1), ElementsAre(2)));
}

TEST(NpyReader, SaysWhatItDoesNotRead) {
  EXPECT_THAT(file_error_of(numpy_file("objects.npy")), HasSubstr("Python objects"));
  EXPECT_THAT(file_error_of(numpy_file("one_dimension.npy")), HasSubstr("has 1 dimensions"));
  EXPECT_THAT(table_error_of(numpy_file("complex.npy")),
              HasSubstr("type '<c16', which is not read"));
  EXPECT_THAT(table_error_of(numpy_file("structured.npy")),
              HasSubstr("'note' is of NumPy's type '<U5'"));
  EXPECT_THAT(table_error_of(numpy_file("no_rows.npy")), StartsWith("run: it has no rows"));
}

TEST(NpyReader, SaysThatAFileIsCutOff) {
  std::string file = numpy_file("f8.npy");
  file.pop_back();
  EXPECT_THAT(file_error_of(file),
              HasSubstr("cut off: 3 rows of 24 bytes are due, but only 71 bytes are there"));
  EXPECT_THAT(file_error_of(file.substr(0, 60)), HasSubstr("header of this NumPy file"));
  EXPECT_THAT(file_error_of(file.substr(0, 8)), HasSubstr("header of this NumPy file"));
}

TEST(NpyReader, RefusesHeadersThatCannotBe) {
  const auto with = [](const std::string& type, const std::string& shape) {
    return "{'descr': " + type + ", 'fortran_order': False, 'shape': " + shape + ", }";
  };
  for (const std::string& header :
       {std::string("nothing"), std::string("{}"), std::string("{'descr': '\\"),
        with("'<f8'", "'a'"), with("'<f8'", "(-1, 3)"), with("'f'", "(1, 3)"), with("''", "(1, 3)"),
        with("3", "(1, 3)"), with("[('t',)]", "(1,)"), with("[(1, '<f8')]", "(1,)"),
        with("'<f99999999999999999999'", "(1, 3)")}) {
    EXPECT_THAT(file_error_of(npy(header, 24)), HasSubstr("header of this NumPy file")) << header;
  }
  EXPECT_THAT(file_error_of(npy(with("'<f8'", "(1, 0)"), 24)), HasSubstr("no columns"));
  EXPECT_THAT(file_error_of(npy(with("'<f8'", "(18446744073709551615, 3)"), 24)),
              HasSubstr("cut off"));
  EXPECT_THAT(file_error_of(npy(with("'<f8'", "(1, 18446744073709551615)"), 24)),
              HasSubstr("columns"));
  EXPECT_THAT(file_error_of(npy(with("[('t', '<f8', (99999, 99999, 0))]", "(1,)"), 24)),
              HasSubstr("columns"));
  EXPECT_THAT(file_error_of(npy(with("[('t', [], (99999, 99999))]", "(1,)"), 24)),
              HasSubstr("columns"));
  EXPECT_THAT(file_error_of(npy(with("[('t', '|i1', (100001,))]", "(1,)"), 24)),
              HasSubstr("columns"));
  EXPECT_THAT(file_error_of(npy(with("[('a', '|V9000000'), ('b', '|V9000000')]", "(1,)"), 24)),
              HasSubstr("columns"));
  EXPECT_THAT(file_error_of(npy(with("'|V20000000'", "(1, 1)"), 24)), HasSubstr("header of this"));
  std::string version = npy(with("'<f8'", "(1, 1)"), 8);
  version[6] = 4;
  EXPECT_THAT(file_error_of(version), HasSubstr("version 4"));
}

TEST(NpyReader, ReadsAcrossTheEndsOfItsBuffers) {
  constexpr int count = 50'000;
  for (const bool fortran : {false, true}) {
    std::string file = npy(std::string("{'descr': '|u1', 'fortran_order': ") +
                               (fortran ? "True" : "False") + ", 'shape': (50000, 7), }",
                           0);
    for (int i = 0; i < 7 * count; ++i) {
      const int row = fortran ? i % count : i / 7;
      const int column = fortran ? i / count : i % 7;
      file += static_cast<char>((row + 100 * column) % 251);
    }
    const Table table = read_table(file, {6, 0});
    ASSERT_THAT(table.rows, SizeIs(count));
    for (int i = 0; i < count; ++i) {
      ASSERT_THAT(table.rows[static_cast<std::size_t>(i)], ElementsAre((i + 600) % 251, i % 251))
          << i;
    }
  }
}

}  // namespace
}  // namespace twrench::table
