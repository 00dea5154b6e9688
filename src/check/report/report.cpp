#include "check/report/report.h"

#include <fmt/format.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>

#include "base/words.h"
#include "check/report/alternative_text.h"
#include "recording/conventions/convention.h"
#include "text/escape.h"

namespace twrench::check {
namespace {

std::string line(std::string_view name, const std::string& text) {
  return text.empty() ? std::string() : fmt::format("  {:<16}{}\n", name, text);
}

std::string reading_text(const Judgement& judgement) {
  const recording::Convention& convention = judgement.convention;
  std::string text = recording::format_columns(convention.columns);
  if (judgement.quaternion_length != 1) {
    text += fmt::format(", quaternions of length {:.6g}", judgement.quaternion_length);
  }
  recording::Convention plain;
  plain.columns = convention.columns;
  for (const recording::Field& field : recording::convention_fields()) {
    if (!agree(field, plain, convention)) text += "; " + field.statement(convention);
  }
  return text;
}

/// The precision of the numbers. The resolution limit follows from it.
std::string precision_line(const Judgement& judgement) {
  std::string text = "times: " + precision_text(judgement.digits.time);
  if (judgement.has_rates) text += "; rates: " + precision_text(judgement.rate_resolution);
  if (judgement.has_attitude)
    text += "; attitude: " + precision_text(judgement.attitude_resolution);
  return text;
}

std::string vector_text(const Eigen::Vector3d& v) {
  return fmt::format("{:.10g},{:.10g},{:.10g}", v[0], v[1], v[2]);
}

std::string start_text(const Judgement& judgement) {
  const RateScale unit = rate_scale(judgement);
  const Reference& reference = judgement.reference;
  const std::string rates = vector_text(reference.body.omega() * unit.per_radian);
  std::string text = fmt::format("omega {} {} at t = {} s", rates, unit.symbol,
                                 clock_text(judgement, reference.start));
  if (!judgement.fit) return text;
  const Fit& fit = *judgement.fit;
  text += fmt::format(", fitted to {} rows, +- {:.2g},{:.2g},{:.2g}", fit.rows,
                      fit.omega_deviation[0] * unit.per_radian,
                      fit.omega_deviation[1] * unit.per_radian,
                      fit.omega_deviation[2] * unit.per_radian);
  if (fit.rate_residual) {
    text += fmt::format("; residual {:.3g} {}", *fit.rate_residual * unit.per_radian, unit.symbol);
  }
  if (fit.attitude_residual) {
    text += fmt::format("; residual {:.3g} deg", degrees(*fit.attitude_residual));
  }
  return text;
}

/// A direction in the file's axes, to three decimals: "(1, 0, -0.012)".
std::string axis_text(const Eigen::Vector3d& axis) {
  std::vector<std::string> components;
  for (const double component : axis) {
    const double rounded = std::round(1000 * component) / 1000;
    components.push_back(fmt::format("{:g}", rounded == 0 ? 0 : rounded));
  }
  return fmt::format("({})", joined(components, ", "));
}

/// The moments that were fitted, and the argument that gives them to another check.
std::string moments_text(const CheckedFile& file) {
  if (!file.inertia) return {};
  const FittedInertia& found = *file.inertia;
  const Eigen::Matrix3d& I = found.inertia;
  return fmt::format(
      "1 : {:.6g} +- {:.2g} : {:.6g} +- {:.2g} about the axes {}, {} and {}, fitted to the rates, "
      "which do not determine their size; {} gives them",
      found.moments[1], found.deviation[1], found.moments[2], found.deviation[2],
      axis_text(found.axes.col(0)), axis_text(found.axes.col(1)), axis_text(found.axes.col(2)),
      argument("inertia", fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}", I(0, 0), I(1, 1),
                                      I(2, 2), I(0, 1), I(0, 2), I(1, 2))));
}

/// The rows without numbers.
std::string left_out_text(const CheckedFile& file) {
  return file.left_out.empty() ? std::string() : file.left_out + ", where numbers are missing";
}

/// The columns that are not read, but could be rates or an attitude.
std::string unread_text(const CheckedFile& file) {
  if (file.unread.empty()) return {};
  constexpr std::size_t most = 9;
  const std::size_t shown = std::min(most, file.unread.size());
  const std::vector<std::string> first(file.unread.begin(),
                                       file.unread.begin() + static_cast<std::ptrdiff_t>(shown));
  return fmt::format("{}{}; if they are {}, {} names them", joined(first, ", "),
                     shown < file.unread.size() ? " ..." : "",
                     file.judgement.has_rates ? "an attitude" : "rates", argument("columns"));
}

std::string size_text(const Judgement& judgement, const std::optional<ErrorSize>& size,
                      double factor, const char* unit) {
  if (!size) return {};
  return fmt::format("{:.3g} {} at {} s, rms {:.3g} {}", size->max * factor, unit,
                     clock_text(judgement, size->at), size->rms * factor, unit);
}

std::string phase_text(const Judgement& judgement) {
  if (!judgement.parts) {
    const motion::ExactMotion exact(judgement.reference.body);
    const bool is_steady = exact.kind() == motion::ExactMotion::Kind::steady;
    return is_steady ? "none: the motion is steady" : "lost: the rates are on no one polhode";
  }
  const ErrorParts& parts = *judgement.parts;
  const RateScale unit = rate_scale(judgement);
  std::string text = fmt::format(
      "{:.3g} s {} at {} s, {:.3g} {}", std::abs(parts.delay), parts.delay < 0 ? "early" : "late",
      clock_text(judgement, parts.delay_at), parts.phase_rate * unit.per_radian, unit.symbol);
  if (judgement.has_attitude) {
    text += fmt::format("; about L {:.3g} deg", degrees(parts.angle_about_l));
  }
  return text;
}

std::string amplitude_text(const Judgement& judgement) {
  const RateScale unit = rate_scale(judgement);
  std::string text = "energy " + change_text("{:.2e}", judgement.energy_error);
  if (judgement.momentum_error) text += ", |L| " + change_text("{:.2e}", *judgement.momentum_error);
  if (!judgement.parts) return text;
  text +=
      fmt::format(", {:.3g} {}", judgement.parts->amplitude_rate * unit.per_radian, unit.symbol);
  if (judgement.has_attitude) {
    text += fmt::format("; across L {:.3g} deg", degrees(judgement.parts->tilt));
  }
  return text;
}

std::string drift_text(const Judgement& judgement) {
  std::string text = "energy " + change_text("{:.2e}", judgement.energy_drift);
  if (judgement.momentum_drift) text += ", |L| " + change_text("{:.2e}", *judgement.momentum_drift);
  if (judgement.direction_drift) {
    text += fmt::format(", direction of L {:.2g} deg", degrees(*judgement.direction_drift));
  }
  if (judgement.orthogonality_error) {
    text += fmt::format(", orthogonality {:.2e}", *judgement.orthogonality_error);
  }
  return text + (judgement.has_rates ? "" : " (of the rates that the attitude implies)");
}

/// How far an error of the initial state grows, and with it the rounding of the file's digits.
std::string conditioning_text(const Judgement& judgement) {
  const RateScale unit = rate_scale(judgement);
  const LastDigits& digits = judgement.digits;
  if (judgement.rows == 1) return {};
  std::string of_digits, open;
  if (judgement.has_rates) {
    of_digits = fmt::format("{:.2g} {}, ", digits.rate * unit.per_radian, unit.symbol);
    open = fmt::format("{:.3g} {}", judgement.rate_limit * unit.per_radian, unit.symbol);
  }
  if (judgement.has_attitude) {
    of_digits += fmt::format("{:.2g} deg, ", degrees(digits.attitude));
    open +=
        fmt::format("{}{:.3g} deg", open.empty() ? "" : " and ", degrees(judgement.attitude_limit));
  }
  return fmt::format(
      "an error of the initial rates grows {:.3g} times; with the resolution of the digits, "
      "{}{:.2g} "
      "s, the limit is {} at the end",
      judgement.growth.rates, of_digits, digits.time.at(judgement.duration), open);
}

/// The noise, if it is larger than the resolution of the digits.
std::string noise_text(const Judgement& judgement) {
  const LastDigits& digits = judgement.digits;
  std::string text;
  if (is_foreign(judgement)) return text;
  if (judgement.noise.rate > digits.printed_rate) {
    const RateScale unit = rate_scale(judgement);
    text = fmt::format("rates are printed to {:.1e} {}, but scatter by {:.1e} from row to row",
                       digits.printed_rate * unit.per_radian, unit.symbol,
                       judgement.noise.rate * unit.per_radian);
  }
  if (judgement.noise.attitude > digits.printed_attitude) {
    text += fmt::format("{}the attitude is printed to {:.1e} deg, but scatters by {:.1e}",
                        text.empty() ? "" : "; ", degrees(digits.printed_attitude),
                        degrees(judgement.noise.attitude));
  }
  return text;
}

std::string time_text(const Judgement& judgement, const std::optional<double>& t) {
  return t ? fmt::format("{:.9f}", clock_time(judgement, *t)) : "-";
}

std::string flip_line(const Judgement& judgement, const Flip& flip) {
  const std::string offset =
      flip.found && flip.exact ? fmt::format("{:+.3g}", *flip.found - *flip.exact) : "-";
  return fmt::format("    {:>18}{:>18}{:>14}\n", time_text(judgement, flip.found),
                     time_text(judgement, flip.exact), offset);
}

std::string no_flips(const Judgement& judgement) {
  const motion::ExactMotion exact(judgement.reference.body);
  if (exact.kind() == motion::ExactMotion::Kind::steady) {
    return "none: the exact motion is steady";
  }
  return exact.flips() ? "none in this time" : "none: there is no intermediate axis";
}

std::string flips_text(const Judgement& judgement) {
  const auto& flips = judgement.flips;
  if (flips.empty()) return line("flips", no_flips(judgement));
  const auto found =
      std::ranges::count_if(flips, [](auto& flip) { return flip.found.has_value(); });
  const auto exact =
      std::ranges::count_if(flips, [](auto& flip) { return flip.exact.has_value(); });
  std::string text = line("flips", fmt::format("{} found, {} exact", found, exact));
  text += fmt::format("    {:>18}{:>18}{:>14}\n", "found, s", "exact, s", "offset, s");
  constexpr std::size_t most = 8;
  for (std::size_t i = 0; i < std::min(flips.size(), most); ++i)
    text += flip_line(judgement, flips[i]);
  return text + (flips.size() > most ? "    ...\n" : "");
}

std::string bounds_text(const CheckedFile& file) {
  std::string text;
  for (const CheckBound& bound : file.bounds) {
    text += line(
        bound.is_exceeded() ? "exceeded" : "held",
        fmt::format("{} {:.6g}{}{}: {}", argument(bound.argument), bound.most,
                    bound.unit.empty() ? "" : " ", bound.unit, change_text("{:.6g}", bound.value)));
  }
  return text;
}

std::string file_text(const CheckedFile& file, const ArgumentWording& wording) {
  const Judgement& judgement = file.judgement;
  const RateScale unit = rate_scale(judgement);
  return fmt::format("{}: {} rows, {} to {} s\n", text::escape(file.name), judgement.rows,
                     clock_text(judgement, 0), clock_text(judgement, judgement.duration)) +
         line("read as", text::escape(reading_text(judgement))) +
         line("not read", text::escape(with_arguments(unread_text(file), wording))) +
         line("left out", text::escape(left_out_text(file))) +
         line("precision", precision_line(judgement)) +
         line("moments", with_arguments(moments_text(file), wording)) +
         line("from", start_text(judgement)) +
         line("rate error", size_text(judgement, judgement.rates, unit.per_radian, unit.symbol)) +
         line("attitude error", size_text(judgement, judgement.attitude, degrees(1), "deg")) +
         line("drift", drift_text(judgement)) + line("phase", phase_text(judgement)) +
         line("amplitude", amplitude_text(judgement)) + flips_text(judgement) +
         line("conditioning", conditioning_text(judgement)) + line("noise", noise_text(judgement)) +
         with_arguments(bounds_text(file), wording) +
         line("verdict", text::escape(with_arguments(verdict(file).text, wording)));
}

std::string orders_text(const CheckResult& result) {
  const CheckOrders& orders = result.orders;
  if (!orders.why_not.empty()) return "order: " + orders.why_not + "\n";
  std::string text;
  if (orders.rates) text += fmt::format("order seen in the rates: {:.2f}\n", *orders.rates);
  if (orders.attitude)
    text += fmt::format("order seen in the attitude: {:.2f}\n", *orders.attitude);
  return text;
}

}  // namespace

std::string check_text(const CheckResult& result, const ArgumentWording& wording) {
  std::string text;
  for (const CheckedFile& file : result.files)
    text += file_text(file, wording) + (result.files.size() > 1 ? "\n" : "");
  return text + with_arguments(orders_text(result), wording);
}

}  // namespace twrench::check
