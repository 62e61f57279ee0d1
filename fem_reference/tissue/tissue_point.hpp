#pragma once

#include "fem_reference/laws/tensors.hpp"
#include "tissue/memory.hpp"

namespace springcheck::fem_reference {

/// A point of living tissue (tissue/memory.hpp) whose change of volume is not its own but
/// its cell's, Jm: the law's energy Phi(F, Jm) = psi(Cm) of
///
///     Cm = s C,   C = F^T F,   s = (Jm/J)^(2/3)
///
/// as Cm has the shape of C and the volume of the cell. With S of Cm and t = S : Cm
///
///     shape stress  dPhi/dF = F Ss,    Ss = s (S - t/3 Cm^-1)     [Pa]
///     pressure      dPhi/dJm = t/(3 Jm)                           [Pa]
///
/// at the end of a step, dashpot included. What a point remembers is of Cm.
/// Source: Simo, Taylor and Pister, Comput. Methods Appl. Mech. Eng. 51 (1985) 177, whose
/// mean dilatation this is.
struct TissuePointStress {
  tissue::SymmetricTensor shape;
  double pressure;
  tissue::SymmetricTensor strands;  // of the law at Cm [Pa]
};

/// Cm of a point.
tissue::SymmetricTensor with_volume(const Matrix3& deformation_gradient,
                                    double cell_jacobian);

TissuePointStress stress_after(const tissue::Solid& solid, const tissue::MemoryStep& step,
                               std::span<const double> state,
                               const Matrix3& deformation_gradient, double cell_jacobian);

/// Second derivatives of Phi [Pa].
struct TissuePointTangent {
  Matrix9 by_gradient;          // d(F Ss)/dF
  Matrix3 mixed;                // d(F Ss)/dJm, which is d pressure/dF
  double pressure_by_jacobian;  // d pressure/dJm
};
TissuePointTangent tangent_after(const tissue::Solid& solid,
                                 const tissue::MemoryStep& step,
                                 std::span<const double> state,
                                 const Matrix3& deformation_gradient,
                                 double cell_jacobian);

}  // namespace springcheck::fem_reference
