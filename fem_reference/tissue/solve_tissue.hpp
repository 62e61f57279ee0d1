#pragma once

#include "dynamics/quasi_static/quasi_static.hpp"
#include "meshing/basics/stopwatch.hpp"
#include "tissue/solid.hpp"

namespace springcheck::fem_reference {

/// Moves a body of living tissue through equilibria (dynamics::find_quasi_static), by
/// finite elements on the nodes of the mesh that take the change of volume from the
/// cell's mean (tissue_cell.hpp). Any cells; of the scene's material the density is read.
/// Linear systems by a Cholesky factor, the tangent shifted where there is none.
Solution solve_tissue(const Mesh& mesh, const Scene& scene, const tissue::Solid& solid,
                      const dynamics::QuasiStaticSettings& settings,
                      const dynamics::Observers& observers = {},
                      const Stopwatch& setup = {});

}  // namespace springcheck::fem_reference
