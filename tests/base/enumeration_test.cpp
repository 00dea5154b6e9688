#include "base/enumeration.h"

#include <gmock/gmock.h>
#include <twrench/base/error.h>

#include <array>

namespace twrench {
namespace {

using testing::ElementsAre;

namespace inner {
enum class Metal { iron, zinc_oxide, tin };
struct Alloy {
  enum class Kind : unsigned char { brass };
};
}  // namespace inner

using inner::Metal;

struct Row {
  Metal metal;
  int melting_point;
};

TEST(Enumeration, ListsTheEnumeratorsInTheirOrder) {
  EXPECT_THAT(enumerators<Metal>, ElementsAre(Metal::iron, Metal::zinc_oxide, Metal::tin));
  EXPECT_THAT(enumerators<inner::Alloy::Kind>, ElementsAre(inner::Alloy::Kind::brass));
}

TEST(Enumeration, NamesAreThoseOfTheSource) {
  EXPECT_THAT(enumerator_names<Metal>(), ElementsAre("iron", "zinc_oxide", "tin"));
  EXPECT_THAT(enumerator_names<inner::Alloy::Kind>(), ElementsAre("brass"));
  static_assert(enumerator_name(Metal::tin) == "tin");
}

TEST(Enumeration, FindsAnEnumeratorByItsName) {
  EXPECT_EQ(find_enumerator<Metal>("tin", "metal"), Metal::tin);
}

TEST(Enumeration, SuggestsTheNearestName) {
  try {
    find_enumerator<Metal>("irn", "metal");
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "metal: unknown name 'irn'");
    EXPECT_EQ(error.remedy(), "did you mean 'iron'? one of: iron, zinc_oxide, tin");
  }
}

TEST(Enumeration, ATableHasARowForEachEnumeratorInTheirOrder) {
  constexpr std::array whole{Row{Metal::iron, 1811}, Row{Metal::zinc_oxide, 2247},
                             Row{Metal::tin, 505}};
  constexpr std::array short_of_one{whole[0], whole[1]};
  constexpr std::array swapped{whole[1], whole[0], whole[2]};
  constexpr std::array twice{whole[0], whole[1], whole[2], whole[2]};
  static_assert(has_row_for_each(whole, &Row::metal));
  static_assert(!has_row_for_each(short_of_one, &Row::metal));
  static_assert(!has_row_for_each(swapped, &Row::metal));
  static_assert(!has_row_for_each(twice, &Row::metal));
}

}  // namespace
}  // namespace twrench
