#pragma once

#include "meshing/mesh.hpp"
#include "mss/networks/strain_measure.hpp"

namespace springcheck::mss {

/// A matrix on gradients stacked column by column: F_iJ is component 3 J + i.
using Matrix9 = Eigen::Matrix<double, 9, 9>;

/// det F - 1 of F = I + H, from H so that small changes keep their digits:
/// tr H + (tr^2 H - tr H^2)/2 + det H.
double volume_change(const Matrix3& displacement_gradient);

/// cof F = d(det F)/dF.
Matrix3 cofactor(const Matrix3& displacement_gradient);

/// d2(det F)/dF dF.
Matrix9 volume_hessian(const Matrix3& displacement_gradient);

/// The volume change t of a strain measure: det F - 1, or tr E; and its derivatives by F,
/// cof F and d(cof F)/dF, or F and the identity.
double volume_change(StrainMeasure measure, const Matrix3& displacement_gradient);
Matrix3 volume_gradient(StrainMeasure measure, const Matrix3& displacement_gradient);
Matrix9 volume_hessian(StrainMeasure measure, const Matrix3& displacement_gradient);

}  // namespace springcheck::mss
