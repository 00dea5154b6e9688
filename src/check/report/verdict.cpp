#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/words.h"
#include "check/report/alternative_text.h"
#include "check/report/law_text.h"
#include "check/report/result.h"
#include "recording/conventions/units.h"

namespace twrench::check {
namespace {

std::string foreign_text(const CheckedFile& file) {
  const Judgement& judgement = file.judgement;
  const Alternatives& alternatives = file.alternatives;
  if (!alternatives.fitting.empty()) {
    constexpr std::size_t most = 4;
    std::vector<std::string> texts;
    for (const Reading& reading : alternatives.fitting) {
      if (texts.size() < most) texts.push_back(alternative_text(judgement, reading.convention));
    }
    const char* const start =
        is_foreign(judgement) ? "as read, it does not follow this body's motion, but it does if "
                              : "as read, it follows this body's motion only roughly, but it "
                                "does far better if ";
    std::string text = start + joined(texts, "; or if ");
    if (alternatives.fitting.size() > most) text += "; or in other ways";
    const WrongLaws& laws = alternatives.laws;
    if (laws.empty()) return text;
    return text + "; or a wrong law explains it as well: " + law_text(judgement, laws);
  }
  const Misfit& misfit = judgement.misfit;
  const bool rates_fit = Misfit{misfit.rates, {}}.fits();
  if (misfit.rates && misfit.attitude && rates_fit) {
    return "attitude and rates are inconsistent in every frame and unit, though the rates follow "
           "this body's motion";
  }
  std::string text = "does not follow this body's motion in any unit or frame";
  if (!judgement.has_attitude) {
    text += " (without an attitude, rates in space axes cannot be recognised)";
  }
  constexpr double near = 0.5;  // of what changes
  const auto& nearest = alternatives.nearest;
  const auto is_as_read = [&](const recording::Field& field) {
    return agree(field, judgement.convention, nearest->convention);
  };
  if (nearest && *nearest->misfit.worst() < near &&
      !std::ranges::all_of(recording::convention_fields(), is_as_read)) {
    text += fmt::format("; the nearest is that {}; then it still misses {:.2g} of what changes",
                        alternative_text(judgement, nearest->convention), *nearest->misfit.worst());
  }
  return text;
}

/// Whether the laws only say that the body is another one.
bool are_of_another_body(const WrongLaws& laws) {
  return laws.of_attitude.empty() && std::ranges::all_of(laws.of_rates, [](const Explanation& one) {
           return one.mistake == Mistake::moments || one.mistake == Mistake::inverse_inertia ||
                  one.mistake == Mistake::products_sign;
         });
}

/// The verdict on rows that follow a wrong law.
Verdict verdict_of_law(const Judgement& judgement, const WrongLaws& laws) {
  const std::string text = law_text(judgement, laws);
  if (are_of_another_body(laws))
    return {Finding::body, "follows the motion of another body: " + text};
  if (laws.of_rates.empty())
    return {Finding::inconsistent, "attitude and rates are inconsistent: " + text};
  return {Finding::law, "does not follow this body's motion: " + text};
}

/// "x, y and z": the unit vector of a rate to three places.
std::string direction_text(const Eigen::Vector3d& rate) {
  const Eigen::Vector3d n = rate.normalized();
  const auto places = [](double value) {
    return fmt::format("{:.3f}", std::round(1e3 * value) / 1e3 + 0.0);  // no minus before 0
  };
  return fmt::format("({}, {}, {})", places(n.x()), places(n.y()), places(n.z()));
}

/// The least share of the errors that a steady turn of the frame must explain.
constexpr double steady = 0.99;

/// Whether the attitude turns steadily about L relative to the rates, as if it were integrated less
/// accurately.
bool turns_about_momentum(const Judgement& judgement) {
  const FrameTurn& turn = judgement.frame_turn;
  const Eigen::Vector3d L = judgement.reference.frame * judgement.reference.body.momentum();
  return turn.share >= steady && std::abs(turn.rate.normalized().dot(L.normalized())) > steady;
}

std::string contradiction_text(const Judgement& judgement) {
  std::string text = fmt::format(
      "attitude and rates are inconsistent: the attitude is off by up to {:.3g} deg, more than "
      "the errors of the rates explain",
      degrees(judgement.attitude->max));
  const FrameTurn& turn = judgement.frame_turn;
  if (turn.share < steady) return text;
  if (turns_about_momentum(judgement)) {
    return text + fmt::format(
                      ", by {:.3g} deg/s about L, as when it is integrated less accurately "
                      "than the rates",
                      degrees(turn.rate.norm()));
  }
  text += fmt::format(
      ", as in a reference frame that itself rotates at {:.4g} deg/s about {} in space axes",
      degrees(turn.rate.norm()), direction_text(turn.rate));
  constexpr double earth = 7.292115e-5;  // rad/s, sidereal
  if (std::abs(turn.rate.norm() / earth - 1) < 0.02) text += " (the Earth's rate)";
  return text;
}

/// The numbers of flips in the file and in the exact motion, if they differ by more than one at the
/// end; then no delay explains the error.
std::string other_flips_text(const Judgement& judgement) {
  const auto found =
      std::ranges::count_if(judgement.flips, [](auto& f) { return f.found.has_value(); });
  const auto exact =
      std::ranges::count_if(judgement.flips, [](auto& f) { return f.exact.has_value(); });
  if (judgement.more_flips || std::abs(found - exact) <= 1) return {};
  return fmt::format("; it flips {} times instead of {}", found, exact);
}

/// The main part of the error.
std::string cause_text(const Judgement& judgement) {
  if (const std::string flips = other_flips_text(judgement); !flips.empty()) return flips;
  if (!judgement.parts) return {};
  const ErrorParts& parts = *judgement.parts;
  // Phase and amplitude have the same unit only in the rates, which decide for the attitude as
  // well.
  const double phase = parts.phase_rate, amplitude = parts.amplitude_rate;
  constexpr double mostly = 3;
  const std::string delay =
      fmt::format("it runs {:.3g} s {}", std::abs(parts.delay), parts.delay > 0 ? "late" : "early");
  const std::string level = fmt::format("energy off by {:.2g}", judgement.energy_error);
  if (phase > mostly * amplitude) {
    return fmt::format("; mostly phase: {}, energy is conserved to {:.2g}", delay,
                       judgement.energy_drift);
  }
  if (amplitude > mostly * phase) return "; mostly amplitude: " + level;
  return fmt::format("; phase and amplitude: {}, {}", delay, level);
}

std::string sizes_text(const Judgement& judgement) {
  std::vector<std::string> sizes;
  if (judgement.rates) {
    const RateScale unit = rate_scale(judgement);
    sizes.push_back(fmt::format("{:.3g} {} at {} s", judgement.rates->max * unit.per_radian,
                                unit.symbol, clock_text(judgement, judgement.rates->at)));
  }
  if (judgement.attitude && !judgement.attitude_contradicts_rates) {
    sizes.push_back(fmt::format("{:.3g} deg at {} s", degrees(judgement.attitude->max),
                                clock_text(judgement, judgement.attitude->at)));
  }
  return joined(sizes, " and ");
}

/// The largest error in units of the resolution limit at its time.
double beyond_digits(const Judgement& judgement) {
  double most = 0;
  for (const Span& span : judgement.course) {
    if (judgement.has_rates) most = std::max(most, span.rate_error / span.rate_limit);
    if (judgement.has_attitude && !judgement.attitude_contradicts_rates) {
      most = std::max(most, span.attitude_error / span.attitude_limit);
    }
  }
  return most;
}

/// Whether the first row is not in the given state, and this explains the later errors.
bool begins_otherwise(const Judgement& judgement) {
  const double error = judgement.first_rate_error;
  constexpr double at_least_mostly = 3;
  return !judgement.fit && !judgement.within_digits &&
         error > judgement.course.front().rate_limit &&
         at_least_mostly * judgement.growth.rates * error > judgement.rates->max;
}

std::string beginning_text(const CheckedFile& file) {
  const Judgement& judgement = file.judgement;
  const RateScale unit = rate_scale(judgement);
  std::string fitted;
  if (file.other_start) {
    const Reference& reference = file.other_start->reference;
    const Eigen::Vector3d omega = reference.body.omega() * unit.per_radian;
    fitted = fmt::format("; {} finds {:.6g},{:.6g},{:.6g} {} at {} s", argument("fit"), omega[0],
                         omega[1], omega[2], unit.symbol, clock_text(judgement, reference.start));
  }
  return fmt::format(
      "starts from another state: its first row is already off by {:.3g} {}, which grows to "
      "explain the largest error, {}{}",
      judgement.first_rate_error * unit.per_radian, unit.symbol, sizes_text(judgement), fitted);
}

bool rates_within_digits(const Judgement& judgement) {
  return std::ranges::all_of(judgement.course,
                             [](const Span& span) { return span.rate_error <= span.rate_limit; });
}

std::string faultless_text(const Judgement& judgement) {
  const std::string text =
      fmt::format("off by at most {}, within the resolution of its digits", sizes_text(judgement));
  constexpr double much_of_the_motion = 0.1;
  const double speed = judgement.reference.body.omega().norm();
  const bool says_little = judgement.has_rates ? judgement.rate_limit > much_of_the_motion * speed
                                               : judgement.attitude_limit > much_of_the_motion;
  return says_little ? text + "; but by the end almost any motion would be" : text;
}

/// Whether the attitudes are farther from rotations than their errors and their digits explain.
bool is_no_rotation(const Judgement& judgement) {
  if (!judgement.orthogonality_error) return false;
  constexpr double margin = 10, round_off = 1e-14;
  const double explained =
      std::max({judgement.attitude->max, judgement.digits.attitude, round_off});
  return *judgement.orthogonality_error > margin * explained;
}

std::string no_rotation_text(const Judgement& judgement) {
  const char* const difference =
      attitude_form(judgement.convention) == recording::AttitudeForm::matrix
          ? "matrices are not rotations: X^T X differs from the identity"
          : "quaternions are not of unit length: the squared length differs from 1";
  return fmt::format("its {} by up to {:.3g}; apart from that, it is ", difference,
                     *judgement.orthogonality_error);
}

/// States the noise and the errors that it explains.
std::string noise_verdict_text(const Judgement& judgement) {
  std::vector<std::string> noise;
  const bool exceeds_digits = judgement.noise.rate > judgement.digits.rate ||
                              judgement.noise.attitude > judgement.digits.attitude;
  const LastDigits digits = exceeds_digits ? judgement.digits : LastDigits{};
  if (judgement.noise.rate > digits.rate) {
    const RateScale unit = rate_scale(judgement);
    noise.push_back(
        fmt::format("{:.2g} {} in the rates", judgement.noise.rate * unit.per_radian, unit.symbol));
  }
  if (judgement.noise.attitude > digits.attitude) {
    noise.push_back(fmt::format("{:.2g} deg in the attitude", degrees(judgement.noise.attitude)));
  }
  return fmt::format(
      "follows the exact motion within its noise, which is independent from row to row, {} rms: "
      "off "
      "by up to {}{}",
      joined(noise, " and "), sizes_text(judgement),
      judgement.fit ? "" : "; the noise of the first row grows with time: use " + argument("fit"));
}

/// The verdict on a body that is at rest at first.
Verdict verdict_at_rest(const CheckedFile& file) {
  const Judgement& judgement = file.judgement;
  if (begins_otherwise(judgement)) return {Finding::start, beginning_text(file)};
  if (judgement.within_digits) {
    return {Finding::exact, "has no detectable error: the body is at rest, and stays so"};
  }
  return {
      Finding::law,
      "does not follow the motion of a free body: it is at rest at first and turns later, by up "
      "to " +
          sizes_text(judgement)};
}

std::string error_text(const Judgement& judgement) {
  return fmt::format(
      "off by up to {}, and by up to {:.3g} times the resolution limit of its digits{}",
      sizes_text(judgement), beyond_digits(judgement), cause_text(judgement));
}

}  // namespace

RateScale rate_scale(const Judgement& judgement) {
  const recording::RateUnitName& name = name_of(rate_unit(judgement.convention));
  return {1 / name.in_rad_s, name.symbol};
}

double degrees(double angle) { return angle * (180 / std::numbers::pi); }

bool is_foreign(const Judgement& judgement) { return !judgement.misfit.fits(); }

std::string free_rows_text(const recording::Extract& rows) {
  const std::string from = fmt::format("{:.6g}", rows.from), to = fmt::format("{:.6g}", rows.to);
  return fmt::format(
      "the rows from {} to {} s after the first follow a free motion within their "
      "noise: {} {}",
      from, to, argument("from", from), argument("to", to));
}

namespace {

Verdict verdict_of_all_rows(const CheckedFile& file) {
  const Judgement& judgement = file.judgement;
  if (judgement.reference.body.omega().norm() == 0) return verdict_at_rest(file);
  const WrongLaws& laws = file.alternatives.laws;
  if (!laws.empty() && file.alternatives.fitting.empty()) return verdict_of_law(judgement, laws);
  if (is_foreign(judgement) || !file.alternatives.fitting.empty()) {
    const bool is_misread = !file.alternatives.fitting.empty();
    const bool rates_fit = judgement.misfit.rates && Misfit{judgement.misfit.rates, {}}.fits();
    const Finding of_none =
        judgement.misfit.attitude && rates_fit ? Finding::inconsistent : Finding::law;
    return {is_misread ? Finding::convention : of_none, foreign_text(file)};
  }
  if (begins_otherwise(judgement)) return {Finding::start, beginning_text(file)};
  if (is_no_rotation(judgement) && !judgement.attitude_contradicts_rates) {
    return {Finding::integration,
            no_rotation_text(judgement) +
                (judgement.within_digits ? faultless_text(judgement) : error_text(judgement))};
  }
  if (judgement.within_digits) {
    return {Finding::exact, "has no detectable error: " + faultless_text(judgement)};
  }
  if (judgement.within_noise) return {Finding::noise, noise_verdict_text(judgement)};
  if (judgement.attitude_contradicts_rates) {
    const std::string of_rates =
        rates_within_digits(judgement)
            ? "the rates have no detectable error: " + faultless_text(judgement)
            : "the rates are " + error_text(judgement);
    const Finding finding =
        turns_about_momentum(judgement) ? Finding::integration : Finding::inconsistent;
    return {finding, contradiction_text(judgement) + "; " + of_rates};
  }
  return {Finding::integration, error_text(judgement)};
}

}  // namespace

Verdict verdict(const CheckedFile& file) {
  Verdict found = verdict_of_all_rows(file);
  if (file.free_rows) found.text += "; " + free_rows_text(*file.free_rows);
  return found;
}

bool passes(const CheckedFile& file) {
  if (!file.bounds.empty()) return std::ranges::none_of(file.bounds, &CheckBound::is_exceeded);
  const Finding finding = verdict(file).finding;
  return finding == Finding::exact || finding == Finding::noise;
}

std::string clock_text(const Judgement& judgement, double t) {
  constexpr double large = 1e6;
  const double time = clock_time(judgement, t);
  return std::abs(time) < large ? fmt::format("{:.10g}", time) : fmt::format("{:.6f}", time);
}

std::string change_text(const char* format, double change) {
  return std::isfinite(change) ? fmt::format(fmt::runtime(format), change) : "from zero";
}

std::string precision_text(const recording::Resolution& resolution) {
  const std::string before = resolution.converted ? " before a change of the unit" : "";
  switch (resolution.written) {
    case recording::NumberFormat::decimals:
      return fmt::format("{} decimals{}", resolution.count, before);
    case recording::NumberFormat::digits:
      return fmt::format("{} significant digits{}", resolution.count, before);
    case recording::NumberFormat::float16:
      return "float16 (11 bits)";
    case recording::NumberFormat::float32:
      return "float32 (24 bits)";
    case recording::NumberFormat::float64:
      return "all digits of a double";
  }
  return {};
}

}  // namespace twrench::check
