#pragma once

#include <array>
#include <complex>
#include <cstddef>

/// Jacobi's elliptic functions and one theta function, as the exact motion needs them
/// (docs/exact.md, which numbers its equations (E1), (E2) and so on). All functions take the
/// parameter m = k^2 and its complement mc = 1 - k^2 separately, never the modulus k: close to the
/// separatrix m rounds to 1, and mc holds all the information.
namespace twrench::elliptic {

/// Returns the complete elliptic integral of the first kind, K, for mc in [0, 1]; infinite at mc =
/// 0. The relative error is below 4 eps.
double complete_first(double mc);

/// Returns the incomplete elliptic integral of the first kind, F, of the amplitude with sine `s` in
/// [-1, 1] and cosine `c` in [0, 1], computed with Carlson's symmetric form (DLMF 19.25.5).
/// Infinite where c = mc = 0.
double incomplete_first(double s, double c, double mc);

/// Evaluates sn, cn and dn of a real argument u, and the argument of Theta(u + i a), where Theta(u)
/// = theta_4(pi u / 2K, q^2) and a = K' - a'. This argument is the elementary part of an elliptic
/// integral of the third kind; its real period is 2K, so whole periods do not add to it.
class Jacobi {
 public:
  /// Prepares the series for the parameters m and mc = 1 - m, both in [0, 1], and for `a_prime` in
  /// (0, K'].
  Jacobi(double m, double mc, double a_prime);

  struct Values {
    /// Jacobi's functions of u.
    double sn, cn, dn;
    /// The complex number with arg Theta(u + i a) = arg(theta) + angle; |theta| >= 0.4.
    std::complex<double> theta;
    /// The remaining part of the argument, in rad, between -pi/4 and pi/4.
    double angle;
  };
  /// Evaluates all functions at u. The absolute error is a few eps, in addition to the eps |u|
  /// inherent in u.
  Values at(double u) const { return hyperbolic_ ? hyperbolic(u) : circular(u); }

  /// Returns K; infinite at mc = 0.
  double quarter_period() const { return K_; }

  /// Returns d/du arg Theta(u + i a) at u = 0.
  double slope() const { return slope_; }

 private:
  /// Terms n = 0 to 4; the hyperbolic series have one fewer.
  static constexpr std::size_t terms = 5;
  using Series = std::array<double, terms>;

  void expand_in_nome(double Kc, double a_prime);
  void expand_in_complementary_nome(double Kc, double a_prime);
  Values circular(double u) const;
  Values hyperbolic(double u) const;

  double K_;
  /// Whether the series are in q' = exp(-pi K/K') rather than q = exp(-pi K'/K).
  bool hyperbolic_;
  /// 1/2K and sqrt q', if hyperbolic.
  double turns_per_unit_ = 0, root_ = 0;
  /// Scale of u in the series: pi/2K' or pi/2K.
  double scale_ = 0;
  /// d angle / du.
  double drift_ = 0;
  double slope_ = 0;
  double sn_scale_ = 0, cn_scale_ = 0, dn_scale_ = 0;
  /// Of theta_3 and theta_4.
  Series even_{};
  /// Of theta_1 and theta_2.
  Series odd_{};
  /// Of the real part of Theta(u + i a).
  Series cosine_{};
  /// Of its imaginary part.
  Series sine_{};
};

}  // namespace twrench::elliptic
