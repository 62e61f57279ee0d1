#pragma once

#include <span>
#include <vector>

#include "statics/systems/natural_modes.hpp"

namespace springcheck {

/// Modes of equal frequency: any mixture of their shapes is a mode too.
struct Multiplet {
  Eigen::Index first;  // in NaturalModes, from 0
  Eigen::Index count;
};

/// The modes in groups of frequencies equal to 1e-6.
std::vector<Multiplet> multiplets(const NaturalModes& modes);

/// A multiplet's counterpart among another method's modes.
struct Counterpart {
  double frequency;  // mean of its modes' [Hz]
  double mac;        // the least of its modes' in [0, 1]
};

/// The counterpart of each multiplet: those of the other method's modes that look most
/// like it, each taken once, by the modal assurance criterion of single modes,
/// (u.v)^2/(u.u v.v), generalised to mixtures on both sides. With Q and R orthonormal
/// bases of a multiplet's shapes and of the others', as nodal displacements, it is
///
///     MAC = squares of the singular values of Q^T R,
///
/// the squared cosines of the angles between the two spaces.
/// Source: Allemang and Brown, Proc. 1st Int. Modal Analysis Conf. (1982) 110; Golub and
/// Van Loan, Matrix Computations (1996), section 12.4.3.
std::vector<Counterpart> counterparts(const NaturalModes& modes,
                                      std::span<const Multiplet> multiplets,
                                      const NaturalModes& others);

/// Frequencies of the other method's modes up to a highest one [Hz] that less than half
/// belong to the space of all the modes: |Q^T v|^2 < |v|^2/2.
std::vector<double> strangers(const NaturalModes& modes, const NaturalModes& others,
                              double highest);

}  // namespace springcheck
