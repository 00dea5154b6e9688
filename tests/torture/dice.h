#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace twrench::torture {

/// Random numbers that are the same with every standard library, unlike those of the standard
/// distributions.
class Dice {
 public:
  /// The numbers of case `number`, independent of earlier cases.
  Dice(std::uint32_t seed, std::uint32_t number) {
    std::seed_seq sequence{seed, number};
    engine_.seed(sequence);
  }

  /// 0 to n - 1; n is at least 1.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  bool chance(double share) { return static_cast<double>(engine_() >> 11U) * 0x1p-53 < share; }

  template <typename T>
  const T& one_of(const std::vector<T>& values) {
    return values[below(values.size())];
  }

  template <typename T>
  void shuffle(std::vector<T>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace twrench::torture
