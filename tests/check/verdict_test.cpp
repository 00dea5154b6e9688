#include <gtest/gtest.h>

#include "check/random_recording.h"
#include "check/wrong_simulator.h"
#include "sanitizers.h"
#include "scratch_folder.h"

namespace twrench::check {
namespace {

constexpr std::uint32_t seed_of_recordings = 2020;

// torture_verdicts tries twenty starts of each, and thousands of combinations.
TEST(Verdict, IsRightOfEverySingleMistake) {
  const ScratchFolder folder;
  std::uint32_t number = 0;
  for (const std::string& mistake : single_mistakes()) {
    for (const RecordedBody body :
         {RecordedBody::t_wrench, RecordedBody::nearly_symmetric, RecordedBody::toutatis}) {
      if (has_sanitizers && body != RecordedBody::t_wrench) continue;
      const RandomRecording recording = recording_with(mistake, body, seed_of_recordings, number++);
      EXPECT_EQ(fault_of_verdict(recording, folder.path()), "") << recording.description;
    }
  }
}

TEST(Verdict, IsRightOfRandomConventions) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const ScratchFolder folder;
  for (std::uint32_t number = 0; number < 12; ++number) {
    const RandomRecording recording = random_recording(seed_of_recordings, number);
    EXPECT_EQ(fault_of_verdict(recording, folder.path()), "") << number << recording.description;
  }
}

// torture_verdicts tries hundreds. With few digits or much noise, a mistake may stay unnamed.
TEST(Verdict, NamesTheMistakesOfSimulators) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const ScratchFolder folder;
  constexpr int tried = 32, named_at_least = 29;
  int named = 0;
  for (std::uint32_t number = 0; number < tried; ++number) {
    const WrongSimulation simulation = wrong_simulation(seed_of_recordings, number);
    const VerdictOnLaw verdict = verdict_on(simulation, folder.path());
    EXPECT_EQ(verdict.fault, "") << number << ": " << simulation.description;
    named += verdict.names_mistake ? 1 : 0;
  }
  EXPECT_GE(named, named_at_least);
}

void expect_right_reading(std::uint32_t seed, std::uint32_t number) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const ScratchFolder folder;
  EXPECT_EQ(fault_of_verdict(random_recording(seed, number), folder.path()), "");
}

void expect_named_mistake(std::uint32_t seed, std::uint32_t number) {
  const ScratchFolder folder;
  const VerdictOnLaw verdict = verdict_on(wrong_simulation(seed, number), folder.path());
  EXPECT_EQ(verdict.fault, "");
  EXPECT_TRUE(verdict.names_mistake);
}

// With a given omega, and moments so different that momenta in wrong axes mean far faster rates.
TEST(Verdict, IsRightOfMomentaInOtherAxes) { expect_right_reading(24102, 925); }

// The moments are nearly equal, so that the rates change by little more than their digits. In
// seconds, the gyroscopic term is multiplied by 60, and the rates change clearly.
TEST(Verdict, ProposesMinutesForMomentaOfANearlySphericalBody) {
  expect_right_reading(90101, 1206);
}

// The momentum about the long axis of this thin body has few digits, which the axes as read hide.
TEST(Verdict, ProposesFiveChangesThatExplainAllButTheDigits) { expect_right_reading(90101, 5647); }

// In rates in space, a half turn of the body shows in nothing: it is no other reading.
TEST(Verdict, ProposesNoReadingThatOnlyTurnsTheBody) { expect_right_reading(170601, 1569); }

// The rates of the first row are floats, printed with the fewest decimals, and their errors grow.
TEST(Verdict, ForgivesDecimalsOfFloats) { expect_right_reading(90102, 984); }

// Taken for seconds, these microseconds put the rows so far apart that the exact motion scatters
// beside them. That is no noise, in which laws would fit.
TEST(Verdict, TakesRowsThatAreFarApartForNoNoise) { expect_right_reading(61001, 3777); }

// The digits of these attitudes leave so much of the rates that moments fit no better by chance.
TEST(Verdict, PrefersAMistakeWithoutAFittedNumberInAttitudesAlone) {
  expect_named_mistake(72004, 191);
}

// In the noise of these attitudes, pairs of rows are so far apart that the rates turn once between
// them.
TEST(Verdict, NamesAFastLawOfAttitudesAlone) { expect_named_mistake(90102, 1115); }

// The rates of this law turn several times as fast as the body. Between rows of the attitude that
// suffice for slower ones, they are smoothed to those of another body.
TEST(Verdict, NamesALawThatTurnsTheRatesFasterThanTheBody) { expect_named_mistake(140501, 1739); }

// Of this body, which is almost symmetric, delayed rates look almost like those of a fixed part.
TEST(Verdict, PrefersALawThatExplainsFarMoreThanAReading) { expect_named_mistake(24102, 488); }

// The noise of the rates hides that a reading leaves more of the attitude than this law.
TEST(Verdict, ComparesReadingsAndLawsOfTheAttitudeApart) { expect_named_mistake(170601, 1364); }

// In noise, rows are compared between which this body turns by more than half a turn.
TEST(Verdict, NamesAMistakeBeyondHalfATurn) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  expect_named_mistake(24102, 1241);
}

// The rates follow no law to within their noise, so the attitude misses more than noise explains.
TEST(Verdict, BlamesNoAttitudeForRatesThatFollowNoLaw) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const ScratchFolder folder;
  EXPECT_EQ(verdict_on(wrong_simulation(31001, 572), folder.path()).fault, "");
}

}  // namespace
}  // namespace twrench::check
