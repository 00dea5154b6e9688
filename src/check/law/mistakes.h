#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "check/law/law.h"
#include "recording/rows.h"

namespace twrench::check {

/// The mistakes in the law of a simulator that can be recognised.
enum class Mistake {
  gyroscopic_factor,  ///< the gyroscopic term is reversed, halved, missing ...
  undivided,          ///< it is not divided by the moments
  multiplied,         ///< it is multiplied by the moments
  body_torque,        ///< a constant torque in the body's axes acts
  space_torque,       ///< a constant torque in the axes of space acts
  damping,            ///< the rates decay in proportion to themselves
  quadratic_damping,  ///< they decay in proportion to |w| w
  speed_limit,        ///< |w| is limited
  products_sign,      ///< the products of inertia have the other sign
  inverse_inertia,    ///< the inertia is inverted
  moments,            ///< the body has other moments about the same principal axes
  attitude_factor,    ///< the attitude turns at a multiple of the rates
  swapped_factors,    ///< the attitude takes rates in the body's axes for rates in those of space
  delayed_rates,      ///< the attitude follows earlier rates
  integrated_angles,  ///< Euler angles are integrals of the rates
};

/// A wrong law that rows follow.
struct Explanation {
  Mistake mistake;
  Law law;
  Eigen::VectorXd value;      ///< the fitted numbers of the mistake; see Law for their units
  Eigen::VectorXd deviation;  ///< their standard deviations
  /// The numbers that were fitted and are none that mistakes usually have, such as -1 or 1/2.
  int free_numbers;
  double miss;  ///< what the law leaves of the changes of the rates, or of the attitude
};

/// The wrong laws that explain rows which do not follow the motion of a free body.
struct WrongLaws {
  /// The root mean square error of the motion of a free body, relative to the changes of the rates.
  /// Infinite if nothing was tried.
  double rates_miss = std::numeric_limits<double>::infinity();
  /// Likewise of the attitude, under the law that the rates follow; 0 if there is none.
  double attitude_miss = std::numeric_limits<double>::infinity();
  /// The laws that the rates follow equally well, with equally many free numbers; empty if
  /// they follow that of a free body, or none.
  std::vector<Explanation> of_rates;
  std::vector<Explanation> of_attitude;  ///< likewise

  /// Whether no wrong law explains anything.
  bool empty() const { return of_rates.empty() && of_attitude.empty(); }
};

/// Standard deviations of errors that are independent from row to row.
struct RelativeNoise {
  double rates;     ///< relative to |w|
  double attitude;  ///< rad
};

/// The quantities that rows have. The rates of `attitude` are those of RowsWithRates.
enum class RowParts { rates, attitude, both };

/// Fits each wrong law to pairs of rows that are spread over all rows: the state of the first row
/// of a pair must lead to that of the second. Tries nothing if there are few rows, if all rates
/// are zero, or if the body turns by more than two radians between rows, because no law can be
/// recognised then.
WrongLaws wrong_laws(const Eigen::Matrix3d& inertia, std::span<const recording::Row> rows,
                     RowParts parts, const RelativeNoise& noise);

/// The misses of a law, as in WrongLaws.
struct LawMiss {
  double rates, attitude;

  double worst() const { return std::max(rates, attitude); }
};

/// The misses of the motion of a free body.
LawMiss free_body_miss(const Eigen::Matrix3d& inertia, std::span<const recording::Row> rows,
                       RowParts parts, const RelativeNoise& noise);

}  // namespace twrench::check
