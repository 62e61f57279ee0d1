#pragma once

#include <span>

#include "meshing/basics/stopwatch.hpp"
#include "statics/equilibrium.hpp"

namespace springcheck::statics {

/// Cells on a body's nodes: those of its mesh, and the parts of them that its
/// intermediate nodes make, where it has any.
struct MeshCells {
  std::span<const CellNodes> whole, finest;
};

/// The resolution to which the load fraction is found, in parts of the load reached.
inline constexpr double limit_resolution = 0.002;

/// The last state of the path from rest that is stable and turns no cell of the mesh
/// inside out (follow_to_limit). Its status is ok at the full load; before it indefinite
/// where the path goes on without stability, no_equilibrium at a limit point, inverted,
/// or not_converged where the solver fails. Short of the full load it has
/// critical_wavelength, in edges of the finest cells, and definite_up_to unless the
/// solver fails.
Equilibrium last_stable_equilibrium(ElasticBody& body, const Loading& loading,
                                    const MeshCells& cells, LinearSolver linear_solver,
                                    const Stopwatch& setup = {});

}  // namespace springcheck::statics
