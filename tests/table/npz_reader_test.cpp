#include "table/npz_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "system/error.h"
#include "table/error.h"
#include "zip_file.h"

namespace twrench::table {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The file of an array of doubles 0, 1, 2 ... with this shape, as NumPy writes it.
std::string array_file(const std::string& shape, std::size_t count, bool fortran_order = false) {
  std::string header = fmt::format("{{'descr': '<f8', 'fortran_order': {}, 'shape': ({}), }}",
                                   fortran_order ? "True" : "False", shape);
  header.resize(118, ' ');
  std::string file = "\x93NUMPY\x01" + std::string(1, '\0') + "v" + std::string(1, '\0') + header;
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = static_cast<double>(i);
    file.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return file;
}

std::vector<std::string> names_of_archive(const std::string& bytes) {
  return open_table("a.npz", std::string_view(bytes))->header().names;
}

/// All rows of these columns.
std::vector<std::vector<double>> rows_of_archive(const std::string& bytes,
                                                 const std::vector<std::size_t>& columns) {
  const auto reader = open_table("a.npz", std::string_view(bytes));
  reader->begin_pass(columns);
  std::vector<Number> numbers(columns.size());
  std::vector<std::vector<double>> rows;
  while (reader->next(numbers)) {
    std::vector<double>& row = rows.emplace_back();
    for (const Number& number : numbers) row.push_back(number.value);
  }
  return rows;
}

std::string refusal_of_archive(const std::string& bytes) {
  try {
    const auto reader = open_table("a.npz", std::string_view(bytes));
    std::vector<std::size_t> columns(reader->header().names.size());
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    reader->begin_pass(columns);
    std::vector<Number> numbers(columns.size());
    while (reader->next(numbers)) continue;
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

const NamedFile times{"time.npy", array_file("4,", 4)};
const NamedFile rates{"omega.npy", array_file("4, 3", 12)};

TEST(Npz, HasTheColumnsOfAllArrays) {
  const std::string bytes =
      archive_of({times, rates, {"X.npy", array_file("4, 2, 2", 16)}, {"notes.txt", "none"}});
  EXPECT_THAT(names_of_archive(bytes), ElementsAre("time", "omega[0]", "omega[1]", "omega[2]",
                                                   "X[0][0]", "X[0][1]", "X[1][0]", "X[1][1]"));
  const auto rows = rows_of_archive(bytes, {3, 0, 1, 6});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_THAT(rows[0], ElementsAre(2, 0, 0, 2));
  EXPECT_THAT(rows[3], ElementsAre(11, 3, 9, 14));
}

// The first index is fastest: omega[i] of row n is 4 i + n, X[i][j] is 4 (i + 2 j) + n.
TEST(Npz, ReadsFortransOrder) {
  const std::string bytes = archive_of({times,
                                        {"omega.npy", array_file("4, 3", 12, true)},
                                        {"X.npy", array_file("4, 2, 2", 16, true)}});
  EXPECT_THAT(rows_of_archive(bytes, {1, 2, 3, 5, 6})[1], ElementsAre(1, 5, 9, 9, 5));
}

TEST(Npz, IgnoresArraysOfParameters) {
  EXPECT_THAT(names_of_archive(archive_of({{"a.npy", array_file("3,", 3)},
                                           {"b.npy", array_file("3,", 3)},
                                           {"c.npy", array_file("", 1)},
                                           times,
                                           rates})),
              ElementsAre("time", "omega[0]", "omega[1]", "omega[2]"));
}

TEST(Npz, NumbersColumnsOfArraysWithoutNames) {
  EXPECT_THAT(names_of_archive(archive_of(
                  {{"arr_0.npy", array_file("4,", 4)}, {"arr_1.npy", array_file("4, 3", 12)}})),
              ElementsAre("#1", "#2", "#3", "#4"));
}

TEST(Npz, ReadsMoreThanFitsInMemoryAtOnce) {
  constexpr std::size_t count = 100'000;
  const std::string bytes = archive_of(
      {{"t.npy", array_file("100000,", count)}, {"w.npy", array_file("100000, 3", 3 * count)}});
  const auto rows = rows_of_archive(bytes, {0, 3});
  ASSERT_EQ(rows.size(), count);
  for (std::size_t i = 0; i < count; i += 997) {
    EXPECT_THAT(rows[i], ElementsAre(static_cast<double>(i), static_cast<double>(3 * i + 2)));
  }
}

TEST(Npz, RefusesWhatIsCutOffOrDamaged) {
  const std::string bytes = archive_of({times, rates});
  ASSERT_EQ(refusal_of_archive(bytes), "no error");
  for (const std::size_t length : {std::size_t{40}, bytes.size() / 2, bytes.size() - 1}) {
    EXPECT_THAT(refusal_of_archive(bytes.substr(0, length)), HasSubstr("cut off or damaged"));
  }
  std::string damaged = archive_of({times, rates}, store);
  damaged[damaged.find("NUMPY") + 150] ^= 1;  // one of the numbers
  EXPECT_THAT(refusal_of_archive(damaged), HasSubstr("a.npz: time.npy: it cannot be unpacked"));
}

TEST(Npz, RefusesSizesThatAreNotThoseOfTheArrays) {
  EXPECT_THAT(refusal_of_archive(archive_of({{"t.npy", array_file("4,", 3)}})),
              HasSubstr("4 rows of 8 bytes are due, but only 24 bytes are there"));
  EXPECT_THAT(refusal_of_archive(archive_of({{"t.npy", array_file("4,", 100'000)}})),
              HasSubstr("799968 bytes follow the array"));
  EXPECT_THAT(refusal_of_archive(archive_of({{"t.npy", array_file("99999999999999,", 4)}})),
              HasSubstr("are due"));
}

TEST(Npz, RefusesSizesThatNoBytesCanHave) {
  std::string bytes = archive_of({times});
  const std::size_t directory = bytes.find("PK\x01\x02");
  const std::uint32_t size = 1 << 30;
  std::memcpy(bytes.data() + directory + 24, &size, sizeof size);
  std::memcpy(bytes.data() + 22, &size, sizeof size);  // in the header of the member, too
  EXPECT_THAT(refusal_of_archive(bytes), HasSubstr("its 1073741824 bytes cannot be packed in"));
}

TEST(Npz, RefusesEncryptedArrays) {
  EXPECT_THAT(refusal_of_archive(archive_of({times, rates}, encrypt)),
              HasSubstr("a.npz: time.npy: it is encrypted"));
}

TEST(Npz, RefusesArraysOfNearlyEqualLengths) {
  EXPECT_THAT(refusal_of_archive(archive_of(
                  {{"t.npy", array_file("200,", 200)}, {"w.npy", array_file("199, 3", 597)}})),
              HasSubstr("its array w has 199 rows, but others have 200"));
}

TEST(Npz, RefusesOtherArchives) {
  EXPECT_THAT(refusal_of_archive(archive_of({{"xl/workbook.xml", "<workbook/>"}})),
              HasSubstr("a ZIP archive without NumPy's arrays"));
}

}  // namespace
}  // namespace twrench::table
