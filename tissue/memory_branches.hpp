#pragma once

#include <algorithm>
#include <cassert>
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

/// I and M of a branch. `I` is as it comes, and counts for M where it is positive.
struct BranchState {
  double invariant, stiffness;
};

inline BranchState branch_state(const MaxwellModel& model, const BranchModuli& moduli,
                                const SymmetricTensor& A, const SymmetricTensor& C,
                                double log_det_C) {
  const double I = contraction(C, A) - 3 - log_det_C;
  return {I, branch_stiffness(moduli, std::max(I, 0.), model.linear_limit,
                              model.hardening_index)};
}

inline SymmetricTensor after(const Decay& decay, const SymmetricTensor& A,
                             const SymmetricTensor& old_inverse,
                             const SymmetricTensor& new_inverse) {
  return decay.kept * A + decay.from_old * old_inverse + decay.from_new * new_inverse;
}

inline double log_determinant(const SymmetricTensor& C) {
  const double det = determinant(C);
  assert(det > 0);
  return std::log(det);
}

}  // namespace springcheck::tissue
