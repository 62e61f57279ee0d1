#pragma once

#include <algorithm>
#include <cmath>

#include "tissue/memory.hpp"

namespace springcheck::tissue {

/// Entry `i` of a state: 0 is C^-1 of the last step, i > 0 is A_i.
inline Eigen::Map<const SymmetricTensor> tensor(std::span<const double> state,
                                                std::size_t i) {
  return Eigen::Map<const SymmetricTensor>(state.data() + 6 * i);
}
inline Eigen::Map<SymmetricTensor> tensor(std::span<double> state, std::size_t i) {
  return Eigen::Map<SymmetricTensor>(state.data() + 6 * i);
}

/// C and what follows from it.
struct Strain {
  SymmetricTensor C, inverse;
  double J;         // sqrt(det C)
  double dilation;  // J^(2/3): C' = C/dilation, C'^-1 = dilation C^-1
};

/// The strain of C. It is not finite where C is not positive definite, as in a motion
/// that blows up: its steps notice.
inline Strain strain_of(const SymmetricTensor& C) {
  const double det = determinant(C);
  return {C, adjugate(C) / det, std::sqrt(det), std::cbrt(det)};
}

/// C'^-1 of C^-1.
inline SymmetricTensor unimodular(const SymmetricTensor& inverse_C) {
  return inverse_C / std::cbrt(determinant(inverse_C));
}

/// I, what M is taken of, and M.
struct BranchState {
  double invariant, hardening_strain, stiffness;
};

inline BranchState branch_state(const Solid& solid, const BranchModuli& moduli,
                                const SymmetricTensor& A, const Strain& strain) {
  const double I = contraction(strain.C, A) / strain.dilation - 3;
  const double volume_part = solid.bulk_ratio * (strain.J - 1) * (strain.J - 1);
  const double squares = std::max(I, 0.) + volume_part;  // I < 0 is round-off
  return {I, squares,
          branch_stiffness(moduli, squares, solid.shear.linear_limit,
                           solid.shear.hardening_index)};
}

/// d psi/dJ over M, what a branch adds to the volume stress: r (J-1) - (1 + I/3)/J.
inline double volume_share(const Solid& solid, const BranchState& branch,
                           const Strain& strain) {
  return solid.bulk_ratio * (strain.J - 1) - (1 + branch.invariant / 3) / strain.J;
}

/// A after a step, the old and the new C'^-1 given.
inline SymmetricTensor after(const Decay& decay, const SymmetricTensor& A,
                             const SymmetricTensor& old_rest,
                             const SymmetricTensor& new_rest) {
  return decay.kept * A + decay.from_old * old_rest + decay.from_new * new_rest;
}

}  // namespace springcheck::tissue
