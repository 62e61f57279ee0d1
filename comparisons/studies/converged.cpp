#include "comparisons/studies/converged.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "comparisons/cases/grids.hpp"
#include "comparisons/studies/formal_order.hpp"

namespace springcheck {
namespace {

/// One column per node.
Eigen::MatrixXd matrix_of(const std::vector<Vector3>& field) {
  Eigen::MatrixXd matrix(3, static_cast<Eigen::Index>(field.size()));
  for (Eigen::Index n = 0; const Vector3& value : field) matrix.col(n++) = value;
  return matrix;
}

Eigen::MatrixXd matrix_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::RowVectorXd>(values.data(),
                                              static_cast<Eigen::Index>(values.size()));
}

/// Deformed volumes of the cells of a body's mesh: the run's own, sums of those inside
/// each coarser cell, or those of the mesh in the run's displacements.
std::vector<double> cell_volumes_on(const Body& body, const CaseResult& run,
                                    MeshStore& meshes) {
  const Body& own = run.request.settings.body;
  const Mesh& own_mesh = meshes.mesh(own);
  if (own == body) return deformed_volumes(own_mesh, run.solution);
  if (body.block == Block{.size = body.block.size, .cells = body.block.cells} &&
      is_refinement(own.block.cells, body.block.cells))
    return summed_over_coarse_cells(deformed_volumes(own_mesh, run.solution),
                                    own.block.cells, body.block.cells);
  Solution here{};
  here.displacements = displacements_on(body, run, meshes);
  return deformed_volumes(meshes.mesh(body), here);
}

GridSizes sizes_of(std::span<const CaseResult* const> runs) {
  return grid_sizes(
      {runs[0]->request.settings, runs[1]->request.settings, runs[2]->request.settings});
}

/// What the runs say of the loaded face: the only one's displacement, or the one that
/// three converge to. Empty without a load.
std::vector<Vector3> face_displacements(std::span<const CaseResult* const> runs) {
  if (!runs.front()->measures.face_displacement) return {};
  if (runs.size() == 1) return {*runs.front()->measures.face_displacement};
  OnThreeGrids on_grids;
  for (std::size_t i = 0; i < 3; ++i) on_grids[i] = *runs[i]->measures.face_displacement;
  return {extrapolate(sizes_of(runs), on_grids, solver_noise * on_grids[2].norm(),
                      formal_order(runs[0]->request.settings))
              .value};
}

/// Least order by which the root mean square of an interpolation's error falls: where
/// plates end, displacements go as r^a with a > 1/2, over areas that go as r.
constexpr double order_of_interpolation = 1.5;

/// The finest run's field. Its own error is known at the middle grid's nodes, by the
/// order and safety that the coarsest's show; between its nodes there is that of the
/// interpolation, known from what every other node would give.
ConvergedField finest_with_error_bounds(std::span<const CaseResult* const> runs,
                                        const Body& body, MeshStore& meshes) {
  const GridSizes sizes = sizes_of(runs);
  const double ratio = sizes[1] / sizes[2];
  const Body& middle = runs[1]->request.settings.body;
  const Body& finest = runs[2]->request.settings.body;
  const std::vector<Vector3>& nodes = meshes.mesh(body).nodes();
  ConvergedField field = finest_field(runs, body, meshes);
  const ConvergedField shown =
      converged_field(runs, runs[0]->request.settings.body, meshes);
  field.order = shown.order;
  // The coarsest may have none but held nodes.
  if (shown.index) field.index = shown.index;
  const std::vector<Vector3> thinned = displacements_on(middle, *runs[2], meshes);
  const std::vector<Vector3>& coarser = runs[1]->solution.displacements;
  std::vector<Vector3> own_bounds;
  for (std::size_t n = 0; n < thinned.size(); ++n)
    own_bounds.emplace_back(*field.index * (thinned[n] - coarser[n]).norm(), 0, 0);
  const auto own_bounds_here = interpolated(own_bounds, middle.block, nodes),
             thinned_here = interpolated(thinned, middle.block, nodes);
  const double part_between =
      asymptotic_safety * rest_by_order(ratio, order_of_interpolation);
  const double noise =
      solver_noise * matrix_of(field.displacements).colwise().norm().maxCoeff();
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    // Quadratic, and so below 0 beside a node of a large error bound.
    field.node_error_bounds[n] = std::max(std::abs(own_bounds_here[n].x()), noise);
    if (!are_nodes_of(finest.block, std::span(&nodes[n], 1)))
      field.node_error_bounds[n] +=
          part_between * (thinned_here[n] - field.displacements[n]).norm();
  }
  field.error_bound = std::accumulate(field.node_error_bounds.begin(),
                                      field.node_error_bounds.end(), 0.) /
                      static_cast<double>(nodes.size());
  return field;
}

}  // namespace

GridSizes grid_sizes(const ThreeCases& cases) {
  return {cell_size(cases[0].body.block), cell_size(cases[1].body.block),
          cell_size(cases[2].body.block)};
}

std::vector<Vector3> displacements_on(const Body& body, const CaseResult& run,
                                      MeshStore& meshes) {
  const Body& own = run.request.settings.body;
  if (own == body) return run.solution.displacements;
  assert(is_grid_of_hexahedra(own) && own.block.distortion == 0);
  return interpolated(run.solution.displacements, own.block, meshes.mesh(body).nodes());
}

ConvergedField converged_field(std::span<const CaseResult* const> runs, const Body& body,
                               MeshStore& meshes) {
  assert(runs.size() == 3);
  const GridSizes sizes = sizes_of(runs);
  OnThreeGrids displacements, volumes;
  for (std::size_t i = 0; i < 3; ++i) {
    displacements[i] = matrix_of(displacements_on(body, *runs[i], meshes));
    volumes[i] = matrix_of(cell_volumes_on(body, *runs[i], meshes));
  }
  const double largest = displacements[2].colwise().norm().maxCoeff();
  const double order = formal_order(runs[0]->request.settings);
  const Extrapolated field =
      extrapolate(sizes, displacements, solver_noise * largest, order);
  const Extrapolated cell_volumes =
      extrapolate(sizes, volumes, solver_noise * volumes[2].mean(), order);

  ConvergedField converged{
      .displacements = {},
      .cell_volumes = {cell_volumes.value.data(),
                       cell_volumes.value.data() + cell_volumes.value.size()},
      .order = field.order,
      .index = field.index,
      .error_bound = field.error_bound.colwise().norm().mean()};
  for (const auto& error_bound : field.error_bound.colwise())
    converged.node_error_bounds.push_back(error_bound.norm());
  for (const auto& u : field.value.colwise()) converged.displacements.emplace_back(u);
  return converged;
}

ConvergedField finest_field(std::span<const CaseResult* const> runs, const Body& body,
                            MeshStore& meshes) {
  assert(runs.size() >= 2);
  const CaseResult& finest = *runs.back();
  ConvergedField field{.displacements = displacements_on(body, finest, meshes),
                       .cell_volumes = cell_volumes_on(body, finest, meshes),
                       .error_bound = 0};
  const Eigen::MatrixXd u = matrix_of(field.displacements);
  const Eigen::MatrixXd change =
      u - matrix_of(displacements_on(body, *runs[runs.size() - 2], meshes));
  const double noise = solver_noise * u.colwise().norm().maxCoeff();
  const CaseSettings& coarser = runs[runs.size() - 2]->request.settings;
  const double ratio =
      cell_size(coarser.body.block) / cell_size(finest.request.settings.body.block);
  field.index =
      cautious_safety * rest_by_order(ratio, formal_order(finest.request.settings));
  for (const auto& of_node : change.colwise())
    field.node_error_bounds.push_back(std::max(*field.index * of_node.norm(), noise));
  field.error_bound = std::max(*field.index * change.colwise().norm().mean(), noise);
  return field;
}

std::optional<ReferenceField> reference_field(const Request& request,
                                              std::span<const CaseResult* const> runs,
                                              MeshStore& meshes) {
  const bool all_measured = std::ranges::all_of(
      runs, [](const CaseResult* run) { return run->measures.volume_error.has_value(); });
  if (runs.empty() || !all_measured) return std::nullopt;
  const Body& body = request.settings.body;
  ReferenceField field{.solution = runs.back()->solution};
  field.solution.reactions.clear();
  field.solution.loaded_face_displacements = face_displacements(runs);
  if (runs.size() == 1) {
    field.solution.displacements = displacements_on(body, *runs[0], meshes);
    field.solution.cell_volumes = cell_volumes_on(body, *runs[0], meshes);
    return field;
  }
  const Body& coarsest = runs[0]->request.settings.body;
  ConvergedField converged = are_nodes_of(coarsest.block, meshes.mesh(body).nodes())
                                 ? converged_field(runs, body, meshes)
                                 : finest_with_error_bounds(runs, body, meshes);
  field.solution.displacements = std::move(converged.displacements);
  field.solution.cell_volumes = std::move(converged.cell_volumes);
  field.order = converged.order;
  field.error_bound = converged.error_bound;
  field.node_error_bounds = std::move(converged.node_error_bounds);
  return field;
}

}  // namespace springcheck
