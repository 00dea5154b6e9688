#include "check/report/choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "check/hypotheses/hypotheses.h"
#include "check/hypotheses/lawful_readings.h"
#include "check/hypotheses/other_conventions.h"
#include "check/hypotheses/readings.h"
#include "recording/angle_choice.h"
#include "recording/columns/columns.h"
#include "recording/columns/open_conventions.h"
#include "recording/columns/stated_unit.h"
#include "recording/conventions/convention.h"
#include "recording/conventions/names.h"
#include "recording/informative_rows.h"
#include "recording/time_choice.h"
#include "table/reader.h"

namespace twrench::check {
namespace {

using recording::AttitudeForm;
using recording::Convention;

/// The components of the quaternion in the order of the file's columns: "xyzw".
std::string component_order(const table::Header& header, const Convention& convention) {
  std::vector<std::pair<std::size_t, char>> places;
  for (const char component : {'w', 'x', 'y', 'z'}) {
    const auto column = convention.columns.find(std::string("q") + component);
    if (column == convention.columns.end()) return {};
    places.emplace_back(recording::find_column(header, column->first, column->second), component);
  }
  std::ranges::sort(places);
  std::string order;
  for (const auto& [place, component] : places) order += component;
  return order;
}

/// "these quaternions fit as xyzw, body from space".
std::string fit_text(const table::Header& header, const Convention& convention) {
  const char* frames = convention.inverse ? "body from space" : "space from body";
  switch (attitude_form(convention)) {
    case AttitudeForm::quaternion:
      return fmt::format("these quaternions fit as {}, {}", component_order(header, convention),
                         frames);
    case AttitudeForm::euler:
      return fmt::format("these angles fit as turns about {}, then {}, then {}, {}",
                         convention.sequence[0], convention.sequence[1], convention.sequence[2],
                         frames);
    case AttitudeForm::matrix:
      return fmt::format("these matrices fit as {}", frames);
    case AttitudeForm::rotation_vector:
    case AttitudeForm::axis_angle:
    case AttitudeForm::mrp:
    case AttitudeForm::rodrigues:
      return fmt::format("these rotations fit as {}", frames);
    case AttitudeForm::none:
      break;
  }
  return "only one of them fits the physics";
}

/// The arguments that select `one` of the open conventions: the fields in which these differ.
std::string choice_text(const std::vector<Convention>& open, const Convention& one) {
  std::vector<std::string> mentions;
  for (const recording::Field& field : recording::convention_fields()) {
    const bool is_open = std::ranges::any_of(
        open, [&](const Convention& other) { return !agree(field, other, one); });
    const std::string text = mention(field, one);
    if (is_open && !text.empty()) mentions.push_back(text);
  }
  return fmt::format("{}", fmt::join(mentions, " "));
}

/// Whether the conventions differ only in the order of a quaternion q0, q1, q2, q3, and this one
/// has the scalar first, as these names mean in most books.
bool is_usual_order(const table::Header& header, const std::vector<Convention>& open,
                    const Convention& one) {
  if (open.size() != 2 || component_order(header, one) != "wxyz") return false;
  const std::vector<std::string> words =
      recording::words_of(header.names[recording::find_column(header, "qw", one.columns.at("qw"))]);
  const auto without_quaternion = [](Convention convention) {
    for (const std::string& ours : names_of(recording::Kind::quaternion))
      convention.columns.erase(ours);
    return convention.columns;
  };
  const bool is_named = words.size() > 1 && words.back() == "0";
  return is_named && open[0].time_unit == open[1].time_unit &&
         without_quaternion(open[0]) == without_quaternion(open[1]);
}

/// Whether all conventions agree with this one in the fields that have other names.
bool differ_only_in(std::initializer_list<std::string_view> names,
                    const std::vector<Convention>& open, const Convention& one) {
  return std::ranges::all_of(recording::convention_fields(), [&](const recording::Field& field) {
    return std::ranges::find(names, field.name) != names.end() ||
           std::ranges::all_of(open,
                               [&](const Convention& other) { return agree(field, other, one); });
  });
}

/// Whether the conventions differ only in the sequence of Euler angles, or in their unit if their
/// size leaves it open, and this one has the usual sequence.
bool is_usual_sequence(const std::vector<Convention>& open, const Convention& one) {
  return attitude_form(one) == AttitudeForm::euler && one.sequence == "zyx" &&
         differ_only_in({"sequence", "angle_units"}, open, one);
}

/// Whether the others are Euler angles in the columns of a rotation vector, as RX, RY and RZ are
/// rather called.
bool is_usual_vector(const std::vector<Convention>& open, const Convention& one) {
  return attitude_form(one) == AttitudeForm::rotation_vector &&
         std::ranges::all_of(open, [&](const Convention& other) {
           return attitude_form(other) == AttitudeForm::euler || other.columns == one.columns;
         });
}

/// Whether the conventions differ only in the order of the entries of a matrix in a file of
/// Qualisys, and this one has its order: Rot[0], Rot[3] and Rot[6] are the first row.
bool is_order_of_qualisys(const table::Header& header, const std::vector<Convention>& open,
                          const Convention& one) {
  const bool is_of_qualisys = std::ranges::any_of(
      header.preamble, [](const std::string& line) { return line.starts_with("NO_OF_BODIES"); });
  return is_of_qualisys && open.size() == 2 && attitude_form(one) == AttitudeForm::matrix &&
         recording::words_of(one.columns.at("x12")).back() == "3" &&
         differ_only_in({"columns"}, open, one);
}

/// The convention with times in s, if only the unit of times is open.
std::optional<Convention> in_seconds(const std::vector<Convention>& open) {
  const Convention& first = open.front();
  const bool is_unit_alone = differ_only_in({"time_unit"}, open, first);
  return is_unit_alone && time_unit(first) == recording::TimeUnit::s ? std::optional(first)
                                                                     : std::nullopt;
}

/// The convention of the usual order of a quaternion, if the first row is the identity in it.
/// Steady rotations fit in any order, and simulations usually begin there.
std::optional<Convention> usual_from_identity(const recording::Recording& recording,
                                              const std::vector<Convention>& open) {
  const auto usual = std::ranges::find_if(
      open, [&](const Convention& one) { return is_usual_order(recording.header(), open, one); });
  if (usual == open.end()) return std::nullopt;
  const std::vector<recording::Row> first = recording::beginning(recording, *usual, 1);
  const bool is_identity = !first.empty() && first.front().X.isIdentity(0);
  return is_identity ? std::optional(*usual) : std::nullopt;
}

InvalidArgument ambiguous(const table::Header& header, const std::vector<Convention>& open,
                          const std::optional<Reading>& fitting) {
  const std::string why = fmt::format("its columns can be read in {} ways", open.size());
  if (fitting) {
    return {header.file, why,
            fmt::format("{}: add {}", fit_text(header, fitting->convention),
                        choice_text(open, fitting->convention))};
  }
  constexpr std::size_t most = 8;
  std::vector<std::string> ways;
  for (const Convention& convention : open) {
    if (ways.size() < most) ways.push_back(choice_text(open, convention));
  }
  return {
      header.file, why,
      fmt::format("say which: {}{}", fmt::join(ways, "; or "), open.size() > most ? " ..." : "")};
}

/// If none of the open conventions fits, a reading that no name suggests may do so: that with the
/// fewest changes, if there is only one.
std::optional<Reading> unexpected(const recording::Recording& recording, const Problem& problem,
                                  const std::vector<Convention>& open) {
  constexpr std::size_t most = 4;
  std::vector<std::map<std::string, std::string>> tried;
  std::optional<Reading> best;
  int fewest = std::numeric_limits<int>::max();
  for (const Convention& convention : open) {
    if (tried.size() == most) break;
    if (std::ranges::find(tried, convention.columns) != tried.end()) continue;
    tried.push_back(convention.columns);
    const std::vector<Reading> fitting = alternatives(recording, problem, convention).fitting;
    if (fitting.empty()) continue;
    const int changes = count_changes(convention, fitting.front().convention);
    if (changes > fewest) continue;
    // No option reverses the sign of a component, or contradicts the file.
    const bool is_option = fitting.size() == 1 && fitting.front().convention.negated.empty() &&
                           !contradicts_file(convention, fitting.front().convention);
    best = is_option && changes < fewest ? std::optional(fitting.front()) : std::nullopt;
    fewest = changes;
  }
  return best;
}

/// The only reading that fits: with rates, or else without them, because the attitude of a reading
/// with rates fits alone as well.
std::optional<Reading> fitting_one(const recording::Recording& recording,
                                   const Eigen::Matrix3d& inertia, std::vector<Convention> open) {
  const auto rest =
      std::ranges::stable_partition(open, [](const Convention& one) { return has_rates(one); });
  const std::vector<Convention> without(rest.begin(), rest.end());
  open.erase(rest.begin(), rest.end());
  const auto fitting = only_fitting(readings(recording, inertia, open));
  return fitting ? fitting : only_fitting(readings(recording, inertia, without));
}

/// The only reading in which a wrong law explains the rows, unless a reading that no name suggests
/// does so as well without a wrong law.
std::optional<Reading> lawful_one(const recording::Recording& recording, const Problem& problem,
                                  const std::vector<Convention>& open) {
  constexpr std::size_t most = 16;  // each takes as long as a check
  if (open.size() > most) return {};
  const std::optional<Lawful> found = only_lawful(recording, problem, open);
  if (!found) return {};
  const auto other = unexpected(recording, problem, open);
  if (!other) return found->reading;
  const double miss = miss_of_free_body(recording, problem, other->convention);
  constexpr double as_well = 20, round_off = 1e-8;
  return miss < as_well * found->miss + round_off ? other : found->reading;
}

/// The conventions that the columns and the numbers leave open.
std::vector<Convention> open_conventions(const recording::Recording& recording,
                                         const Convention& given) {
  return with_angle_units(recording,
                          with_times(recording, recording::conventions(recording.header(), given)));
}

/// The error that moments cannot be fitted to what these columns contain.
InvalidArgument no_rates_to_fit(const std::string& file, const Convention& convention) {
  const std::string why = "the moments are fitted to rates about the body's axes, and it has ";
  const std::string moments = "give the moments by " + argument("inertia", "A,B,C");
  if (!has_rates(convention)) {
    return {
        file, why + "attitudes alone",
        fmt::format("{}; or fit them to the rates that the attitudes give: export with {} writes "
                    "these to a .csv file",
                    moments, argument("motion", file))};
  }
  return {file,
          why + (has_momentum(convention) ? "angular momenta, which determine no rates"
                                          : "rates in the axes of space"),
          fmt::format("{}, or the columns of such rates by {}", moments,
                      argument("columns", "wx=NAME,wy=NAME,wz=NAME"))};
}

}  // namespace

Convention choose_rates(const recording::Recording& recording, const Convention& given) {
  std::vector<Convention> open;
  for (const Convention& one : open_conventions(recording, given)) {
    Convention rates = given;
    rates.columns.clear();
    for (const char* ours : {"t", "wx", "wy", "wz"}) {
      const auto column = one.columns.find(ours);
      if (column != one.columns.end()) rates.columns.insert(*column);
    }
    rates.time_unit = one.time_unit;
    rates.rate_unit = one.rate_unit;
    const auto is_same = [&](const Convention& other) { return count_changes(other, rates) == 0; };
    if (std::ranges::none_of(open, is_same)) open.push_back(rates);
    if (!has_rates(rates) || one.rates_in_space) throw no_rates_to_fit(recording.name(), one);
  }
  if (open.size() > 1) throw ambiguous(recording.header(), open, {});
  return open.front();
}

Convention choose_convention(const recording::Recording& recording, const Convention& given,
                             const std::optional<Problem>& problem) {
  const table::Header& header = recording.header();
  std::vector<Convention> open = open_conventions(recording, given);
  if (problem) {
    for (Convention& convention : open) convention.inertia = problem->inertia;
  }
  if (open.size() == 1) return open.front();
  const auto is_usual = [&](const Reading& reading) {
    const Convention& one = reading.convention;
    const auto is_same = [&](const Convention& other) { return count_changes(other, one) == 0; };
    return std::ranges::any_of(open, is_same) &&
           (is_usual_order(header, open, one) || is_usual_sequence(open, one) ||
            is_usual_vector(open, one) || is_order_of_qualisys(header, open, one));
  };
  std::optional<Reading> fitting;
  if (problem) fitting = fitting_one(recording, problem->inertia, open);
  constexpr double clearly = 1e-3;
  if (problem && !(fitting && *fitting->misfit.worst() < clearly)) {
    // Attitudes alone may follow a wrong law in an unusual order by chance.
    const auto lawful = lawful_one(recording, *problem, open);
    if (lawful && (has_rates(lawful->convention) || is_usual(*lawful))) fitting = lawful;
  }
  if (fitting && is_usual(*fitting)) return fitting->convention;
  if (problem && !fitting) fitting = unexpected(recording, *problem, open);
  if (const auto usual = fitting ? std::nullopt : usual_from_identity(recording, open))
    return *usual;
  if (const auto usual = fitting ? std::nullopt : in_seconds(open)) return *usual;
  throw ambiguous(header, open, fitting);
}

}  // namespace twrench::check
