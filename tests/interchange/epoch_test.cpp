#include "interchange/epoch.h"

#include <gtest/gtest.h>
#include <twrench/base/error.h>

namespace twrench::interchange {
namespace {

TEST(Epoch, IsWrittenAsItWasRead) {
  for (const std::string text : {"2026-01-01T00:00:00", "1996-11-28T21:29:07",
                                 "2024-02-29T23:59:59", "0001-01-01T00:00:00"}) {
    EXPECT_EQ(format_epoch(parse_epoch(text, "epoch"), 0, 9), text + ".000000000");
  }
}

TEST(Epoch, GoesOnOverDaysAndYears) {
  const Epoch epoch = parse_epoch("2023-12-31T23:59:59", "epoch");
  EXPECT_EQ(format_epoch(epoch, 16'666'667, 9), "2023-12-31T23:59:59.016666667");
  EXPECT_EQ(format_epoch(epoch, 1'000'000'000, 9), "2024-01-01T00:00:00.000000000");
  EXPECT_EQ(format_epoch(epoch, 60 * 86'400'000'000'000 + 5, 9), "2024-02-29T23:59:59.000000005");
}

TEST(Epoch, HasAsManyDecimalsAsAsked) {
  const Epoch epoch = parse_epoch("2023-12-31T23:59:59", "epoch");
  EXPECT_EQ(format_epoch(epoch, 4, 1), "2023-12-31T23:59:59.4");
  EXPECT_EQ(format_epoch(epoch, 1'000'000'000'000'000'007, 18),
            "2024-01-01T00:00:00.000000000000000007");
  EXPECT_EQ(format_epoch(parse_epoch("9999-12-31T23:59:59", "epoch"), 9, 1),
            "9999-12-31T23:59:59.9");
}

TEST(Epoch, RefusesWhatIsNone) {
  for (const char* text : {"", "2026-01-01", "2026-01-01 00:00:00", "2026-01-01T00:00:00Z",
                           "2026-01-01T00:00:00.5", "2026-13-01T00:00:00", "2026-00-01T00:00:00",
                           "2025-02-29T00:00:00", "2026-01-01T24:00:00", "2026-01-01T00:60:00",
                           "2026-01-01T00:00:60", "0000-01-01T00:00:00", "+026-01-01T00:00:00"}) {
    EXPECT_THROW(parse_epoch(text, "epoch"), InvalidArgument) << text;
  }
  EXPECT_THROW(format_epoch(parse_epoch("9999-12-31T23:59:59", "epoch"), 1'000'000'000, 9),
               InvalidArgument);
}

}  // namespace
}  // namespace twrench::interchange
