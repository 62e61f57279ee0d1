#pragma once

#include <optional>
#include <span>
#include <vector>

#include "comparisons/cases/convergence_grids.hpp"
#include "comparisons/studies/extrapolation.hpp"
#include "comparisons/studies/study.hpp"

namespace springcheck {

/// Changes between grids below this fraction of a quantity (of V0 for volumes, of the
/// largest displacement for fields) are what the solvers' tolerances leave.
inline constexpr double solver_noise = 1e-8;

/// The sizes of the three grids' cells.
GridSizes grid_sizes(const ThreeCases& cases);

/// What displacements converge to, at the nodes of a mesh.
struct ConvergedField {
  std::vector<Vector3> displacements;
  std::vector<double> cell_volumes;  // [m^3] deformed, of its cells
  std::optional<double> order{};     // of the displacements, and
  std::optional<double> index{};     // likewise: see Extrapolated
  double error_bound;                // mean over the nodes of the distance it bounds [m]
  std::vector<double> node_error_bounds{};  // that distance at each
};

/// A run's displacements at the nodes of a body's mesh: its own ones, or interpolated
/// where it ran on another grid of hexahedra.
std::vector<Vector3> displacements_on(const Body& body, const CaseResult& run,
                                      MeshStore& meshes);

/// Extrapolates three runs, which must have their fields, at the nodes of a body's mesh:
/// the runs' own one, or any mesh of the block that they cut into regular grids.
ConvergedField converged_field(std::span<const CaseResult* const> runs, const Body& body,
                               MeshStore& meshes);

/// The field of the finest of the runs, from coarse to fine, with error bounds by its
/// distance from the next, the formal order and a safety factor of 3 (extrapolation.hpp).
ConvergedField finest_field(std::span<const CaseResult* const> runs, const Body& body,
                            MeshStore& meshes);

/// What deviations are measured against.
struct ReferenceField {
  Solution solution;  // displacements and cell volumes, on the case's mesh
  std::optional<double> order{}, error_bound{};  // as ConvergedField's, of three grids
  std::vector<double> node_error_bounds{};       // likewise
};

/// The request's, from the runs of reference_cases(request); none when one of them
/// failed. Of three grids it is converged_field where the case's nodes are nodes of the
/// coarsest. Elsewhere what interpolation adds to a coarse grid's errors does not
/// converge as they do: there it is the finest run's field, with error bounds of what it
/// may be off itself, by the order and safety that the coarsest's nodes show, or as
/// finest_field where they show none, and of the interpolation between its nodes,
/// 1.25/(2^(3/2) - 1) times what leaving out every other node changes.
std::optional<ReferenceField> reference_field(const Request& request,
                                              std::span<const CaseResult* const> runs,
                                              MeshStore& meshes);

}  // namespace springcheck
