#pragma once

#include <array>

/// Jacobi's elliptic functions and one theta function, as needed for the exact motion. The
/// equations (E1), (E2) and so on are those of docs/exact.md. All functions take the parameter m =
/// k^2 and its complement mc = 1 - k^2 separately, never the modulus k: close to the separatrix m
/// rounds to 1, and mc holds all the information.
namespace twrench::elliptic {

/// Returns the complete elliptic integral of the first kind, K, for mc in [0, 1]; infinite at mc =
/// 0. The relative error is below 4 eps.
double complete_first(double mc);

/// Returns the incomplete elliptic integral of the first kind, F, of the amplitude with sine `s` in
/// [-1, 1] and cosine `c` in [0, 1], computed with Carlson's symmetric form (DLMF 19.25.5).
/// Infinite if c = mc = 0.
double incomplete_first(double s, double c, double mc);

/// Evaluates sn, cn and dn of a real argument u, and the argument of Theta(u + i eta), where
/// Theta(u) = theta_4(pi u / 2K, q^2) and eta = K' - eta'. This argument is the elementary part of
/// an elliptic integral of the third kind; its real period is 2K, so whole periods do not add to
/// it.
class Jacobi {
 public:
  /// Prepares the series for the parameters m and mc = 1 - m, both in [0, 1], and for `eta_prime`
  /// in (0, K'].
  Jacobi(double m, double mc, double eta_prime);

  /// The values at one u. The number theta = re + i im, with |theta| >= 0.4, and the angle give
  /// arg Theta(u + i eta) = arg(theta) + angle.
  struct Values {
    double sn;  ///< Jacobi's sn u.
    double cn;  ///< Jacobi's cn u.
    double dn;  ///< Jacobi's dn u.
    double re;  ///< Real part of theta.
    double im;  ///< Imaginary part of theta.
    /// The remaining part of the argument, in rad, between -pi/4 and pi/4.
    double angle;
  };
  /// Evaluates all functions at u. The absolute error is a few eps, in addition to the error eps
  /// |u| inherent in u.
  Values at(double u) const;

  /// Returns K; infinite at mc = 0.
  double quarter_period() const { return K_; }

  /// Returns d/du arg Theta(u + i eta) at u = 0.
  double slope() const { return slope_; }

 private:
  /// Evaluates the series; it is private to the library and compiled with its flags.
  friend struct JacobiSeries;

  void expand_in_nome(double Kc, double eta_prime);
  void expand_in_complementary_nome(double Kc, double eta_prime);

  double K_;
  bool hyperbolic_;
  double slope_ = 0;
  double sn_scale_ = 0, cn_scale_ = 0, dn_scale_ = 0;

  // The series as polynomials, lowest power first. Those of theta functions are split into even and
  // odd powers, because they occur in pairs that differ in the sign of the odd powers.
  using Quadratic = std::array<double, 3>;
  using Cubic = std::array<double, 4>;

  /// In C = cos 2z, where z = pi u/2K.
  struct Circular {
    double quarter_turns;  ///< Quarter turns of z per unit of u: 1/K.
    Quadratic even34, odd34;
    std::array<double, 2> even12, odd12;
    Cubic re;
    Quadratic im;  ///< Without its factor sin 2z.
  } circular_{};
  /// In x = exp(-|w|), where w = pi r/2K' and u = r + 2K turns, and y = sqrt(q') / x.
  struct Hyperbolic {
    double turns, period;    ///< 1/2K and 2K; zero if K is infinite.
    double scale;            ///< dw/du.
    double root;             ///< sqrt q'.
    double drift;            ///< d angle / du.
    double q, q2, q4, q6;    ///< Powers of q'.
    Cubic re, im;            ///< In y.
    Cubic re_rest, im_rest;  ///< In x, without their factor x.
  } hyperbolic_series_{};
};

}  // namespace twrench::elliptic
