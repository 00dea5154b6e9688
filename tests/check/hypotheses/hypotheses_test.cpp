#include "check/hypotheses/hypotheses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <filesystem>

#include "check/recordings.h"
#include "check/report/alternative_text.h"
#include "recording/columns/open_conventions.h"
#include "recording/conventions/units.h"
#include "sanitizers.h"
#include "table/reader.h"

namespace twrench::check {
namespace {

using recording::Recording;
using recording::Row;

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using testing::IsEmpty;
using testing::SizeIs;

/// The numbers in a row of the file: a time, the four numbers of a quaternion, and rates.
struct Written {
  double t;
  Eigen::Vector4d q;
  Vector3d w;
};

Eigen::Vector4d wxyz(const Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

Written as_told(const Row& row) { return {row.t, wxyz(Quaterniond(row.X)), row.omega}; }

/// A file of times, quaternions and rates, as `write` makes them from a row.
class QuaternionFile {
 public:
  template <typename Write>
  explicit QuaternionFile(const Write& write) {
    std::string text = "t,a,b,c,d,wx,wy,wz\n";
    for (const Row& row : exact_rows(41, 0.375)) {
      const Written r = write(row);
      text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", r.t,
                          r.q[0], r.q[1], r.q[2], r.q[3], r.w[0], r.w[1], r.w[2]);
    }
    system::write_file_atomically(path(), text);
  }

  std::filesystem::path path() const { return folder_ / "file.csv"; }

  /// The readings that fit if the file is read as w, x, y, z, space from body, rad/s of the body.
  std::vector<Reading> fitting(bool has_attitude = true,
                               const Problem& problem = tumbling_problem()) const {
    return alternatives(Recording(path()), problem, told(has_attitude)).fitting;
  }

  static recording::Convention told(bool has_attitude = true) {
    recording::Convention told;
    told.columns = {{"t", "t"}, {"wx", "wx"}, {"wy", "wy"}, {"wz", "wz"}};
    if (has_attitude)
      told.columns.merge(
          std::map<std::string, std::string>{{"qw", "a"}, {"qx", "b"}, {"qy", "c"}, {"qz", "d"}});
    return told;
  }

 private:
  ScratchFolder folder_;
};

TEST(Alternatives, AreNoneOfWhatIsRightAsItIs) {
  // The file fits as it is read, so nothing else is proposed.
  EXPECT_THAT(QuaternionFile(as_told).fitting(), IsEmpty());
}

TEST(Alternatives, ScalarLast) {
  const QuaternionFile file([](const Row& row) {
    const Quaterniond q(row.X);
    return Written{row.t, {q.x(), q.y(), q.z(), q.w()}, row.omega};
  });
  const auto fitting = file.fitting();
  ASSERT_THAT(fitting, SizeIs(1));
  EXPECT_EQ(fitting[0].convention.columns.at("qw"), "d");
  EXPECT_EQ(fitting[0].convention.columns.at("qx"), "a");
  EXPECT_FALSE(fitting[0].convention.inverse);
}

TEST(Alternatives, BodyFromSpaceInDegrees) {
  const QuaternionFile file([](const Row& row) {
    return Written{row.t, wxyz(Quaterniond(row.X).conjugate()), in_degrees(1) * row.omega};
  });
  const auto fitting = file.fitting();
  ASSERT_THAT(fitting, SizeIs(1));
  EXPECT_TRUE(fitting[0].convention.inverse);
  EXPECT_EQ(fitting[0].convention.rate_unit, recording::RateUnit::deg_s);
  EXPECT_FALSE(fitting[0].convention.rates_in_space);
}

TEST(Alternatives, OneComponentWithTheWrongSign) {
  const std::array names{"qx", "qy", "qz"};
  for (int wrong = 0; wrong < 3; ++wrong) {
    const QuaternionFile file([&](const Row& row) {
      Eigen::Vector4d q = wxyz(Quaterniond(row.X));
      q[1 + wrong] *= -1;
      return Written{row.t, q, row.omega};
    });
    const auto fitting = file.fitting();
    ASSERT_THAT(fitting, SizeIs(1));
    EXPECT_EQ(fitting[0].convention.negated, names.at(static_cast<std::size_t>(wrong)));
    EXPECT_EQ(fitting[0].convention.columns, QuaternionFile::told().columns);
    EXPECT_FALSE(fitting[0].convention.inverse);
  }
}

TEST(Alternatives, RatesInSpace) {
  const QuaternionFile file([](const Row& row) {
    return Written{row.t, wxyz(Quaterniond(row.X)), row.X * row.omega};
  });
  const auto fitting = file.fitting();
  ASSERT_THAT(fitting, SizeIs(1));
  EXPECT_TRUE(fitting[0].convention.rates_in_space);
  EXPECT_EQ(fitting[0].convention.columns, QuaternionFile::told().columns);
}

// Every unit of times with every unit of rates; the file is read in s and rad/s.
TEST(Alternatives, UnitsOfTimesAndRates) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  for (const recording::TimeUnitName& time : recording::common_units_of_times()) {
    for (const recording::RateUnitName& rate : recording::units_of_rates()) {
      const QuaternionFile file([&](const Row& row) {
        Written written = as_told(row);
        written.t /= time.in_s;
        written.w /= rate.in_rad_s;
        return written;
      });
      if (time.in_s * rate.in_rad_s == 1) continue;
      for (const bool has_attitude : {false, time.unit == recording::TimeUnit::ms}) {
        const auto fitting = file.fitting(has_attitude);
        ASSERT_FALSE(fitting.empty()) << time.option << rate.option;
        // Only the product is determined: revolutions per minute with times in minutes are
        // revolutions per second with times in seconds.
        for (const Reading& reading : fitting) {
          EXPECT_NEAR(name_of(time_unit(reading.convention)).in_s *
                          name_of(rate_unit(reading.convention)).in_rad_s /
                          (time.in_s * rate.in_rad_s),
                      1, 1e-12);
        }
        // With the angular velocity, both are determined.
        Problem problem = tumbling_problem();
        problem.omega = omega;
        const auto told = file.fitting(has_attitude, problem);
        ASSERT_THAT(told, SizeIs(1)) << time.option << rate.option << has_attitude;
        EXPECT_EQ(time_unit(told[0].convention), time.unit);
        EXPECT_EQ(rate_unit(told[0].convention), rate.unit);
      }
    }
  }
}

// For all permutations and signs, axes are found that the physics cannot distinguish from the right
// ones.
TEST(Alternatives, AxesOfTheBody) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  for (const recording::BodyAxes& axes : recording::all_body_axes()) {
    const Matrix3d P = axes.matrix();
    const QuaternionFile file([&](const Row& row) {
      const Matrix3d X = P.determinant() * row.X * P.transpose();
      return Written{row.t, wxyz(Quaterniond(X)), P * row.omega};
    });
    for (const bool has_attitude : {false, true}) {
      const auto fitting = file.fitting(has_attitude);
      const bool is_plain = P.cwiseAbs().isIdentity(0) && P.determinant() > 0;
      ASSERT_THAT(fitting, SizeIs(is_plain ? 0 : 1)) << format_body_axes(axes);
      if (is_plain) continue;
      const Matrix3d found = fitting[0].convention.axes.matrix();
      EXPECT_TRUE((found.transpose() * P).isDiagonal(0)) << format_body_axes(axes);
      EXPECT_EQ(found.determinant(), P.determinant()) << format_body_axes(axes);
    }
  }
}

TEST(Alternatives, TheAttitudeOfAPart) {
  const Quaterniond offset(Eigen::AngleAxisd(0.7, Vector3d(3, -1, 2).normalized()));
  const QuaternionFile file([&](const Row& row) {
    return Written{row.t, wxyz(Quaterniond(row.X) * offset), row.omega};
  });
  const auto fitting = file.fitting();
  ASSERT_THAT(fitting, SizeIs(1));
  ASSERT_TRUE(fitting[0].convention.offset);
  EXPECT_LT(fitting[0].convention.offset->angularDistance(offset), 1e-12);
}

TEST(Alternatives, SayWhatIsNearestWhereNoneFits) {
  const QuaternionFile file([](const Row& row) {
    return Written{row.t, wxyz(Quaterniond(row.X)),
                   Vector3d(std::sin(row.t), std::cos(2 * row.t), 0.3)};
  });
  EXPECT_THAT(file.fitting(), IsEmpty());
}

// A mistake in a moment of inertia is found, from 1 % to a factor of two.
TEST(BetterReadings, FindTheMomentsOfAnotherBody) {
  for (const Vector3d& told :
       {Vector3d(2, 3.03, 4), Vector3d(2, 3.3, 4), Vector3d(2, 2.5, 4), Vector3d(4, 3, 4.1)}) {
    const ScratchFolder folder;
    system::write_file_atomically(folder / "rows.csv", csv_of(exact_rows(), Parts::both));
    const Problem problem{.inertia = told.asDiagonal()};
    for (const Parts parts : {Parts::rates, Parts::both}) {
      if (has_sanitizers && parts == Parts::both) continue;  // the same fit to the same rates
      const recording::Recording recording(folder / "rows.csv");
      const Judgement judgement = judge(recording, own_names(parts), problem);
      const Alternatives found = better_readings(recording, problem, judgement);
      ASSERT_THAT(found.laws.of_rates, SizeIs(1)) << told.transpose();
      EXPECT_EQ(found.laws.of_rates[0].mistake, Mistake::moments);
      const Vector3d moments_found = found.laws.of_rates[0].law.inertia.diagonal();
      EXPECT_TRUE((moments_found / moments_found[0]).isApprox(moments / moments[0], 1e-9))
          << moments_found.transpose();
    }
  }
}

/// The better readings of a file with the rates of these rows.
Alternatives better_readings_of(const std::vector<Row>& rows) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "rows.csv", csv_of(rows, Parts::rates));
  const recording::Recording recording(folder / "rows.csv");
  return better_readings(recording, tumbling_problem(),
                         judge(recording, own_names(Parts::rates), tumbling_problem()));
}

// Rates of another law. The fit of the moments has no minimum there.
TEST(BetterReadings, FindNoBodyWhereThereIsNone) {
  for (const Vector3d& change :
       {Vector3d(0, 0, 0), Vector3d(1e-6, -1e-6, 0), Vector3d(1, 0, 0), Vector3d(0.3, -2, 0.7)}) {
    if (has_sanitizers && change.norm() < 1) continue;  // the same fit to smaller changes
    std::vector<Row> rows = exact_rows(256, 0.05);
    for (Row& row : rows) row.omega = omega + std::sin(row.t) * change;
    const Alternatives found = better_readings_of(rows);
    // Rates that do not change lack the gyroscopic term.
    for (const Explanation& one : found.laws.of_rates)
      EXPECT_EQ(one.mistake, Mistake::gyroscopic_factor);
    EXPECT_THAT(found.fitting, IsEmpty());
  }
}

TEST(BetterReadings, BlameNoBodyForErrors) {
  std::vector<Row> rows;
  Vector3d w = omega;
  constexpr double step = 1.0 / 60;
  for (std::size_t i = 0; i < 1024; ++i) {
    rows.push_back({.number = i + 1, .t = static_cast<double>(i) * step, .omega = w});
    w += step * (inertia.inverse() * (inertia * w).cross(w));
  }
  const Alternatives found = better_readings_of(rows);
  EXPECT_THAT(found.laws.of_rates, IsEmpty());
  EXPECT_THAT(found.fitting, IsEmpty());
}

// Whether the error as read is as small as that of a method, or already larger.
TEST(BetterReadings, FindTheOrderOfNearlyEqualMoments) {
  const Vector3d right(3, 2, 2.0001);
  const Problem problem{.inertia = Vector3d(3, right[2], right[1]).asDiagonal()};
  const motion::ExactMotion exact({right.asDiagonal(), omega});
  for (const std::size_t count : {50, 500}) {
    const auto rows = rows_of([&](double t) { return exact.at(t); }, count, 0.1);
    for (const Parts parts : {Parts::rates, Parts::both}) {
      const ScratchFolder folder;
      system::write_file_atomically(folder / "rows.csv", csv_of(rows, parts));
      const Recording recording(folder / "rows.csv");
      const Judgement judgement = judge(recording, own_names(parts), problem);
      EXPECT_EQ(judgement.misfit.worst().has_value(), count == 500);
      const Alternatives found = better_readings(recording, problem, judgement);
      ASSERT_THAT(found.fitting, SizeIs(1));
      const Matrix3d axes = found.fitting[0].convention.axes.matrix();
      EXPECT_TRUE(
          (axes * problem.inertia * axes.transpose()).isApprox(Matrix3d(right.asDiagonal())));
      EXPECT_TRUE(found.laws.empty());
    }
  }
}

/// A file of rates in rad/s at times in s, which its names call otherwise.
Alternatives alternatives_of_named(const std::string& names) {
  const ScratchFolder folder;
  std::string text = names + "\n";
  for (const Row& row : exact_rows(41, 0.375)) {
    text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}\n", row.t, row.omega[0], row.omega[1],
                        row.omega[2]);
  }
  system::write_file_atomically(folder / "file.csv", text);
  const Recording recording(folder / "file.csv");
  const auto open = recording::conventions(recording.header(), {});
  EXPECT_THAT(open, SizeIs(1));
  const Judgement judgement = judge(recording, open.front(), tumbling_problem());
  Alternatives found = better_readings(recording, tumbling_problem(), judgement);
  for (const Reading& reading : found.fitting) {
    const bool is_contradicted = contradicts_file(open.front(), reading.convention);
    EXPECT_EQ(changing_arguments(open.front(), reading.convention).empty(), is_contradicted);
    EXPECT_EQ(alternative_text(judgement, reading.convention).ends_with("that the file states"),
              is_contradicted);
  }
  return found;
}

// No option may contradict the file. Without this reading, a multiple of the gyroscopic term fits.
TEST(BetterReadings, FindWrongUnitsInTheFile) {
  for (const char* names : {"t,p_deg_s,q_deg_s,r_deg_s", "t,wx (rpm),wy (rpm),wz (rpm)",
                            "t_ms,wx,wy,wz", "t_ms,p_deg_s,q_deg_s,r_deg_s"}) {
    const Alternatives found = alternatives_of_named(names);
    ASSERT_THAT(found.fitting, SizeIs(1)) << names;
    EXPECT_EQ(rate_unit(found.fitting[0].convention), recording::RateUnit::rad_s) << names;
    EXPECT_EQ(time_unit(found.fitting[0].convention), recording::TimeUnit::s) << names;
    EXPECT_TRUE(found.laws.empty()) << names;
  }
}

}  // namespace
}  // namespace twrench::check
