#pragma once

#include <array>
#include <complex>
#include <cstddef>

/// Jacobi's elliptic functions and one theta function, for the exact motion
/// (docs/exact.md, whose equations are (E1), (E2) ...).
/// Everything takes the parameter m = k^2 and its complement mc = 1 - k^2 side by side, never the
/// modulus k: as m rounds to 1, all that is known of the motion stands in mc.
namespace twrench::elliptic {

/// Complete integral of the first kind, K; infinite at mc = 0. Relative error below 4 eps.
/// mc in [0, 1].
double complete_first(double mc);

/// Incomplete integral F of the amplitude with sine `s` in [-1, 1] and cosine `c` in [0, 1], by
/// Carlson's symmetric form: DLMF 19.25.5. Infinite where c = mc = 0.
double incomplete_first(double s, double c, double mc);

/// sn, cn, dn of a real argument u, and the argument of Theta(u + i a), where
/// Theta(u) = theta_4(pi u / 2K, q^2) and a = K' - a'. That argument is the elementary part of an
/// elliptic integral of the third kind; of its real period, 2K, it keeps no memory.
class Jacobi {
 public:
  /// mc = 1 - m, both in [0, 1]; `a_prime` in (0, K'].
  Jacobi(double m, double mc, double a_prime);

  struct Values {
    double sn, cn, dn;
    std::complex<double> theta;  ///< arg Theta(u + i a) = arg(theta) + angle; |theta| >= 0.4
    double angle;                ///< rad, between -pi/4 and pi/4
  };
  /// Absolute error a few eps, on top of the eps |u| that u itself brings.
  Values at(double u) const { return hyperbolic_ ? hyperbolic(u) : circular(u); }

  /// K; infinite at mc = 0.
  double quarter_period() const { return K_; }

  /// d/du arg Theta(u + i a) at u = 0.
  double slope() const { return slope_; }

 private:
  static constexpr std::size_t terms = 5;  ///< n = 0 ... 4; of the hyperbolic series one fewer
  using Series = std::array<double, terms>;

  void expand_in_nome(double Kc, double a_prime);
  void expand_in_complementary_nome(double Kc, double a_prime);
  Values circular(double u) const;
  Values hyperbolic(double u) const;

  double K_;
  bool hyperbolic_;  ///< the series are in q' = exp(-pi K/K'), else in q = exp(-pi K'/K)
  double turns_per_unit_ = 0, root_ = 0;  ///< 1/2K and sqrt q', where hyperbolic
  double scale_ = 0;                      ///< of u in the series: pi/2K' or pi/2K
  double drift_ = 0;                      ///< d angle / du
  double slope_ = 0;
  double sn_scale_ = 0, cn_scale_ = 0, dn_scale_ = 0;
  Series even_{};    ///< of theta_3 and theta_4
  Series odd_{};     ///< of theta_1 and theta_2
  Series cosine_{};  ///< of the real part of Theta(u + i a)
  Series sine_{};    ///< of its imaginary part
};

}  // namespace twrench::elliptic
