#include "tissue/memory_energy.hpp"

#include <cassert>

#include "tissue/memory_branches.hpp"

namespace springcheck::tissue {
namespace {

/// W(I), the integral of M.
double stored(const MaxwellModel& model, const BranchModuli& moduli,
              const BranchState& branch) {
  const double hardening = branch.stiffness - moduli.linear;
  return branch.invariant * (moduli.linear + hardening / (model.hardening_index / 2 + 1));
}

}  // namespace

double free_energy(const MaxwellModel& model, std::span<const double> state,
                   const SymmetricTensor& C) {
  assert(state.size() == state_size(model.branches.size()));
  const double log_det_C = log_determinant(C);
  const auto stored_with = [&](const BranchModuli& moduli, const SymmetricTensor& A) {
    return stored(model, moduli, branch_state(model, moduli, A, C, log_det_C));
  };
  double twice = stored_with(model.elastic, identity());
  for (std::size_t i = 0; i < model.branches.size(); ++i) {
    const SymmetricTensor A = tensor(state, i + 1);
    const BranchModuli& moduli = model.branches[i].moduli;
    twice += stored_with(moduli, A) - moduli.linear * log_determinant(A);
  }
  return twice / 2;
}

double dissipation(const MaxwellModel& model, const MemoryStep& step,
                   std::span<const double> before, std::span<const double> after) {
  assert(before.size() == state_size(model.branches.size()));
  assert(after.size() == before.size());
  const SymmetricTensor old_inverse = tensor(before, 0), inverse_C = tensor(after, 0);
  const SymmetricTensor C = inverse(inverse_C);
  const double log_det_C = log_determinant(C);
  double twice = -model.viscosity / (step.duration * step.duration) *
                 contraction(inverse_C - old_inverse, C - inverse(old_inverse));
  for (std::size_t i = 0; i < model.branches.size(); ++i) {
    const SymmetricTensor A = tensor(after, i + 1);
    const auto& [tau, moduli] = model.branches[i];
    const double M = branch_state(model, moduli, A, C, log_det_C).stiffness;
    twice += (M * (contraction(C, A) - 3) +
              moduli.linear * (contraction(inverse_C, inverse(A)) - 3)) /
             tau;
  }
  return twice / 2;
}

}  // namespace springcheck::tissue
