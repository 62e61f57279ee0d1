#include "fem_reference/cells/cell.hpp"

#include <algorithm>
#include <limits>

#include "fem_reference/cells/cell_stiffness.hpp"

namespace springcheck::fem_reference {
namespace {

template <class Law>
double mean_of_points(const Law& law, const Shape& shape, const CellVectors& u) {
  double integral = 0;
  for (Eigen::Index q = 0; q < shape.weights.size(); ++q)
    integral +=
        shape.weights[q] * law.dilatation(displacement_gradient(shape, u, q)).value;
  return integral / shape.volume;
}

/// U of the whole cell's dilatation; nothing where it is taken at the points.
template <class Law>
VolumetricEnergy of_whole_cell(const Law& law, DilatationTaken taken, const Shape& shape,
                               const CellVectors& u,
                               const FromNodalPatches& nodal_patches) {
  switch (taken) {
    case DilatationTaken::cell_mean:
      return law.volumetric_energy(mean_of_points(law, shape, u));
    case DilatationTaken::of_mean_gradient:
      return law.volumetric_energy(
          law.dilatation(displacement_gradient(shape, u, shape.weights.size())).value);
    case DilatationTaken::patch_mean:  // the energy is the nodal patches' own
      return {.value = 0, .first = nodal_patches.pressure, .second = 0};
    case DilatationTaken::at_points:
      break;
  }
  return {.value = 0, .first = 0, .second = 0};
}

/// Whether each point takes part in the whole cell's dilatation.
bool is_mean_of_points(DilatationTaken taken) {
  return taken == DilatationTaken::cell_mean || taken == DilatationTaken::patch_mean;
}

template <class Law>
CellState state(const Law& law, DilatationTaken taken, const Shape& shape,
                const CellVectors& u, const FromNodalPatches& nodal_patches) {
  const VolumetricEnergy whole = of_whole_cell(law, taken, shape, u, nodal_patches);
  CellState sum{.energy = 0,
                .forces = CellVectors::Zero(3, u.cols()),
                .smallest_jacobian = std::numeric_limits<double>::infinity()};
  for (Eigen::Index q = 0; q < shape.weights.size(); ++q) {
    const Matrix3 H = displacement_gradient(shape, u, q);
    const double w = shape.weights[q];
    const ShapeState shape_part = shape_state(law, H);
    double psi = nodal_patches.own_part * shape_part.energy;
    Matrix3 P = nodal_patches.own_part * shape_part.stress + nodal_patches.stress;
    if (taken == DilatationTaken::at_points) {
      const Dilatation t = law.dilatation(H);
      const VolumetricEnergy U = law.volumetric_energy(t.value);
      psi += U.value;
      P += U.first * t.first;
    } else if (is_mean_of_points(taken)) {
      P += whole.first * law.dilatation(H).first;
    }
    sum.energy += w * psi;
    sum.forces += w * P * shape.gradients_at(q);
    sum.smallest_jacobian =
        std::min(sum.smallest_jacobian, (H + Matrix3::Identity()).determinant());
  }
  if (taken == DilatationTaken::at_points) return sum;
  sum.energy += shape.volume * whole.value;
  if (taken == DilatationTaken::of_mean_gradient) {
    const Matrix3 H = displacement_gradient(shape, u, shape.weights.size());
    sum.forces +=
        shape.volume * whole.first * law.dilatation(H).first * shape.mean_gradients();
  }
  return sum;
}

template <class Law>
CellMatrix stiffness(const Law& law, DilatationTaken taken, const Shape& shape,
                     const CellVectors& u, const FromNodalPatches& nodal_patches) {
  const VolumetricEnergy whole = of_whole_cell(law, taken, shape, u, nodal_patches);
  CellVectors c = CellVectors::Zero(3, u.cols());  // V dt/du
  CellMatrix K = CellMatrix::Zero(3 * u.cols(), 3 * u.cols());
  for (Eigen::Index q = 0; q < shape.weights.size(); ++q) {
    const Matrix3 H = displacement_gradient(shape, u, q);
    const double w = shape.weights[q];
    Matrix9 A = nodal_patches.own_part * law.tangent(H);
    if (taken != DilatationTaken::of_mean_gradient) {
      const Dilatation t = law.dilatation(H);
      if (is_mean_of_points(taken)) {
        A += whole.first * t.second;
        c += w * t.first * shape.gradients_at(q);
      } else {
        const VolumetricEnergy U = law.volumetric_energy(t.value);
        A += U.first * t.second +
             U.second * t.first.reshaped() * t.first.reshaped().transpose();
      }
    }
    add_stiffness(K, w * A, shape.gradients_at(q));
  }
  if (taken == DilatationTaken::at_points || taken == DilatationTaken::patch_mean)
    return K;
  if (taken == DilatationTaken::of_mean_gradient) {
    const Dilatation t =
        law.dilatation(displacement_gradient(shape, u, shape.weights.size()));
    c = shape.volume * t.first * shape.mean_gradients();
    add_stiffness(K, shape.volume * whole.first * t.second, shape.mean_gradients());
  }
  K += whole.second / shape.volume * c.reshaped() * c.reshaped().transpose();
  return K;
}

}  // namespace

DilatationTaken dilatation_taken(const Settings& settings) {
  if (settings.element == Element::q1_nodal) return DilatationTaken::patch_mean;
  if (settings.element != Element::q1_sri) return DilatationTaken::at_points;
  const bool has_shape_part_apart =  // as with the other laws
      settings.law != Law::cauchy_born ||
      settings.lattice.strain == SpringStrain::green ||
      (settings.lattice.strain == SpringStrain::hencky &&
       settings.lattice.springs == Springs::affine);
  return has_shape_part_apart ? DilatationTaken::cell_mean
                              : DilatationTaken::of_mean_gradient;
}

CellState cell_state(const CellLaw& law, const Shape& shape, const CellVectors& u,
                     const FromNodalPatches& nodal_patches) {
  return std::visit(
      [&](const auto& part) {
        return state(part, law.dilatation, shape, u, nodal_patches);
      },
      law.constitution);
}

Dilatation dilatation(const CellLaw& law, const Matrix3& displacement_gradient) {
  return std::visit(
      [&](const auto& part) { return part.dilatation(displacement_gradient); },
      law.constitution);
}

double mean_dilatation(const CellLaw& law, const Shape& shape, const CellVectors& u) {
  return std::visit([&](const auto& part) { return mean_of_points(part, shape, u); },
                    law.constitution);
}

CellVectors integrated_dilatation_gradient(const CellLaw& law, const Shape& shape,
                                           const CellVectors& u) {
  return std::visit(
      [&](const auto& part) {
        CellVectors sum = CellVectors::Zero(3, u.cols());
        for (Eigen::Index q = 0; q < shape.weights.size(); ++q)
          sum += shape.weights[q] *
                 part.dilatation(displacement_gradient(shape, u, q)).first *
                 shape.gradients_at(q);
        return sum;
      },
      law.constitution);
}

double gradient_square(const Shape& shape, const CellVectors& u) {
  double integral = 0;
  for (Eigen::Index q = 0; q < shape.weights.size(); ++q)
    integral += shape.weights[q] * displacement_gradient(shape, u, q).squaredNorm();
  return integral;
}

double deformed_volume(const Shape& shape, const CellVectors& u) {
  double integral = 0;
  for (Eigen::Index q = 0; q < shape.weights.size(); ++q)
    integral += shape.weights[q] *
                (displacement_gradient(shape, u, q) + Matrix3::Identity()).determinant();
  return integral;
}

CellMatrix cell_tangent(const CellLaw& law, const Shape& shape, const CellVectors& u,
                        const FromNodalPatches& nodal_patches) {
  return std::visit(
      [&](const auto& part) {
        return stiffness(part, law.dilatation, shape, u, nodal_patches);
      },
      law.constitution);
}

}  // namespace springcheck::fem_reference
