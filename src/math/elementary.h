#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

/// Sine, cosine and exponential function without branches, tables or calls, so that the compiler
/// can vectorise a loop over them. They consist of IEEE operations in a fixed order, so a value has
/// the same bits on every processor and at any vector width. The polynomials are those of fdlibm
/// 5.3 (Sun Microsystems, 1993: k_sin.c, k_cos.c, e_exp.c), whose errors are below 2^-58.
namespace twrench::elementary {

/// An integer and its bits in two's complement. Only the low 51 bits are meaningful.
struct Integer {
  double value;
  std::uint64_t bits;
};
/// Returns the integer nearest to `x`; 0 if |x| >= 2^51.
[[gnu::always_inline]] inline Integer nearest_integer(double x) {
  constexpr double last_digit_is_one = 0x1.8p52;
  const double shifted = (std::abs(x) < 0x1p51 ? x : 0) + last_digit_is_one;
  return {shifted - last_digit_is_one, std::bit_cast<std::uint64_t>(shifted)};
}

/// Returns `x`, negated if the integer with these bits is odd.
[[gnu::always_inline]] inline double negated_if_odd(double x, std::uint64_t bits) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (bits << 63U));
}

/// The sine and the cosine of one angle.
struct SineCosine {
  double sin;
  double cos;
};
/// Returns the sine and cosine of the angle of `w` quarter turns, pi w/2. Whole quarter turns are
/// subtracted exactly, so that the error is that of two roundings at any w. From |w| = 2^51 on,
/// where w has no fraction digits, returns those of the angle 0.
[[gnu::always_inline]] inline SineCosine sincos_quarter_turns(double w) {
  const auto [whole, bits] = nearest_integer(w);
  const double x = (std::abs(w) < 0x1p51 ? w - whole : 0) * (std::numbers::pi / 2), z = x * x;
  const double s =
      x + x * z *
              (-1.66666666666666324348e-01 +
               z * (8.33333333332248946124e-03 +
                    z * (-1.98412698298579493134e-04 +
                         z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 +
                                                                z * 1.58969099521155010221e-10)))));
  const double c =
      1 -
      (0.5 * z -
       z * z *
           (4.16666666666666019037e-02 +
            z * (-1.38888888888741095749e-03 +
                 z * (2.48015872894767294178e-05 +
                      z * (-2.75573143513906633035e-07 +
                           z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11))))));
  // After an odd number of quarter turns, sine and cosine are swapped by exchanging all bits that
  // differ.
  const auto sine = std::bit_cast<std::uint64_t>(s), cosine = std::bit_cast<std::uint64_t>(c);
  const std::uint64_t exchanged = (sine ^ cosine) & (0 - (bits & 1U));
  return {negated_if_odd(std::bit_cast<double>(sine ^ exchanged), bits >> 1U),
          negated_if_odd(std::bit_cast<double>(cosine ^ exchanged), (bits + 1) >> 1U)};
}

/// Returns exp(-x) for x >= 0; the constant 2e-300 for x above 690.
[[gnu::always_inline]] inline double exp_minus(double x) {
  const double a = x < 690 ? -x : -690;
  const auto [power, bits] = nearest_integer(a * std::numbers::log2e);
  const double high = a - power * 6.93147180369123816490e-01;
  const double low = power * 1.90821492927058770002e-10;
  const double f = high - low, z = f * f;
  const double c =
      f - z * (1.66666666666666019037e-01 +
               z * (-2.77777777770155933842e-03 +
                    z * (6.61375632143793436117e-05 +
                         z * (-1.65339022054652515390e-06 + z * 4.13813679705723846039e-08))));
  const double y = 1 - ((low - f * c / (2 - c)) - high);
  return y * std::bit_cast<double>((bits + 1023) << 52U);
}

}  // namespace twrench::elementary
