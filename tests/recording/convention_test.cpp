#include "recording/conventions/convention.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

namespace twrench::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

std::string refusal_of_columns(std::string_view text) {
  try {
    parse_columns(text, "columns");
  } catch (const InvalidArgument& error) {
    return std::string(error.what()) + " -- " + error.remedy();
  }
  return "no error";
}

TEST(Columns, AreReadAsTheyAreSaid) {
  EXPECT_THAT(parse_columns("t=time,WX=p", "columns"),
              ElementsAre(Pair("t", "time"), Pair("wx", "p")));
  EXPECT_THAT(parse_columns("t=#3,wx=\"rate, x=1\",wy=\"the \"\"y\"\"\"", "columns"),
              ElementsAre(Pair("t", "#3"), Pair("wx", "rate, x=1"), Pair("wy", "the \"y\"")));
  EXPECT_THAT(parse_columns("t=time [s]", "columns"), ElementsAre(Pair("t", "time [s]")));
}

TEST(Columns, AreWrittenAsTheyAreRead) {
  for (const char* text : {"t=time,wx=p,wy=q,wz=r", "t=#3,wx=\"rate, x=1\",wy=\"the \"\"y\"\"\"",
                           "x11=a,x33=b,qw=w,yaw=\" h\""}) {
    EXPECT_EQ(format_columns(parse_columns(text, "columns")), text);
  }
}

TEST(Columns, AreRefusedWithARemedy) {
  EXPECT_THAT(refusal_of_columns("t"), HasSubstr("'t' has no '='"));
  EXPECT_THAT(refusal_of_columns("t=a,b"), HasSubstr("'b' has no '='"));
  EXPECT_THAT(refusal_of_columns("t=a,b,c=d"), HasSubstr("'b' has no '='"));
  EXPECT_THAT(refusal_of_columns("t="), HasSubstr("'t=' names no column"));
  EXPECT_THAT(refusal_of_columns("t=a,t=b"), HasSubstr("'t' is there twice"));
  EXPECT_THAT(refusal_of_columns("wxx=a"), HasSubstr("did you mean 'wx'?"));
  EXPECT_THAT(refusal_of_columns("pich=a"), HasSubstr("did you mean 'pitch'?"));
}

TEST(Sequences, AreTheTwelve) {
  EXPECT_EQ(parse_sequence("ZYX", "sequence"), "zyx");
  EXPECT_EQ(parse_sequence("zxz", "sequence"), "zxz");
  for (const char* text : {"", "zz", "zzx", "xyzz", "abc", "321"}) {
    EXPECT_THROW(parse_sequence(text, "sequence"), InvalidArgument) << text;
  }
}

}  // namespace
}  // namespace twrench::recording
