#include "fem_reference/tissue/tissue_cell.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fem_reference/cells/cell_stiffness.hpp"
#include "fem_reference/laws/dilatation.hpp"
#include "fem_reference/tissue/tissue_point.hpp"
#include "tissue/memory_energy.hpp"

namespace springcheck::fem_reference {
namespace {

using Eigen::Index;

Matrix3 deformation_gradient(const Shape& shape, const CellVectors& u, Index point) {
  return Matrix3::Identity() + displacement_gradient(shape, u, point);
}

/// Jm, and c = dJm/du.
struct MeanJacobian {
  double value;
  CellVectors gradient;
};

MeanJacobian mean_jacobian(const Shape& shape, const CellVectors& u) {
  MeanJacobian mean{.value = 1, .gradient = CellVectors::Zero(3, u.cols())};
  for (Index q = 0; q < shape.weights.size(); ++q) {
    const Dilatation t = volume_change(displacement_gradient(shape, u, q));
    const double part = shape.weights[q] / shape.volume;
    mean.value += part * t.value;
    mean.gradient += part * t.first * shape.gradients_at(q);
  }
  return mean;
}

template <class Number>
std::span<Number> state_at(std::span<Number> states, const Shape& shape, Index point) {
  const std::size_t size = states.size() / static_cast<std::size_t>(shape.weights.size());
  return states.subspan(static_cast<std::size_t>(point) * size, size);
}

}  // namespace

TissueCellForces forces_after(const TissueCell& cell, const CellVectors& u) {
  const auto& [solid, step, shape, states] = cell;
  TissueCellForces sum{.forces = CellVectors::Zero(3, u.cols()),
                       .strand_square = 0,
                       .smallest_jacobian = std::numeric_limits<double>::infinity()};
  CellVectors strands = CellVectors::Zero(3, u.cols());
  const MeanJacobian mean = mean_jacobian(shape, u);
  // No law reaches an inverted cell; the residual says that it is none.
  if (!(mean.value > 0)) {
    sum.forces.setConstant(std::numeric_limits<double>::quiet_NaN());
    return sum;
  }
  double pressure = 0;
  for (Index q = 0; q < shape.weights.size(); ++q) {
    const Matrix3 F = deformation_gradient(shape, u, q);
    sum.smallest_jacobian = std::min(sum.smallest_jacobian, F.determinant());
    if (!(F.determinant() > 0)) {
      sum.forces.setConstant(std::numeric_limits<double>::quiet_NaN());
      return sum;
    }
    const TissuePointStress stress =
        stress_after(solid, step, state_at(states, shape, q), F, mean.value);
    const double w = shape.weights[q];
    sum.forces += w * F * tissue::matrix_of(stress.shape) * shape.gradients_at(q);
    strands += w * F * tissue::matrix_of(stress.strands) * shape.gradients_at(q);
    pressure += w * stress.pressure;
  }
  sum.forces += pressure * mean.gradient;
  sum.strand_square = strands.squaredNorm();
  return sum;
}

CellMatrix tangent_after(const TissueCell& cell, const CellVectors& u) {
  const auto& [solid, step, shape, states] = cell;
  const MeanJacobian mean = mean_jacobian(shape, u);
  CellMatrix K = CellMatrix::Zero(3 * u.cols(), 3 * u.cols());
  CellVectors g = CellVectors::Zero(3, u.cols());
  double pressure = 0, by_jacobian = 0;
  for (Index q = 0; q < shape.weights.size(); ++q) {
    const Matrix3 F = deformation_gradient(shape, u, q);
    const auto state = state_at(states, shape, q);
    const TissuePointTangent tangent = tangent_after(solid, step, state, F, mean.value);
    const double w = shape.weights[q];
    const Matrix9 A = (tangent.by_gradient + tangent.by_gradient.transpose()) / 2;
    add_stiffness(K, w * A, shape.gradients_at(q));
    g += w * tangent.mixed * shape.gradients_at(q);
    by_jacobian += w * tangent.pressure_by_jacobian;
    pressure += w * stress_after(solid, step, state, F, mean.value).pressure;
  }
  for (Index q = 0; q < shape.weights.size(); ++q) {
    const Dilatation t = volume_change(displacement_gradient(shape, u, q));
    add_stiffness(K, pressure * shape.weights[q] / shape.volume * t.second,
                  shape.gradients_at(q));
  }
  const auto& c = mean.gradient;
  K += g.reshaped() * c.reshaped().transpose() + c.reshaped() * g.reshaped().transpose() +
       by_jacobian * c.reshaped() * c.reshaped().transpose();
  return K;
}

void advance(const tissue::Solid& solid, const tissue::MemoryStep& step,
             const Shape& shape, std::span<double> states, const CellVectors& u) {
  const MeanJacobian mean = mean_jacobian(shape, u);
  for (Index q = 0; q < shape.weights.size(); ++q)
    tissue::advance(solid, step, state_at(states, shape, q),
                    with_volume(deformation_gradient(shape, u, q), mean.value));
}

double free_energy(const tissue::Solid& solid, const Shape& shape,
                   std::span<const double> states, const CellVectors& u) {
  const MeanJacobian mean = mean_jacobian(shape, u);
  double energy = 0;
  for (Index q = 0; q < shape.weights.size(); ++q)
    energy +=
        shape.weights[q] *
        tissue::free_energy(solid, state_at(states, shape, q),
                            with_volume(deformation_gradient(shape, u, q), mean.value));
  return energy;
}

double largest_shear_strain(const Shape& shape, const CellVectors& u) {
  double largest = 0;
  for (Index q = 0; q < shape.weights.size(); ++q) {
    const Matrix3 F = deformation_gradient(shape, u, q);
    const double square = F.squaredNorm() / std::pow(F.determinant(), 2. / 3) - 3;
    largest = std::max(largest, std::sqrt(std::max(square, 0.)));
  }
  return largest;
}

}  // namespace springcheck::fem_reference
