// A program that links the installed library. scripts/maintain/library.sh compiles it with other
// flags than the library's; the results must be the same.
#include <twrench/base/error.h>
#include <twrench/math/so3.h>
#include <twrench/study/flip_search.h>

#include <Eigen/Dense>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>

#include "layout.h"

namespace {

using namespace twrench;
using Eigen::Matrix3d;
using Eigen::Vector3d;

int failures = 0;

void expect(bool is_true, const char* what) {
  if (is_true) return;
  ++failures;
  std::fprintf(stderr, "wrong: %s\n", what);
}

/// Returns whether x is finite and at most `bound`. The bits are compared, because -ffast-math
/// assumes that no number is a NaN.
bool is_within(double x, double bound) {
  const auto magnitude = std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63U);
  return magnitude <= std::bit_cast<std::uint64_t>(bound);
}

constexpr double tolerance = 1e-13;

struct Known {
  double t;
  std::array<double, 3> omega;
  std::array<double, 9> X;  ///< row-major
};

// From tests/reference/trajectories.json, rounded to 17 digits: the cases wrench-a and wrench-c.
constexpr std::array moments{982.2713030224086858926532, 722.6710300807721046210234,
                             1578.650308428871102327478};
constexpr std::array<double, 3> omega_a{1, 0.05, 0}, omega_c{0.05, 0, 1};
constexpr std::array<Known, 5> wrench_a{
    {{1,
      {0.99981262853383224, 0.053430779986301989, 0.0084089173971970878},
      {0.99882264109246699, 0.019430236676038552, 0.044449944249482044, 0.026912279959443813,
       0.5404149910570305, -0.84096811272973615, -0.040361625691409588, 0.84117424077508629,
       0.53925581668444134}},
     {5,
      {0.98758063437974641, 0.16086083633881773, 0.068250492581646394},
      {0.99135716764185899, 0.10790226437837433, 0.074619484768594271, -0.10266304013509971,
       0.28395128736423714, 0.95332678898393042, 0.081677820461432307, -0.95274800852387609,
       0.29257471848821492}},
     {10,
      {0.58483273127089752, 0.7909476125893764, 0.35236841665207402},
      {0.57769338217214072, 0.60945296515048308, 0.54298935483469379, 0.19407939297591303,
       -0.74870116977900303, 0.63386098443874395, 0.79284522160167814, -0.26079425154868069,
       -0.55080197252964647}},
     {20,
      {-0.99585399196743085, 0.10166739669795589, 0.039516016542748778},
      {-0.99604047179389421, 0.041306572815763498, 0.078721951136977011, 0.0050693545058006252,
       0.9104508088704012, -0.41358629845792355, -0.088756296641371246, -0.41154962236581888,
       -0.90705525087342986}},
     {50,
      {0.99813526907728367, 0.077643459775560905, 0.026516380030540954},
      {0.99434526295474168, 0.092393749499726147, 0.052353539449089763, 0.10302929265162639,
       -0.95880554817065777, -0.26472039145647619, 0.025738354554459563, 0.26861741538952072,
       -0.96290301757460628}}}};
constexpr std::array<Known, 5> wrench_c{
    {{1,
      {0.033071864962225875, 0.036492741490082699, 1.0001326757897191},
      {0.54005685310050644, -0.8409398083326205, 0.03404165361250034, 0.84162006578052229,
       0.53942799474335856, -0.026326856302044368, 0.0037762805467025651, 0.042868137919141611,
       0.99907360212177465}},
     {5,
      {-0.022725869424890695, -0.043340595238913607, 1.0001871356880956},
      {0.28664684276895186, 0.95650579815460124, 0.054131743249419863, -0.9577587878732895,
       0.28746593675660681, -0.007838332484260779, -0.023058442750521602, -0.049598319540845821,
       0.99850303700922471}},
     {10,
      {-0.029347527724747004, 0.039393781958008467, 1.000154607049299},
      {-0.83475036116287027, 0.55059656424007908, 0.0059378435040187737, -0.55057460966771166,
       -0.83477099036973168, 0.0049992825869639409, 0.0077093273185578287, 0.00090392707553030424,
       0.99996987414028504}},
     {20,
      {-0.015555886552730781, -0.046242180650518785, 1.0002130285764188},
      {0.39341998414152413, -0.9192289146924153, 0.015456987788285591, 0.91909753326784094,
       0.3936534053997357, 0.017225584406962476, -0.021918951139435459, 0.0074295902037487651,
       0.9997321445118944}},
     {50,
      {-0.00027187800056017265, -0.048656239087097396, 1.000235848637739},
      {0.97395809568061986, 0.22381105614428817, 0.036252434480442533, -0.22467131915839378,
       0.97419393514188446, 0.021655832479889312, -0.030470087065967839, -0.029236755639915776,
       0.99910799512056958}}}};

motion::FreeBody body_of(const std::array<double, 3>& omega) {
  const Vector3d I(moments[0], moments[1], moments[2]);
  return {I.asDiagonal(), Vector3d(omega[0], omega[1], omega[2])};
}

void expect_known(const motion::Sample& sample, const Known& known, const char* what) {
  bool is_near = true;
  for (int i = 0; i < 9; ++i) {
    is_near &= is_within(sample.X(i / 3, i % 3) - known.X[std::size_t(i)], tolerance);
  }
  for (int i = 0; i < 3; ++i) {
    is_near &= is_within(sample.omega[i] - known.omega[std::size_t(i)], tolerance);
  }
  expect(is_near, what);
}

/// Evaluates the motion at the times of `known` one by one, together and as arrays.
void expect_motion(const motion::ExactMotion& motion, const std::array<Known, 5>& known,
                   const char* what) {
  std::vector<double> times;
  for (const Known& k : known) {
    times.push_back(k.t);
    expect_known(motion.at(k.t), k, what);
  }
  const std::vector<motion::Sample> samples = motion.at(times);
  std::vector<double> X(9 * times.size()), omega(3 * times.size());
  motion.at(times, X, omega);
  for (std::size_t i = 0; i < known.size(); ++i) {
    expect_known(samples[i], known[i], what);
    const motion::Sample sample{times[i],
                                Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&X[9 * i]),
                                Eigen::Map<Vector3d>(&omega[3 * i])};
    expect_known(sample, known[i], what);
  }
}

void test_copies() {
  const motion::FreeBody a = body_of(omega_a), c = body_of(omega_c);
  motion::ExactMotion motion(a);
  expect_motion(motion, wrench_a, "a motion");
  motion = motion::ExactMotion(c);
  expect_motion(motion, wrench_c, "a motion after an assignment");
  std::vector<motion::ExactMotion> motions;
  for (int i = 0; i < 5; ++i) motions.emplace_back(i % 2 == 0 ? a : c);
  motions.insert(motions.begin(), motion::ExactMotion(c));
  const std::vector<motion::ExactMotion> copies = motions;
  for (std::size_t i = 0; i < copies.size(); ++i) {
    expect_motion(copies[i], i % 2 == 0 ? wrench_c : wrench_a, "a motion in a vector");
  }
}

void test_conservation() {
  for (const auto& omega : {omega_a, omega_c}) {
    const motion::FreeBody body = body_of(omega);
    const motion::ExactMotion motion(body);
    for (double t = -30; t <= 30; t += 0.37) {
      const motion::Sample sample = motion.at(t);
      const Vector3d change = sample.X * body.inertia() * sample.omega - body.momentum();
      expect(is_within(change.norm() / body.momentum().norm(), tolerance), "the momentum");
    }
  }
}

void test_methods() {
  const motion::FreeBody body = body_of(omega_a);
  const motion::ExactMotion exact(body);
  for (const char* name : {"taylor", "rkmk45"}) {
    const motion::Method& method = motion::find_method(name);
    study::FlipSearch search(body, method);
    motion::visit_steps(body, method, {.tolerance = 1e-12}, 30,
                        [&](const motion::AcceptedStep& step) { search.visit(step); });
    expect(search.times().size() == 1, "the number of flips");
    for (const double t : search.times()) {
      expect(is_within(t - exact.flips()->first, 1e-8), "the time of a flip");
    }
  }
}

/// Calls functions of Eigen that the library also calls. Without optimisation, the linker uses the
/// copies of this program for both.
void test_shared_functions() {
  const Vector3d u(0.3, -1.2, 0.7);
  const Matrix3d R = so3::exp(u);
  expect(R.isUnitary(1e-12) && !R.isDiagonal(0.0), "exp");
  expect(is_within((so3::log(R) - u).norm(), tolerance), "log");
  const Eigen::Quaternion<double, Eigen::DontAlign> unaligned(R);
  const Eigen::Quaterniond q = Eigen::Quaterniond(R).normalized() * Eigen::Quaterniond::Identity();
  expect(is_within((q.toRotationMatrix() - R).norm(), tolerance), "a quaternion");
  expect(is_within((unaligned.coeffs() - q.coeffs()).norm(), tolerance), "a quaternion");
  const Eigen::Matrix4d product =
      Eigen::Matrix4d::Identity() * (q.coeffs() * q.coeffs().transpose());
  expect(is_within(product.trace() - 1, tolerance), "a product");
  expect(is_within(u.stableNorm() - u.norm(), tolerance), "a norm");
  const Matrix3d inertia = R * Vector3d(3, 1, 2).asDiagonal() * R.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(inertia);
  const body::PrincipalAxes principal = body::principal_axes(inertia);
  expect(is_within((principal.moments - solver.eigenvalues()).norm(), tolerance), "the moments");
  expect(is_within((principal.moments - Vector3d(1, 2, 3)).norm(), tolerance), "the moments");
  expect(is_within((inertia.inverse() * inertia - Matrix3d::Identity()).norm(), tolerance),
         "an inverse");
}

template <class Function>
void expect_refused(const Function& function, const char* what) {
  try {
    function();
  } catch (const InvalidArgument&) {
    return;
  }
  expect(false, what);
}

/// The library detects a NaN even if the program is compiled with the assumption that there are
/// none.
void test_errors() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Matrix3d identity = Matrix3d::Identity();
  Matrix3d X = identity;
  X(1, 2) = nan;
  expect_refused([&] { motion::FreeBody(X, Vector3d(1, 0, 0)); }, "an inertia that is NaN");
  expect_refused([&] { motion::FreeBody(identity, Vector3d(nan, 0, 0)); }, "a rate that is NaN");
  expect_refused([&] { motion::ExactMotion(body_of(omega_a)).at(nan); }, "a time that is NaN");
  const std::array parts{body::Part{body::Box{{1, 2, 3}}, 1, Vector3d::Zero(), X}};
  expect_refused([&] { body::mass_properties(parts); }, "a rotation that is NaN");
}

}  // namespace

int main() {
  test_copies();
  test_conservation();
  test_methods();
  test_shared_functions();
  test_errors();
  if (failures == 0) std::puts("all results are right");
  return failures == 0 ? 0 : 1;
}
