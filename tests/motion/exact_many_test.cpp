#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/motion/exact_many.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "motion/bodies_of_every_kind.h"

namespace twrench::motion {
namespace {

using Eigen::Vector3d;
using Numbers = std::vector<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Arrays for exact_many().
struct Many {
  Numbers inertia, omega, times;

  explicit Many(const std::vector<BodyOfAKind>& bodies, Numbers at) : times(std::move(at)) {
    for (const BodyOfAKind& b : bodies) {
      inertia.insert(inertia.end(), b.moments.begin(), b.moments.end());
      omega.insert(omega.end(), b.omega.begin(), b.omega.end());
    }
  }

  std::size_t size() const { return omega.size() / 3; }

  struct Result {
    Numbers X, velocities;
    bool operator==(const Result&) const = default;
  };
  Result operator()(unsigned threads = all_processors) const {
    const std::size_t samples = size() * times.size();
    Result result{Numbers(9 * samples), Numbers(3 * samples)};
    exact_many({inertia, omega}, times, {result.X, result.velocities}, threads);
    return result;
  }

  ExactMotion alone(std::size_t i) const {
    const Vector3d moments(&inertia[inertia.size() == 3 ? 0 : 3 * i]);
    return ExactMotion(FreeBody(moments.asDiagonal(), Vector3d(&omega[3 * i])));
  }
  Result one_by_one() const {
    Result result;
    for (std::size_t i = 0; i < size(); ++i) {
      const ExactMotion motion = alone(i);
      for (const double t : times) {
        const Sample sample = motion.at(t);
        for (int k = 0; k < 9; ++k) result.X.push_back(sample.X(k / 3, k % 3));
        for (const double component : sample.omega) result.velocities.push_back(component);
      }
    }
    return result;
  }
};

TEST(ExactMany, HasTheBitsOfEachBodyAlone) {
  const Many many(bodies_of_every_kind(), {0, -3, 0.1, 1e6, -1e9, 40, 7});
  EXPECT_TRUE(many() == many.one_by_one());
}

TEST(ExactMany, TakesOneInertiaForAll) {
  Many many(bodies_of_every_kind(), {0.5, 12});
  many.inertia = {1, 2, 3};
  EXPECT_TRUE(many() == many.one_by_one());
}

TEST(ExactMany, DividesManyTimesOfFewBodies) {
  Numbers times;
  for (int i = 0; i < 40'000; ++i) times.push_back(0.01 * i);
  const Many many({{{1, 2, 3}, {0.01, 1, 0.02}}, {{3, 1, 2}, {1, 0.5, 0.2}}}, times);
  EXPECT_TRUE(many() == many.one_by_one());
}

TEST(ExactMany, DoesNotDependOnTheNumberOfThreads) {
  std::vector<BodyOfAKind> bodies;
  for (int i = 0; i < 20; ++i) {
    for (const BodyOfAKind& b : bodies_of_every_kind()) bodies.push_back(b);
  }
  const Many many(bodies, {1, 2, 3});
  const Many::Result one = many(1);
  for (const unsigned threads : {2U, 5U, all_processors}) EXPECT_TRUE(many(threads) == one);
}

TEST(ExactMany, OfNothingIsNothing) {
  EXPECT_TRUE(Many({}, {1, 2})().X.empty());
  EXPECT_TRUE(Many({{{1, 2, 3}, {1, 1, 1}}}, {})().X.empty());
}

TEST(FirstFlipTimes, AreThoseOfEachBodyAlone) {
  Many many(bodies_of_every_kind(), {});
  for (const bool alike : {false, true}) {
    if (alike) many.inertia = {3, 5, 9};
    Numbers first(many.size());
    first_flip_times({many.inertia, many.omega}, first);
    for (std::size_t i = 0; i < many.size(); ++i) {
      const auto flips = many.alone(i).flips();
      EXPECT_EQ(first[i], flips ? flips->first : infinity) << i;
    }
  }
}

TEST(FirstFlipTimes, DoNotDependOnTheNumberOfThreads) {
  RandomBodies random;
  Numbers omega;
  for (int i = 0; i < 3000; ++i) omega.push_back(random.between(-1, 1));
  const Numbers inertia{1, 2, 3};
  Numbers one(1000), several(1000);
  first_flip_times({inertia, omega}, one, 1);
  first_flip_times({inertia, omega}, several, 4);
  EXPECT_EQ(one, several);
}

TEST(ExactMany, LeavesOutWhatIsNotWanted) {
  const Many many(bodies_of_every_kind(), {0, 1, -3.5});
  const Many::Result both = many();
  Numbers X(both.X.size()), velocities(both.velocities.size());
  exact_many({many.inertia, many.omega}, many.times, {.X = X, .omega = {}});
  exact_many({many.inertia, many.omega}, many.times, {.X = {}, .omega = velocities});
  EXPECT_EQ(X, both.X);
  EXPECT_EQ(velocities, both.velocities);
}

struct Mistake {
  Numbers inertia, omega, times;
  std::size_t X_size, velocities_size;
  std::string message;
};

TEST(ExactMany, NamesWhatIsWrongAndWhere) {
  const Numbers good{1, 2, 3, 1, 2, 3}, spin{1, 1, 1, 0, 1, 0}, t{0, 1};
  const double nan = std::nan("");
  for (const Mistake& m : std::vector<Mistake>{
           {{1, 2, 3, 1, -2, 3}, spin, t, 36, 12, "inertia[1, 1]: is -2, but must be positive"},
           {{1, 2, 3, 1, 2, nan}, spin, t, 36, 12, "inertia[1, 2]: is nan, but must be positive"},
           {{1, 0, 3}, spin, t, 36, 12, "inertia[0, 1]: is 0, but must be positive"},
           {good, {1, 1, 1, infinity, 1, 0}, t, 36, 12, "omega[1, 0]: is inf, but must be finite"},
           {good, spin, {0, nan}, 36, 12, "times[1]: is nan, but must be finite"},
           {good, {1, 1, 1, 0}, t, 36, 12, "omega: has 4 numbers, but must have three for each"},
           {{1, 2}, spin, t, 36, 12, "inertia: has 2 numbers, but must have 6"},
           {good, spin, t, 35, 12, "samples.X: has 35 numbers, but must have 36"},
           {good, spin, t, 36, 11, "samples.omega: has 11 numbers, but must have 12"},
           {{1, 2, 3, 1e-320, 2, 3}, spin, t, 36, 12, "inertia[1]: its inverse exceeds"},
           {good,
            {1, 1, 1, 1e308, 1e308, 1e308},
            t,
            36,
            12,
            "omega[1]: the angular momentum exceeds"}}) {
    Numbers X(m.X_size), velocities(m.velocities_size);
    try {
      exact_many({m.inertia, m.omega}, m.times, {X, velocities});
      ADD_FAILURE() << "nothing was thrown: " << m.message;
    } catch (const InvalidArgument& refused) {
      EXPECT_THAT(refused.what(), testing::HasSubstr(m.message));
    }
  }
  Numbers one(1);
  EXPECT_THROW(first_flip_times({good, spin}, one), InvalidArgument);
}

}  // namespace
}  // namespace twrench::motion
