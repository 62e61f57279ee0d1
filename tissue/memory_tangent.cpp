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

/// M' [Pa]. Infinite where nothing is strained if p < 2, where what it multiplies is 0.
double stiffening(const Solid& solid, const BranchModuli& moduli,
                  const BranchState& branch) {
  if (branch.hardening_strain <= 0) return 0;
  return (branch.stiffness - moduli.linear) * solid.shear.hardening_index /
         (2 * branch.hardening_strain);
}

/// The derivative by the entries of C of a number whose derivative is the tensor X.
SymmetricTensor by_entries(SymmetricTensor X) {
  X.tail<3>() *= 2;
  return X;
}

}  // namespace

PointTangent tangent_after(const Solid& solid, const MemoryStep& step,
                           std::span<const double> state, const SymmetricTensor& C) {
  const MaxwellModel& model = solid.shear;
  assert(state.size() == state_size(model.branches.size()));
  const Strain strain = strain_of(C);
  const double J = strain.J, r = solid.bulk_ratio;
  const SymmetricTensor& inverse_C = strain.inverse;
  const SymmetricTensor old_rest = unimodular(tensor(state, 0)),
                        new_rest = strain.dilation * inverse_C;
  Tangent strands = Tangent::Zero();
  SymmetricTensor volume = SymmetricTensor::Zero();
  double following = 0;  // sum f_i M_i
  const auto add = [&](const BranchModuli& moduli, const SymmetricTensor& A, double f) {
    const BranchState branch = branch_state(solid, moduli, A, strain);
    const double M = branch.stiffness, M1 = stiffening(solid, moduli, branch);
    const double mean_square_stretch = 1 + branch.invariant / 3;
    const SymmetricTensor strand = A / strain.dilation;
    const SymmetricTensor D = strand - mean_square_stretch * inverse_C;
    const SymmetricTensor Q = D + r * (J - 1) * J * inverse_C;
    strands += strand * by_entries(M1 * Q - M / 3 * inverse_C).transpose();
    volume += M1 * volume_share(solid, branch, strain) * Q +
              M * ((r * J + mean_square_stretch / J) / 2 * inverse_C - D / (3 * J));
    following += f * M;
  };
  add(model.elastic, identity(), 0);
  for (std::size_t i = 0; i < model.branches.size(); ++i)
    add(model.branches[i].moduli,
        after(step.decays[i], tensor(state, i + 1), old_rest, new_rest),
        step.decays[i].from_new);
  strands +=
      following / 3 * inverse_C * by_entries(inverse_C).transpose() -
      (following - model.viscosity / step.duration) * product_on_both_sides(inverse_C);
  return {strands, by_entries(volume)};
}

}  // namespace springcheck::tissue
