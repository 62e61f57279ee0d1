#include "mss/stability/uniaxial_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mss/forces/forces.hpp"
#include "mss/forces/tangent.hpp"

namespace springcheck::mss {
namespace {

constexpr double strain_step = 0.01;
constexpr double strain_tolerance = 1e-7;
// The round-off in parts of largest_modulus: waves without energy at rest (mss-nfd) have
// moduli of either sign there.
constexpr double round_off = 1e-10;

Matrix3 stretched(double lateral, double axial) {
  return Vector3(lateral, lateral, axial).asDiagonal();
}

/// Slope and curvature of the cell's energy over l [J], at F = diag(l, l, z).
struct LateralEnergy {
  double slope, curvature;
};
LateralEnergy lateral_energy(const Network& cell, double lateral, double axial) {
  std::vector<Vector3> positions, widening;
  for (const Vector3& X : cell.rest_positions) {
    positions.push_back(stretched(lateral, axial) * X);
    widening.emplace_back(X.x(), X.y(), 0);  // dx/dl
  }
  std::vector<Vector3> forces(positions.size());
  nodal_forces(cell, positions, forces);
  const auto stiffening = product(tangent_at(cell, positions), widening);
  LateralEnergy energy{.slope = 0, .curvature = 0};
  for (std::size_t a = 0; a < positions.size(); ++a) {
    energy.slope -= forces[a].dot(widening[a]);
    energy.curvature += stiffening[a].dot(widening[a]);
  }
  return energy;
}

/// The wave with 0 <= t_y <= t_x and 0 <= t_z among those that the state's mirror planes
/// make equal.
Vector3 named(const Vector3& phases) {
  const Vector3 t = phases.cwiseAbs();
  return {std::max(t.x(), t.y()), std::min(t.x(), t.y()), t.z()};
}

/// A state on the way, and what is lost in it.
struct Station {
  double strain, lateral;
  LatticeLoss loss;
  LatticeWave softest;
};

Station station(const Network& cell, UniaxialLoad load, double strain, double start) {
  const double axial = load == UniaxialLoad::compression ? 1 - strain : 1 + strain;
  Station here{.strain = strain,
               .lateral = start,
               .loss = LatticeLoss::lateral_minimum,
               .softest = {.phases = Vector3::Zero(), .modulus = 0}};
  const auto lateral = free_lateral_stretch(cell, axial, start);
  if (!lateral) return here;
  here.lateral = *lateral;
  const Couplings lattice = couplings(cell, stretched(*lateral, axial));
  here.softest = softest_wave(lattice);
  const bool is_lost = here.softest.modulus < -round_off * largest_modulus(lattice);
  here.loss = is_lost ? LatticeLoss::wave : LatticeLoss::none;
  return here;
}

}  // namespace

std::optional<double> free_lateral_stretch(const Network& cell, double axial_stretch,
                                           double start) {
  constexpr int most_iterations = 50;
  constexpr double tolerance = 1e-10;   // of the last step, which Newton squares
  constexpr double longest_step = 0.2;  // or it would leave the branch
  double lateral = start;
  for (int i = 0; i < most_iterations; ++i) {
    const auto [slope, curvature] = lateral_energy(cell, lateral, axial_stretch);
    const double step = -slope / curvature;
    if (!(curvature > 0) || std::abs(step) > longest_step) return std::nullopt;
    lateral += step;
    if (std::abs(step) < tolerance) return lateral;
  }
  return std::nullopt;
}

LatticeLimit uniaxial_limit(const Network& cell, UniaxialLoad load, double most_strain) {
  Station good = station(cell, load, 0, 1), lost = good;
  while (lost.loss == LatticeLoss::none) {
    if (good.strain >= most_strain)
      return {.loss = LatticeLoss::none, .strain = most_strain};
    const double next = std::min(good.strain + strain_step, most_strain);
    lost = station(cell, load, next, good.lateral);
    if (lost.loss == LatticeLoss::none) good = lost;
  }
  while (lost.strain - good.strain > strain_tolerance) {
    const Station middle =
        station(cell, load, (good.strain + lost.strain) / 2, good.lateral);
    (middle.loss == LatticeLoss::none ? good : lost) = middle;
  }
  LatticeLimit limit{.loss = lost.loss, .strain = lost.strain};
  if (lost.loss == LatticeLoss::wave)
    limit.wave = {.phases = named(lost.softest.phases), .modulus = lost.softest.modulus};
  return limit;
}

}  // namespace springcheck::mss
