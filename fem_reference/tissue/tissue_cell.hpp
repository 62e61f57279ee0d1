#pragma once

#include <span>

#include "fem_reference/cells/cell.hpp"
#include "tissue/memory.hpp"

namespace springcheck::fem_reference {

/// What of a cell's tissue a step of time leads to, with the memories of its Gauss points
/// side by side, state_size each. The change of volume is the cell's mean,
///
///     Jm = (1/V) int det F dV
///
/// (tissue_point.hpp), so that cells do not lock near nu = 1/2; as q1_sri does for laws
/// without a memory.
struct TissueCell {
  const tissue::Solid& solid;
  const tissue::MemoryStep& step;
  const Shape& shape;
  std::span<const double> states;
};

struct TissueCellForces {
  CellVectors forces;        // dW/du [N]
  double strand_square;      // of the nodal forces that the strands have apart [N^2]
  double smallest_jacobian;  // of det F over the Gauss points
};
TissueCellForces forces_after(const TissueCell& cell, const CellVectors& u);

/// The forces' derivative, its symmetric part [N/m]:
///
///     sum over points w {B^T (d2Phi/dF2) B + g c^T + c g^T + (dPhi/dJm) d2Jm/du2
///                        + (d2Phi/dJm2) c c^T},   g = B^T d2Phi/dF dJm,  c = dJm/du
CellMatrix tangent_after(const TissueCell& cell, const CellVectors& u);

/// The states become those after the step.
void advance(const tissue::Solid& solid, const tissue::MemoryStep& step,
             const Shape& shape, std::span<double> states, const CellVectors& u);

/// [J], with the states as they are.
double free_energy(const tissue::Solid& solid, const Shape& shape,
                   std::span<const double> states, const CellVectors& u);

/// sqrt(tr C' - 3) of the Gauss point where it is largest [-].
double largest_shear_strain(const Shape& shape, const CellVectors& u);

}  // namespace springcheck::fem_reference
