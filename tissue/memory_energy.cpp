#include "tissue/memory_energy.hpp"

#include <cassert>

#include "tissue/memory_branches.hpp"

namespace springcheck::tissue {
namespace {

/// W, the integral of M.
double stored(const Solid& solid, const BranchModuli& moduli, const BranchState& branch) {
  const double hardening = branch.stiffness - moduli.linear;
  return branch.hardening_strain *
         (moduli.linear + hardening / (solid.shear.hardening_index / 2 + 1));
}

}  // namespace

double free_energy(const Solid& solid, std::span<const double> state,
                   const SymmetricTensor& C) {
  const MaxwellModel& model = solid.shear;
  assert(state.size() == state_size(model.branches.size()));
  const Strain strain = strain_of(C);
  const auto stored_with = [&](const BranchModuli& moduli, const SymmetricTensor& A) {
    return stored(solid, moduli, branch_state(solid, moduli, A, strain));
  };
  double twice = stored_with(model.elastic, identity());
  for (std::size_t i = 0; i < model.branches.size(); ++i)
    twice += stored_with(model.branches[i].moduli, tensor(state, i + 1));
  return twice / 2;
}

double dissipation(const Solid& solid, const MemoryStep& step,
                   std::span<const double> before, std::span<const double> after) {
  const MaxwellModel& model = solid.shear;
  assert(before.size() == state_size(model.branches.size()));
  assert(after.size() == before.size());
  const SymmetricTensor old_inverse = tensor(before, 0), inverse_C = tensor(after, 0);
  const Strain strain = strain_of(inverse(inverse_C));
  double twice = -model.viscosity / (step.duration * step.duration) *
                 contraction(inverse_C - old_inverse, strain.C - inverse(old_inverse));
  for (std::size_t i = 0; i < model.branches.size(); ++i) {
    const auto& [tau, moduli] = model.branches[i];
    const BranchState branch = branch_state(solid, moduli, tensor(after, i + 1), strain);
    twice += branch.stiffness * branch.invariant / tau;
  }
  return twice / 2;
}

}  // namespace springcheck::tissue
