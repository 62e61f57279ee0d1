#pragma once

#include "dynamics/quasi_static/quasi_static.hpp"
#include "meshing/basics/stopwatch.hpp"
#include "mss/tissue/tissue_body.hpp"

namespace springcheck::mss {

/// Moves tissue through equilibria, see dynamics::find_quasi_static: with the symmetric
/// part of tissue_stiffness, shifted where it is not positive definite, and residuals
/// measured by the norm of the nodal forces that each cell's springs have apart, which
/// the volume forces balance at rest.
Solution find_quasi_static(const Mesh& mesh, const Scene& scene, const TissueBody& body,
                           const dynamics::QuasiStaticSettings& settings,
                           const dynamics::Observers& observers = {},
                           const Stopwatch& setup = {});

}  // namespace springcheck::mss
