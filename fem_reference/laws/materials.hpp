#pragma once

#include <variant>

#include "fem_reference/laws/cauchy_born.hpp"
#include "fem_reference/laws/hencky.hpp"
#include "fem_reference/laws/hooke.hpp"
#include "fem_reference/laws/st_venant_kirchhoff.hpp"

namespace springcheck::fem_reference {

/// A law psi = shape part + U(t): `energy`, `stress`, `tangent` of the shape part,
/// `dilatation` its measure t, `volumetric_energy` U. Elements decide where t is taken
/// (cell.hpp).
using Constitution = std::variant<Hooke, StVenantKirchhoff, Hencky, CauchyBorn>;

Constitution constitution(const Material& material, const Settings& settings);

/// Energy per undeformed volume [Pa] and first Piola-Kirchhoff stress P = dpsi/dF [Pa] of
/// the whole law at a point.
double energy(const Constitution& law, const Matrix3& displacement_gradient);
Matrix3 stress(const Constitution& law, const Matrix3& displacement_gradient);

}  // namespace springcheck::fem_reference
