#pragma once

#include <vector>

#include "meshing/natural_modes.hpp"

namespace springcheck {

/// Modes of equal frequency: any mixture of their shapes is a mode too.
struct Multiplet {
  Eigen::Index first;  // in NaturalModes, from 0
  Eigen::Index count;
};

/// The modes in groups of frequencies equal to 1e-6, the last of which holds the mode of
/// number `up_to`, from 1. The modes must reach beyond it, or the last group may be cut.
std::vector<Multiplet> multiplets(const NaturalModes& modes, int up_to);

/// A multiplet's counterpart among another method's modes.
struct Counterpart {
  double frequency;  // mean of its modes' [Hz]
  double spread;     // their largest less their smallest [Hz]
  double mac;        // the least of its modes' in [0, 1]
};

/// Of each multiplet the other method's modes that look most like it, each mode taken
/// once, by the modal assurance criterion against all the multiplet's mixtures:
///
///     MAC(v) = |Q^T v|^2/|v|^2
///
/// Q an orthonormal basis of the multiplet's shapes, v a shape, both as nodal
/// displacements; for a single mode u, (u.v)^2/(u.u v.v).
/// Source: Allemang and Brown, Proc. 1st Int. Modal Analysis Conf. (1982) 110.
std::vector<Counterpart> counterparts(const NaturalModes& modes,
                                      const std::vector<Multiplet>& multiplets,
                                      const NaturalModes& others);

}  // namespace springcheck
