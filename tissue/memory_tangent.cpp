#include <array>
#include <cassert>

#include "tissue/memory_branches.hpp"

namespace springcheck::tissue {
namespace {

using Tangent = Eigen::Matrix<double, 6, 6>;

/// H -> B H B, by the entries of H.
Tangent product_on_both_sides(const SymmetricTensor& b) {
  constexpr std::array<std::array<int, 2>, 6> places{
      {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
  const Eigen::Matrix3d B = matrix_of(b);
  Tangent product;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      const auto [a, d] = places[static_cast<std::size_t>(i)];
      const auto [k, l] = places[static_cast<std::size_t>(j)];
      product(i, j) = B(a, k) * B(l, d);
      if (k != l) product(i, j) += B(a, l) * B(k, d);
    }
  return product;
}

/// dM/dI [Pa]. Infinite at I = 0 if p < 2, where what it multiplies is 0.
double stiffening(const MaxwellModel& model, const BranchModuli& moduli,
                  const BranchState& branch) {
  if (branch.invariant <= 0) return 0;
  return (branch.stiffness - moduli.linear) * model.hardening_index /
         (2 * branch.invariant);
}

/// The derivative by the entries of C of a number whose derivative is the tensor X.
SymmetricTensor by_entries(SymmetricTensor X) {
  X.tail<3>() *= 2;
  return X;
}

}  // namespace

PointTangent tangent_after(const MaxwellModel& model, const MemoryStep& step,
                           std::span<const double> state, const SymmetricTensor& C) {
  assert(state.size() == state_size(model.branches.size()));
  const SymmetricTensor inverse_C = inverse(C), old_inverse = tensor(state, 0);
  const double log_det_C = log_determinant(C);
  PointTangent tangent{Tangent::Zero(), SymmetricTensor::Zero()};
  double following = -model.viscosity / step.duration;  // sum f_i M_i - eta/dt
  const auto add = [&](const BranchModuli& moduli, const SymmetricTensor& A, double f) {
    const BranchState branch = branch_state(model, moduli, A, C, log_det_C);
    const SymmetricTensor dM =
        stiffening(model, moduli, branch) * by_entries(A - (1 + f) * inverse_C);
    tangent.stress += A * dM.transpose();
    tangent.stiffness_sum += dM;
    following += f * branch.stiffness;
  };
  add(model.elastic, identity(), 0);
  for (std::size_t i = 0; i < model.branches.size(); ++i)
    add(model.branches[i].moduli,
        after(step.decays[i], tensor(state, i + 1), old_inverse, inverse_C),
        step.decays[i].from_new);
  tangent.stress -= following * product_on_both_sides(inverse_C);
  return tangent;
}

}  // namespace springcheck::tissue
