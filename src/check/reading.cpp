#include "check/reading.h"

#include <algorithm>
#include <limits>

#include "check/thinned_rows.h"

namespace twrench::check {
namespace {

using Eigen::Matrix3d;

Angle other(Angle unit) { return unit == Angle::radians ? Angle::degrees : Angle::radians; }

Reading reading_of(const std::vector<Row>& rows, const Matrix3d& inertia,
                   const Convention& convention) {
  return {convention,
          {0, 1, 2},
          misfit(inertia, rows, has_rates(convention),
                 attitude_form(convention) != AttitudeForm::none)};
}

/// A reading that no row allows.
Reading impossible(const Convention& convention) {
  const double infinite = std::numeric_limits<double>::infinity();
  return {convention, {0, 1, 2}, {infinite, infinite}};
}

/// Adds to the list each of its conventions once more, changed.
template <typename Change>
void also(std::vector<Convention>& list, const Change& change) {
  const std::size_t count = list.size();
  for (std::size_t i = 0; i < count; ++i) {
    Convention changed = list[i];
    change(changed);
    list.push_back(std::move(changed));
  }
}

/// The columns of (w, x, y, z) taken for those of (x, y, z, w).
void scalar_first_to_last(Convention& convention) {
  auto& columns = convention.columns;
  const std::string first = columns["qw"];
  columns["qw"] = columns["qz"];
  columns["qz"] = columns["qy"];
  columns["qy"] = columns["qx"];
  columns["qx"] = first;
}

void scalar_last_to_first(Convention& convention) {
  for (int i = 0; i < 3; ++i) scalar_first_to_last(convention);
}

void add_quaternion_orders(std::vector<Convention>& list) {
  const std::vector<Convention> as_given = list;
  for (const auto& reorder : {scalar_first_to_last, scalar_last_to_first}) {
    for (Convention changed : as_given) {
      reorder(changed);
      list.push_back(std::move(changed));
    }
  }
}

void add_sequences(std::vector<Convention>& list) {
  const std::vector<Convention> as_given = list;
  for (const char* sequence : {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"}) {
    for (Convention changed : as_given) {
      if (changed.sequence == sequence) continue;
      changed.sequence = sequence;
      list.push_back(std::move(changed));
    }
  }
}

/// Adds the other orders of moments that differ.
void add_moment_orders(std::vector<Reading>& all, const std::filesystem::path& file,
                       const Eigen::Vector3d& moments, const Convention& convention) {
  const std::vector<Row> rows = telling_rows(file, convention);
  std::vector<Eigen::Vector3d> tried{moments};
  std::array<int, 3> order{0, 1, 2};
  while (std::ranges::next_permutation(order).found) {
    const Eigen::Vector3d swapped(moments[order[0]], moments[order[1]], moments[order[2]]);
    if (std::ranges::find(tried, swapped) != tried.end()) continue;
    tried.push_back(swapped);
    Reading reading = reading_of(rows, swapped.asDiagonal(), convention);
    reading.moment_order = order;
    all.push_back(reading);
  }
}

}  // namespace

std::vector<Reading> readings(const std::filesystem::path& file, const Matrix3d& inertia,
                              std::span<const Convention> conventions) {
  std::vector<Reading> all;
  for (const Convention& convention : conventions) {
    try {
      all.push_back(reading_of(telling_rows(file, convention), inertia, convention));
    } catch (const table::BadTable&) {
      all.push_back(impossible(convention));
    }
  }
  return all;
}

std::optional<Reading> only_fitting(std::vector<Reading> readings) {
  const auto worst = [](const Reading& reading) { return reading.misfit.worst().value_or(0); };
  std::ranges::sort(readings, {}, worst);
  if (readings.empty() || !readings[0].misfit.worst() || !readings[0].misfit.fits()) return {};
  if (readings.size() == 1) return readings[0];
  constexpr double far_worse = 5, contradicts = 1e-3;
  if (worst(readings[1]) < std::max(far_worse * worst(readings[0]), contradicts)) return {};
  return readings[0];
}

std::vector<Convention> variants(const Convention& convention) {
  std::vector<Convention> list{convention};
  const AttitudeForm form = attitude_form(convention);
  if (form == AttitudeForm::quaternion) add_quaternion_orders(list);
  if (form == AttitudeForm::euler) add_sequences(list);
  if (has_rates(convention) || form == AttitudeForm::euler) {
    also(list, [](Convention& c) { c.unit = other(c.unit.value_or(Angle::radians)); });
  }
  if (form != AttitudeForm::none) also(list, [](Convention& c) { c.inverse = !c.inverse; });
  if (form != AttitudeForm::none && has_rates(convention)) {
    also(list, [](Convention& c) { c.rates_in_space = !c.rates_in_space; });
  }
  list.erase(list.begin());
  return list;
}

std::optional<Reading> fitting_variant(const std::filesystem::path& file, const Matrix3d& inertia,
                                       const Convention& convention) {
  std::vector<Reading> all = readings(file, inertia, variants(convention));
  if (inertia.isDiagonal(0)) add_moment_orders(all, file, inertia.diagonal(), convention);
  return only_fitting(std::move(all));
}

}  // namespace twrench::check
