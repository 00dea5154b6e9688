#include "recording/recording.h"

#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/words.h"
#include "check/hypotheses/hypotheses.h"
#include "check/recordings.h"
#include "check/report/choice.h"
#include "recording/columns/open_conventions.h"
#include "sanitizers.h"
#include "table/error.h"

namespace twrench::check {
namespace {

using recording::Convention;
using recording::Recording;

using testing::SizeIs;

/// Counts the passes over a table.
class CountedReader : public table::Reader {
 public:
  CountedReader(std::unique_ptr<table::Reader> table, int& passes)
      : table_(std::move(table)), passes_(&passes) {
    header_ = table_->header();
  }

  void begin_pass(std::span<const std::size_t> columns) override {
    ++*passes_;
    table_->begin_pass(columns);
  }
  bool next(std::span<table::Number> numbers) override { return table_->next(numbers); }
  std::string place() const override { return table_->place(); }

 private:
  std::unique_ptr<table::Reader> table_;
  int* passes_;
};

/// Rates and quaternions whose names leave the place of the scalar open.
std::string quaternions() {
  std::string text = "t,wx,wy,wz,q1,q2,q3,q4\n";
  for (const recording::Row& row : exact_rows()) {
    const Eigen::Quaterniond q(row.X);
    text += fmt::format("{:.12g},{},{},{},{},{},{},{}\n", row.t, row.omega[0], row.omega[1],
                        row.omega[2], q.w(), q.x(), q.y(), q.z());
  }
  return text;
}

TEST(Recording, IsOpenedOnce) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "run.csv";
  system::write_file_atomically(file, csv_of(exact_rows(), Parts::both));
  const Recording recording(file);
  std::filesystem::remove(file);
  EXPECT_EQ(recording.name(), file.string());
  const Convention convention = choose_convention(recording, {}, tumbling_problem());
  EXPECT_TRUE(judge(recording, convention, tumbling_problem()).within_digits);
  Problem problem = tumbling_problem();
  problem.fit = true;
  problem.frame = FrameSource::momentum;
  EXPECT_LT(judge(recording, convention, problem).attitude->max, 1e-9);
  Convention inverse = convention;
  inverse.inverse = true;
  const Judgement judgement = judge(recording, inverse, tumbling_problem());
  const Alternatives found = better_readings(recording, tumbling_problem(), judgement);
  ASSERT_THAT(found.fitting, SizeIs(1));
  EXPECT_FALSE(found.fitting.front().convention.inverse);
}

TEST(Recording, KeepsItsFirstRowsForAllConventions) {
  const std::string text = quaternions();
  int passes = 0;
  const Recording recording(
      std::make_unique<CountedReader>(table::open_table("run.csv", text), passes));
  const std::vector<Convention> open = recording::conventions(recording.header(), {});
  ASSERT_THAT(open, SizeIs(2));
  readings(recording, inertia, open);
  EXPECT_EQ(passes, 1);
  EXPECT_THROW(choose_convention(recording, {}, tumbling_problem()), InvalidArgument);
  EXPECT_EQ(passes, 1);
  EXPECT_THAT(recording.first_rows({0}).rows, SizeIs(401));
  EXPECT_EQ(passes, 1);
}

// The order of q0 ... q3 is not asked for if the usual one, scalar first, fits.
TEST(Recording, ReadsNumberedQuaternionsInTheirUsualOrder) {
  std::string text = quaternions();
  text.replace(text.find("q1,q2,q3,q4"), 11, "q0,q1,q2,q3");
  const Recording recording(table::open_table("run.csv", text));
  EXPECT_EQ(choose_convention(recording, {}, tumbling_problem()).columns.at("qw"), "q0");
  text.replace(text.find("q0,q1,q2,q3"), 11, "q3,q0,q1,q2");
  const Recording last(table::open_table("run.csv", text));
  EXPECT_THROW(choose_convention(last, {}, tumbling_problem()), InvalidArgument);
}

// A steady rotation is one in any order, but begins at the identity only in one of them.
TEST(Recording, ReadsASteadyNumberedQuaternionThatBeginsAtTheIdentity) {
  const auto text = [](const char* names, const Eigen::Quaterniond& first) {
    std::string rows = fmt::format("t,{}", names);
    for (int i = 0; i < 100; ++i) {
      const Eigen::Quaterniond q = first * Eigen::Quaterniond(so3::exp(0.05 * i * omega));
      rows +=
          fmt::format("\n{},{:.17g},{:.17g},{:.17g},{:.17g}", 0.05 * i, q.w(), q.x(), q.y(), q.z());
    }
    return rows;
  };
  const auto choice = [](const std::string& rows) {
    return choose_convention(Recording(table::open_table("run.csv", std::string_view(rows))), {},
                             tumbling_problem());
  };
  const Eigen::Quaterniond one(1, 0, 0, 0), other(0.5, 0.5, 0.5, 0.5);
  EXPECT_EQ(choice(text("q0,q1,q2,q3", one)).columns.at("qw"), "q0");
  EXPECT_THROW(choice(text("q3,q0,q1,q2", one)), InvalidArgument);
  EXPECT_THROW(choice(text("q0,q1,q2,q3", other)), InvalidArgument);
}

/// Matrices in the columns Rot[0] ... Rot[8], column by column, below these lines.
std::string columnwise_matrices(const std::string& lines) {
  std::string text = lines + "Frame\tTime";
  for (int i = 0; i < 9; ++i) text += fmt::format("\tRot[{}]", i);
  for (const recording::Row& row : exact_rows()) {
    text +=
        fmt::format("\n{}\t{:.6g}\t{:.6f}", row.number, row.t, fmt::join(row.X.reshaped(), "\t"));
  }
  return text;
}

TEST(Recording, KnowsTheOrderOfQualisys) {
  const std::string text =
      columnwise_matrices("NO_OF_FRAMES\t401\nNO_OF_BODIES\t1\nFREQUENCY\t10\nDATA_INCLUDED\t6D\n");
  const Recording recording(table::open_table("run.tsv", text));
  const Convention convention = choose_convention(recording, {}, tumbling_problem());
  EXPECT_EQ(convention.columns.at("x12"), "Rot[3]");
  EXPECT_TRUE(judge(recording, convention, tumbling_problem()).within_digits);
  const std::string of_others = columnwise_matrices("");
  const Recording other(table::open_table("run.tsv", of_others));
  EXPECT_THROW(choose_convention(other, {}, tumbling_problem()), InvalidArgument);
}

/// The numbers of an attitude under these names, beside the rates of a simulator without a
/// gyroscopic term: they do not change, and the attitude integrates them.
template <typename Numbers>
std::string without_gyroscopic_term(const char* names, const Numbers& numbers) {
  std::string text = fmt::format("t,{},wx,wy,wz", names);
  for (int i = 0; i < 100; ++i) {
    const double t = 0.05 * i;
    text += fmt::format("\n{},{:.17g},{},{},{}", t, fmt::join(numbers(so3::exp(t * omega)), ","),
                        omega[0], omega[1], omega[2]);
  }
  return text;
}

// A wrong law is named in the usual reading, which it explains, too.
TEST(Recording, AsksNothingBecauseOfAWrongLaw) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const auto choice = [](const std::string& text) {
    return choose_convention(Recording(table::open_table("run.csv", std::string_view(text))), {},
                             tumbling_problem());
  };
  const auto quaternion = [](const Eigen::Matrix3d& X) {
    const Eigen::Quaterniond q(X);
    return std::array{q.w(), q.x(), q.y(), q.z()};
  };
  EXPECT_EQ(choice(without_gyroscopic_term("q0,q1,q2,q3", quaternion)).columns.at("qw"), "q0");
  EXPECT_THROW(choice(without_gyroscopic_term("q3,q0,q1,q2", quaternion)), InvalidArgument);
  const auto vector = [](const Eigen::Matrix3d& X) {
    const Eigen::Vector3d v = so3::log(X);
    return std::array{v[0], v[1], v[2]};
  };
  EXPECT_EQ(choice(without_gyroscopic_term("rx,ry,rz", vector)).columns.at("rvx"), "rx");
}

/// Angles about these axes, each as turned by the rotations before, in columns of their names.
std::string euler_angles(const std::array<int, 3>& axes, double unit) {
  constexpr std::array names{"roll", "pitch", "yaw"};
  std::string text = "t,wx,wy,wz";
  for (const int axis : axes) text += std::string(",") + names.at(static_cast<std::size_t>(axis));
  for (const recording::Row& row : exact_rows()) {
    const Eigen::Vector3d angles = row.X.eulerAngles(axes[0], axes[1], axes[2]) / unit;
    text += fmt::format("\n{},{},{},{},{},{},{}", row.t, row.omega[0], row.omega[1], row.omega[2],
                        angles[0], angles[1], angles[2]);
  }
  return text;
}

// Neither the sequence zyx is asked for if it fits, nor degrees if angles exceed a turn in radians.
TEST(Recording, ReadsYawPitchAndRollInTheirUsualSequence) {
  const auto choice = [](const std::string& text) {
    return choose_convention(Recording(table::open_table("run.csv", std::string_view(text))), {},
                             tumbling_problem());
  };
  constexpr double degree = std::numbers::pi / 180;
  EXPECT_EQ(choice(euler_angles({2, 1, 0}, 1)).sequence, "zyx");
  EXPECT_EQ(angle_unit(choice(euler_angles({2, 1, 0}, 1))), recording::Angle::radians);
  EXPECT_EQ(choice(euler_angles({2, 1, 0}, degree)).sequence, "zyx");
  EXPECT_EQ(choice(euler_angles({2, 1, 0}, degree)).angle_unit, recording::Angle::degrees);
  try {
    choice(euler_angles({0, 1, 2}, 1));
    ADD_FAILURE() << "it chose";
  } catch (const InvalidArgument& error) {
    EXPECT_EQ(error.remedy(),
              "these angles fit as turns about x, then y, then z, space from body: add " +
                  argument("sequence", "xyz"));
  }
}

// Attitudes fit with and without the rates beside them; a position beside them is no rate.
TEST(Recording, NamesTheReadingOfColumnsWithoutNamesThatFits) {
  const auto remedy = [](bool has_rates) {
    std::string text;
    for (const recording::Row& row : exact_rows()) {
      const Eigen::Quaterniond q(row.X);
      const Eigen::Vector3d other = has_rates ? row.omega : Eigen::Vector3d(row.t, 2, 3);
      text += fmt::format("{},{},{},{},{},{},{},{}\n", row.t, other[0], other[1], other[2], q.x(),
                          q.y(), q.z(), q.w());
    }
    try {
      choose_convention(Recording(table::open_table("run.csv", std::string_view(text))), {},
                        tumbling_problem());
    } catch (const InvalidArgument& error) {
      return error.remedy();
    }
    return std::string("it chose");
  };
  EXPECT_THAT(remedy(true), testing::HasSubstr(argument(
                                "columns", "t=#1,wx=#2,wy=#3,wz=#4,qw=#8,qx=#5,qy=#6,qz=#7")));
  EXPECT_THAT(remedy(false),
              testing::HasSubstr(argument("columns", "t=#1,qw=#8,qx=#5,qy=#6,qz=#7")));
}

// Without the moments, neither attitudes nor angular momenta determine rates.
TEST(Recording, SaysWhatIsMissingForAFitOfTheMoments) {
  std::string remedy;
  const auto error = [&](const std::string& text) -> std::string {
    try {
      choose_rates(Recording(table::open_table("run.csv", std::string_view(text))), {});
    } catch (const InvalidArgument& error) {
      remedy = error.remedy();
      return error.what();
    }
    return "it chose";
  };
  const std::string moments = "give the moments by " + argument("inertia", "A,B,C");
  const auto line = [](const char* names) { return fmt::format("t,{}\n0,1,0,0,0\n", names); };
  EXPECT_THAT(error(line("qw,qx,qy,qz")), testing::HasSubstr("and it has attitudes alone"));
  EXPECT_EQ(remedy, moments + "; or fit them to the rates that the attitudes give: export with " +
                        argument("motion", "run.csv") + " writes these to a .csv file");
  EXPECT_THAT(error(line("lx,ly,lz,q")), testing::HasSubstr("and it has angular momenta"));
  EXPECT_EQ(remedy, moments + ", or the columns of such rates by " +
                        argument("columns", "wx=NAME,wy=NAME,wz=NAME"));
  EXPECT_EQ(error(line("wx,wy,wz,q")), "it chose");
  const std::string in_space = "t,omega_world_x,omega_world_y,omega_world_z,qw,qx,qy,qz\n";
  EXPECT_THAT(error(in_space + "0,1,0,0,1,0,0,0\n"), testing::HasSubstr("in the axes of space"));
}

// Two units are possible, and only one of them fits.
TEST(Recording, NamesTheOptionOfTheUnitOfTimesThatFits) {
  std::string text = "timestamp,wx,wy,wz\n";
  for (const recording::Row& row : exact_rows()) {
    text += fmt::format("{:.0f},{},{},{}\n", 1e3 * row.t, row.omega[0], row.omega[1], row.omega[2]);
  }
  const Recording recording(table::open_table("run.csv", text));
  try {
    choose_convention(recording, {}, tumbling_problem());
    ADD_FAILURE() << "it chose";
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.remedy(), testing::HasSubstr("add " + argument("time_unit", "ms")));
  }
}

// One for the initial state, one for the errors. A wrong convention is found in the first rows, and
// confirmed in two more: one for the wrong laws, one for all rows in the reading that is proposed.
TEST(Recording, IsJudgedInFewPasses) {
  const std::string text = csv_of(exact_rows(), Parts::both);
  int passes = 0;
  const Recording recording(
      std::make_unique<CountedReader>(table::open_table("run.csv", text), passes));
  Convention convention = own_names(Parts::both);
  judge(recording, convention, tumbling_problem());
  EXPECT_EQ(passes, 2);
  convention.inverse = true;
  const Judgement judgement = judge(recording, convention, tumbling_problem());
  EXPECT_EQ(passes, 5);
  better_readings(recording, tumbling_problem(), judgement);
  EXPECT_EQ(passes, 7);
}

}  // namespace
}  // namespace twrench::check
