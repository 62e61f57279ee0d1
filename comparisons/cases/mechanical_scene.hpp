#pragma once

#include "comparisons/cases/case.hpp"

namespace springcheck {

/// The case as both solvers receive it. The axis is z.
///
///     compression, tension   glued plates; the upper one moves along -z, +z by
///                            deformation * height
///     shearing               glued plates; the upper one moves along +x by as much
///     torsion                glued plates; the upper one turns about +z, through its
///                            centre
///     bending                one glued plate; gravity acts
///     uniaxial               sliding plates; the upper one moves along z by deformation
///                            * height, up if positive
///     traction               one plate, glued or sliding; a uniform dead traction acts
///                            on the upper face
///     affine                 no plate; the whole boundary follows u = H X
///
/// Sliding plates hold z only. Pins take away the rigid motions they leave: the corner at
/// the origin keeps x and y, the one at (size_x, 0, 0) y. They need a block.
///
/// The plates' distance and the moved one's centre are those of the block; of other
/// bodies those of the regions' area-weighted centres.
///
/// Throws InputError where the mesh lacks a plate's region, or the moved plate is not
/// above the fixed one: a tenth of a plate's own height along z at least.
Scene mechanical_scene(const CaseSettings& settings, const Mesh& mesh);

}  // namespace springcheck
