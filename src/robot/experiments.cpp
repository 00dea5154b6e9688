#include "robot/experiments.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace twrench::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// kg/m^3; osmium has 22,590.
constexpr double densest = 25000.0;
constexpr double water = 1000.0;

/// The matrix with other entries at the place of each: entry i becomes entry `order[i]`.
Inertial with_entries(Inertial inertial, const std::array<Entry, 6>& order) {
  const std::array<Written, 6> entries = inertial.entries;
  for (std::size_t i = 0; i < order.size(); ++i) inertial.entries[i] = entries[order[i]];
  return inertial;
}

/// The inertia of a point mass: the parallel-axis term.
Matrix3d of_point(double mass, const Vector3d& r) {
  return mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
}

/// Mass properties without a supposed mistake.
struct Trial {
  Fault fault;
  std::string text;
  LinkMass undone;
};

/// Collects the trials of a link.
class Trials {
 public:
  Trials(const Inertial& inertial, const LinkMass& stated) : inertial_(inertial), stated_(stated) {}

  std::vector<Trial> of_matrix();
  std::vector<Trial> of_scale(const MassModel& model);

 private:
  void add(Fault fault, std::string text, const Matrix3d& inertia) {
    trials_.push_back({fault, std::move(text), {stated_.mass, stated_.centre, inertia}});
  }
  void add_signs();
  void add_orders();
  void add_centres();
  void add_frames();
  void add_units();
  void add_densities(const MassModel& model);
  /// Supposes that the moments were multiplied by a factor.
  void add_factor(Fault fault, const std::string& text, double factor) {
    if (std::abs(std::log(factor)) > 0.05) add(fault, text, stated_.inertia / factor);
  }

  const Inertial& inertial_;
  const LinkMass& stated_;
  std::vector<Trial> trials_;
};

void Trials::add_signs() {
  constexpr std::array products{xy, xz, yz};
  for (const int changed : {7, 1, 2, 4, 3, 5, 6}) {  // all of them first
    Inertial other = inertial_;
    std::string names;
    bool differs = false;
    for (std::size_t i = 0; i < products.size(); ++i) {
      if ((changed >> i & 1) == 0) continue;
      double& value = other.entries[products[i]].value;
      differs = differs || value != 0.0;
      value = -value;
      names += fmt::format("{}{}", names.empty() ? "" : " and ", entry_names[products[i]]);
    }
    if (!differs) continue;
    add(Fault::products_sign,
        changed == 7 ? "the products of inertia have the other sign"
                     : fmt::format("the product {} has the other sign", names),
        other.inertia());
  }
}

void Trials::add_orders() {
  struct Order {
    const char* text;
    std::array<Entry, 6> entries;  ///< the entry that was written at the place of xx, yy, ...
  };
  constexpr std::array orders{
      Order{"the entries are in the order of the lower triangle: xx, xy, yy, xz, yz, zz",
            {xx, xz, zz, xy, yy, yz}},
      Order{"the entries are in the order xx, yy, zz, xy, xz, yz", {xx, xy, xz, yy, yz, zz}},
      Order{"the products xy and yz are exchanged", {xx, yy, zz, yz, xz, xy}},
      Order{"the products xy and xz are exchanged", {xx, yy, zz, xz, xy, yz}},
      Order{"the products xz and yz are exchanged", {xx, yy, zz, xy, yz, xz}},
      Order{"the products are in the order xz, yz, xy", {xx, yy, zz, xz, yz, xy}},
      Order{"the products are in the order yz, xy, xz", {xx, yy, zz, yz, xy, xz}},
      Order{"the moments xx and yy are exchanged", {yy, xx, zz, xy, xz, yz}},
      Order{"the moments xx and zz are exchanged", {zz, yy, xx, xy, xz, yz}},
      Order{"the moments yy and zz are exchanged", {xx, zz, yy, xy, xz, yz}},
      Order{"the moments are in the order yy, zz, xx", {zz, xx, yy, xy, xz, yz}},
      Order{"the moments are in the order zz, xx, yy", {yy, zz, xx, xy, xz, yz}}};
  for (const Order& order : orders)
    add(Fault::entries_order, order.text, with_entries(inertial_, order.entries).inertia());
}

void Trials::add_centres() {
  const Matrix3d shift = of_point(stated_.mass, stated_.centre);
  add(Fault::about_origin, "the moments are about the origin of the link, not the centre of mass",
      stated_.inertia - shift);
  add(Fault::shifted_twice,
      "the moments were moved to the centre of mass twice: the parallel-axis term was subtracted "
      "from moments that were about it",
      stated_.inertia + shift);
}

void Trials::add_frames() {
  const Matrix3d& rotation = inertial_.link_from_inertial;
  if (rotation.isIdentity(1e-12)) return;
  add(Fault::frame, "the matrix is in the axes of the link, though the inertial frame is rotated",
      inertial_.matrix());
  add(Fault::frame, "the rotation of the inertial frame is the inverse one",
      rotation.transpose() * inertial_.matrix() * rotation);
}

void Trials::add_units() {
  struct Unit {
    const char* text;
    int power;
  };
  constexpr std::array units{
      Unit{"the moments are 10^3 times too large, as in g m^2", 3},
      Unit{"the moments are 10^4 times too large, as in kg cm^2", 4},
      Unit{"the moments are 10^6 times too large, as in kg mm^2", 6},
      Unit{"the moments are 10^7 times too large, as in g cm^2", 7},
      Unit{"the moments are 10^9 times too large, as in g mm^2", 9},
      Unit{"the moments are 10^3 times too small, as if kg m^2 had been g m^2", -3},
      Unit{"the moments are 10^4 times too small, as if kg m^2 had been kg cm^2", -4},
      Unit{"the moments are 10^6 times too small, as if kg m^2 had been kg mm^2", -6},
      Unit{"the moments are 10^7 times too small, as if kg m^2 had been g cm^2", -7},
      Unit{"the moments are 10^9 times too small, as if kg m^2 had been g mm^2", -9}};
  for (const Unit& unit : units)
    add_factor(Fault::inertia_unit, unit.text, std::pow(10.0, unit.power));
  LinkMass lighter = stated_;
  lighter.mass /= 1000;
  trials_.push_back({Fault::mass_unit, "the mass is in g, but the moments are in kg m^2", lighter});
}

void Trials::add_densities(const MassModel& model) {
  const double mass = stated_.mass;
  add_factor(Fault::mass_twice, "the moments were multiplied by the mass twice", mass);
  add_factor(Fault::unit_mass, "the moments are those for a mass of 1 kg", 1 / mass);
  if (!model.volume) return;
  const double density = mass / *model.volume;
  add_factor(Fault::density_twice, "the moments were multiplied by the density twice", density);
  add_factor(Fault::unit_density, "the moments are those for a density of 1 kg/m^3", 1 / density);
  add_factor(Fault::unit_density, "the moments are those for a density of 1000 kg/m^3",
             water / density);
}

std::vector<Trial> Trials::of_matrix() {
  add_signs();
  add_orders();
  add_centres();
  add_frames();
  add_units();
  return std::move(trials_);
}

std::vector<Trial> Trials::of_scale(const MassModel& model) {
  add_densities(model);
  return std::move(trials_);
}

double difference(const Matrix3d& a, const Matrix3d& b) {
  return (a - b).cwiseAbs().maxCoeff() / principal_moments(b)[2];
}

/// Keeps the best fit of each trial.
class Fits {
 public:
  Fits(const LinkMass& stated, double most) : stated_(stated), most_(most) {}

  void try_on(const MassModel& model, const Trial& trial) {
    const double misfit = misfit_of(trial.undone, model);
    // A trial that changes nothing cannot explain anything.
    const bool changes = trial.undone.mass != stated_.mass ||
                         difference(stated_.inertia, trial.undone.inertia) > most_;
    if (!(misfit <= most_) || !changes) return;
    const auto same = std::ranges::find(found_, trial.fault, &Finding::fault);
    if (same == found_.end()) {
      found_.push_back({trial.fault, trial.text, trial.undone, misfit, model.source});
    } else if (misfit < *same->misfit) {
      *same = {trial.fault, trial.text, trial.undone, misfit, model.source};
    }
  }

  /// Returns those that fit about as well as the best, beginning with that.
  std::vector<Finding> best() {
    if (found_.empty()) return {};
    std::ranges::stable_sort(found_, {}, [](const Finding& f) { return *f.misfit; });
    const double most = std::max(5 * *found_.front().misfit, 1e-4);
    std::erase_if(found_, [&](const Finding& f) { return *f.misfit > most; });
    return std::move(found_);
  }

 private:
  const LinkMass& stated_;
  double most_;
  std::vector<Finding> found_;
};

/// The moments of the geometry about other axes.
std::optional<Finding> other_axes(const LinkMass& stated, const MassModel& model, double most) {
  const Matrix3d expected = stated.mass * model.body.inertia;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(expected);
  const Vector3d moments = principal_moments(stated.inertia);
  const double misfit =
      (moments - solver.eigenvalues()).cwiseAbs().maxCoeff() / solver.eigenvalues()[2];
  if (!(misfit <= most)) return std::nullopt;
  LinkMass undone = stated;
  undone.inertia = solver.eigenvectors() * moments.asDiagonal() * solver.eigenvectors().transpose();
  return Finding{Fault::frame,
                 "the principal moments are right, but about other axes: the rotation of the "
                 "inertial frame is missing or another one",
                 undone, misfit, model.source};
}

/// A mass in g of which the moments follow has a density that no material has.
std::optional<Finding> mass_in_grams(const LinkMass& stated, const std::vector<MassModel>& models) {
  for (const MassModel& model : models) {
    if (!model.volume) continue;
    const double density = stated.mass / *model.volume;
    if (density < densest || density / 1000 > densest) return std::nullopt;
    LinkMass undone = stated;
    undone.mass /= 1000, undone.inertia /= 1000;
    return Finding{Fault::mass_unit,
                   fmt::format("the density would be {:.3g} kg/m^3, more than that of any "
                               "material: mass and moments are in g",
                               density),
                   undone, misfit_of(undone, model), model.source};
  }
  return std::nullopt;
}

/// The geometry of a link is often not its mass, but roughly so.
constexpr double rough = 0.25;

/// The mistakes without which impossible moments are possible and not far from a geometry, if there
/// is one.
std::vector<Finding> possible_again(const std::vector<Trial>& trials,
                                    const std::vector<MassModel>& models) {
  std::vector<Finding> found;
  for (const Trial& trial : trials) {
    const bool is_matrix = trial.fault == Fault::products_sign ||
                           trial.fault == Fault::entries_order ||
                           trial.fault == Fault::shifted_twice || trial.fault == Fault::frame;
    const bool is_near = models.empty() || std::ranges::any_of(models, [&](const auto& model) {
                           return misfit_of(trial.undone, model) < rough;
                         });
    if (!is_matrix || !is_near || !is_possible(trial.undone)) continue;
    if (std::ranges::find(found, trial.fault, &Finding::fault) != found.end()) continue;
    found.push_back({trial.fault, trial.text, trial.undone});
  }
  return found;
}

}  // namespace

double relative_resolution(const Inertial& inertial) {
  double greatest = 0.0, resolution = 0.0;
  for (const Written& entry : inertial.entries) {
    greatest = std::max(greatest, std::abs(entry.value));
    // A product of inertia that is written as "0" is exact.
    if (entry.value != 0.0) resolution = std::max(resolution, entry.resolution);
  }
  return greatest > 0.0 ? std::clamp(resolution / greatest, 1e-3, 0.02) : 1e-3;
}

double misfit_of(const LinkMass& body, const MassModel& model) {
  return difference(body.inertia, body.mass * model.body.inertia);
}

std::optional<Agreement> agreement(const Inertial& inertial, const std::vector<MassModel>& models) {
  const LinkMass stated = stated_mass(inertial);
  for (const MassModel& model : models) {
    const double misfit = misfit_of(stated, model);
    if (misfit <= relative_resolution(inertial)) return Agreement{model.source, misfit};
  }
  return std::nullopt;
}

std::vector<Finding> mistakes(const Inertial& inertial, const std::vector<MassModel>& models,
                              const Diagnosis& diagnosis) {
  const LinkMass& stated = diagnosis.body;
  if (diagnosis.agreement) {
    const auto finding = mass_in_grams(stated, models);
    return finding ? std::vector{*finding} : std::vector<Finding>();
  }
  if (!(stated.mass > 0.0) || stated.inertia.isZero(0.0)) return {};
  const double most = relative_resolution(inertial);
  const std::vector<Trial> trials = Trials(inertial, stated).of_matrix();
  Fits fits(stated, most);
  for (const MassModel& model : models) {
    for (const Trial& trial : trials) fits.try_on(model, trial);
    for (const Trial& trial : Trials(inertial, stated).of_scale(model)) fits.try_on(model, trial);
  }
  std::vector<Finding> found = fits.best();
  for (const MassModel& model : models) {
    if (!found.empty()) break;
    if (auto finding = other_axes(stated, model, most)) found.push_back(std::move(*finding));
  }
  if (found.empty() && diagnosis.verdict == Verdict::impossible)
    return possible_again(trials, models);
  return found;
}

}  // namespace twrench::robot
