#include "tissue/memory.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <cassert>
#include <cmath>

#include "tissue/checks.hpp"
#include "tissue/memory_branches.hpp"

namespace springcheck::tissue {
namespace {

/// Adds what a branch has to its parts of S.
void add(const Solid& solid, const BranchModuli& moduli, const SymmetricTensor& A,
         const Strain& strain, PointStress& sum) {
  const BranchState branch = branch_state(solid, moduli, A, strain);
  sum.strands += branch.stiffness / strain.dilation * A;
  sum.volume += branch.stiffness * volume_share(solid, branch, strain);
}

/// `store` is given each branch's A after the step.
template <class Store>
PointStress stress_with(const Solid& solid, const MemoryStep& step,
                        std::span<const double> state, const Strain& strain,
                        Store store) {
  const MaxwellModel& model = solid.shear;
  assert(state.size() == state_size(model.branches.size()));
  assert(step.decays.size() == model.branches.size());
  const SymmetricTensor old_inverse = tensor(state, 0);
  const SymmetricTensor old_rest = unimodular(old_inverse),
                        new_rest = strain.dilation * strain.inverse;
  PointStress sum{-model.viscosity / step.duration * (strain.inverse - old_inverse), 0};
  add(solid, model.elastic, identity(), strain, sum);
  for (std::size_t i = 0; i < model.branches.size(); ++i) {
    const SymmetricTensor A =
        after(step.decays[i], tensor(state, i + 1), old_rest, new_rest);
    add(solid, model.branches[i].moduli, A, strain, sum);
    store(i, A);
  }
  return sum;
}

}  // namespace

void set_to_rest(std::span<double> state) {
  assert(state.size() % 6 == 0);
  for (std::size_t i = 0; i < state.size() / 6; ++i) tensor(state, i) = identity();
}

MemoryStep memory_step(const Solid& solid, double duration) {
  check(solid);
  check_positive("time step [s]", duration);
  MemoryStep step{duration, {}};
  for (const MaxwellBranch& branch : solid.shear.branches) {
    const double x = duration / branch.relaxation_time;
    // (1 - (1+x) exp(-x))/x, by P(2, x), which keeps its digits at small x.
    const double from_old = boost::math::gamma_p(2, x) / x;
    step.decays.push_back({std::exp(-x), from_old, -std::expm1(-x) - from_old});
  }
  return step;
}

MemoryStep short_memory_step(const Solid& solid, double duration) {
  MemoryStep step = memory_step(solid, duration);
  for (Decay& decay : step.decays) {
    decay.from_new += decay.from_old;
    decay.from_old = 0;
  }
  return step;
}

SymmetricTensor second_piola_kirchhoff(const PointStress& stress,
                                       const SymmetricTensor& C) {
  const Strain strain = strain_of(C);
  return stress.strands + strain.J * stress.volume * strain.inverse;
}

PointStress stress_after(const Solid& solid, const MemoryStep& step,
                         std::span<const double> state, const SymmetricTensor& C) {
  return stress_with(solid, step, state, strain_of(C),
                     [](std::size_t, const SymmetricTensor&) {});
}

PointStress stress_at(const Solid& solid, std::span<const double> state,
                      const SymmetricTensor& C, const SymmetricTensor& rate) {
  const MaxwellModel& model = solid.shear;
  assert(state.size() == state_size(model.branches.size()));
  const Strain strain = strain_of(C);
  const Eigen::Matrix3d B = matrix_of(strain.inverse);
  PointStress sum{model.viscosity * symmetric_tensor(B * matrix_of(rate) * B), 0};
  add(solid, model.elastic, identity(), strain, sum);
  for (std::size_t i = 0; i < model.branches.size(); ++i)
    add(solid, model.branches[i].moduli, tensor(state, i + 1), strain, sum);
  return sum;
}

PointStress advance(const Solid& solid, const MemoryStep& step, std::span<double> state,
                    const SymmetricTensor& C) {
  const Strain strain = strain_of(C);
  const PointStress stress = stress_with(
      solid, step, state, strain,
      [&](std::size_t i, const SymmetricTensor& A) { tensor(state, i + 1) = A; });
  tensor(state, 0) = strain.inverse;
  return stress;
}

void advance(const Solid& solid, const MemoryStep& step, std::span<double> states,
             std::span<const SymmetricTensor> C, std::span<PointStress> stresses) {
  const std::size_t size = state_size(solid.shear.branches.size());
  assert(states.size() == size * C.size() && stresses.size() == C.size());
  for (std::size_t point = 0; point < C.size(); ++point)
    stresses[point] = advance(solid, step, states.subspan(point * size, size), C[point]);
}

}  // namespace springcheck::tissue
