#include "tissue/memory.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <cassert>
#include <cmath>

#include "tissue/checks.hpp"
#include "tissue/memory_branches.hpp"

namespace springcheck::tissue {
namespace {

/// `store` is given each branch's A after the step.
template <class Store>
PointStress stress_with(const MaxwellModel& model, const MemoryStep& step,
                        std::span<const double> state, const SymmetricTensor& C,
                        const SymmetricTensor& inverse_C, Store store) {
  assert(state.size() == state_size(model.branches.size()));
  assert(step.decays.size() == model.branches.size());
  const double log_det_C = log_determinant(C);
  const SymmetricTensor old_inverse = tensor(state, 0);

  const double M_elastic =
      branch_state(model, model.elastic, identity(), C, log_det_C).stiffness;
  PointStress sum{M_elastic * identity() -
                      model.viscosity / step.duration * (inverse_C - old_inverse),
                  M_elastic};
  for (std::size_t i = 0; i < model.branches.size(); ++i) {
    const SymmetricTensor A =
        after(step.decays[i], tensor(state, i + 1), old_inverse, inverse_C);
    const double M =
        branch_state(model, model.branches[i].moduli, A, C, log_det_C).stiffness;
    sum.second_piola_kirchhoff += M * A;
    sum.stiffness_sum += M;
    store(i, A);
  }
  return sum;
}

}  // namespace

void set_to_rest(std::span<double> state) {
  assert(state.size() % 6 == 0);
  for (std::size_t i = 0; i < state.size() / 6; ++i) tensor(state, i) = identity();
}

MemoryStep memory_step(const MaxwellModel& model, double duration) {
  check(model);
  check_positive("time step [s]", duration);
  MemoryStep step{duration, {}};
  for (const MaxwellBranch& branch : model.branches) {
    const double x = duration / branch.relaxation_time;
    // (1 - (1+x) exp(-x))/x, by P(2, x), which keeps its digits at small x.
    const double from_old = boost::math::gamma_p(2, x) / x;
    step.decays.push_back({std::exp(-x), from_old, -std::expm1(-x) - from_old});
  }
  return step;
}

PointStress stress_after(const MaxwellModel& model, const MemoryStep& step,
                         std::span<const double> state, const SymmetricTensor& C) {
  return stress_with(model, step, state, C, inverse(C),
                     [](std::size_t, const SymmetricTensor&) {});
}

PointStress advance(const MaxwellModel& model, const MemoryStep& step,
                    std::span<double> state, const SymmetricTensor& C) {
  const SymmetricTensor inverse_C = inverse(C);
  const PointStress stress = stress_with(
      model, step, state, C, inverse_C,
      [&](std::size_t i, const SymmetricTensor& A) { tensor(state, i + 1) = A; });
  tensor(state, 0) = inverse_C;
  return stress;
}

void advance(const MaxwellModel& model, const MemoryStep& step, std::span<double> states,
             std::span<const SymmetricTensor> C, std::span<PointStress> stresses) {
  const std::size_t size = state_size(model.branches.size());
  assert(states.size() == size * C.size() && stresses.size() == C.size());
  for (std::size_t point = 0; point < C.size(); ++point)
    stresses[point] = advance(model, step, states.subspan(point * size, size), C[point]);
}

}  // namespace springcheck::tissue
