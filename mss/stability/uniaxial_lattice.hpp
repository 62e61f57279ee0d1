#pragma once

#include <optional>

#include "mss/stability/infinite_lattice.hpp"

namespace springcheck::mss {

/// The lateral stretch l of the lattice stretched by z along an axis of its own, sides
/// free: F = diag(l, l, z) with
///
///     P_xx + P_yy = 0,   P = -(1/h^3) sum over the cell's corners of f_a (x) X_a
///
/// by Newton's method from `start`, which finds the branch that goes on from there.
/// Nothing where it finds none, or none that is a minimum over l: the lattice has lost
/// its lateral minimum.
std::optional<double> free_lateral_stretch(const Network& cell, double axial_stretch,
                                           double start);

enum class UniaxialLoad { compression, tension };

/// What the homogeneous state of the infinite lattice ends with.
enum class LatticeLoss {
  wave,             // a plane wave of negative modulus
  lateral_minimum,  // no lateral stretch at which the sides are free: a limit point
  none              // nothing up to the largest strain looked at
};

struct LatticeLimit {
  LatticeLoss loss;
  double strain;  // [-] of the height, positive: the first of the loss
  std::optional<LatticeWave> wave{};  // of LatticeLoss::wave: the softest there
};

/// The first loss of stability of the infinite lattice under uniaxial stress along an
/// axis of its own: F = diag(l, l, 1 -+ strain), l = free_lateral_stretch followed from
/// rest. Looked for in steps of 1 % and bisected to 1e-7; a loss that heals within a step
/// is not seen, and loss at rest has the strain 0. Of equal waves the one with
/// 0 <= t_y <= t_x and 0 <= t_z is named.
///
/// An upper bound for a block with the same homogeneous state and no plates: its surface
/// may wrinkle, and the whole may buckle, before the inside fails.
/// most_strain: 0 < most_strain < 1 in compression.
LatticeLimit uniaxial_limit(const Network& cell, UniaxialLoad load, double most_strain);

}  // namespace springcheck::mss
