// exact_samples COUNT: prints the seconds that it takes to evaluate the default motion at COUNT
// times into newly allocated arrays, as bench/python.py does from Python.
#include <twrench/motion/exact.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>

using namespace twrench;

int main(int argc, char** argv) {
  const auto count = static_cast<std::size_t>(argc > 1 ? std::atoll(argv[1]) : 1'000'000);
  const Eigen::Vector3d moments(982.271303, 722.671030, 1578.650308);  // of the T-wrench
  const motion::ExactMotion motion(motion::FreeBody(moments.asDiagonal(), {1, 0.05, 0}));
  std::vector<double> times(count);
  for (std::size_t i = 0; i < count; ++i) {
    times[i] = 96.0 * static_cast<double>(i) / static_cast<double>(count - 1);
  }
  const auto start = std::chrono::steady_clock::now();
  // Not initialised, like NumPy's arrays.
  const std::unique_ptr<double[]> X(new double[9 * count]), omega(new double[3 * count]);
  motion.at(times, {X.get(), 9 * count}, {omega.get(), 3 * count});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%.6f\n", seconds.count());
}
