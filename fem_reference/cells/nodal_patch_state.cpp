#include "fem_reference/cells/nodal_patch_state.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "fem_reference/cells/cell_stiffness.hpp"

namespace springcheck::fem_reference {
namespace {

bool is_tetrahedron(const Cell& cell) {
  return cell.nodes.size() == 4;
}

/// Volume of a nodal patch's tetrahedra [m^3].
double volume_of_tetrahedra(const Discretisation& body, std::size_t node) {
  return body.tetrahedron_patches.size() == 0 ? 0
                                              : body.tetrahedron_patches.volumes[node];
}

/// Stresses of a nodal patch by its law [Pa].
struct NodalPatchStress {
  double energy = 0;                 // of the nodal patch [J]
  double pressure = 0;               // U'(t_n)
  Matrix3 stress = Matrix3::Zero();  // of the tetrahedra, by F_n
};

NodalPatchStress patch_stress(const CellLaw& law, const Discretisation& body,
                              const NodalPatchState& state, std::size_t n) {
  return std::visit(
      [&](const auto& part) {
        const VolumetricEnergy U = part.volumetric_energy(state.dilatations[n]);
        NodalPatchStress nodal_patch{.energy = body.nodal_patches.volumes[n] * U.value,
                                     .pressure = U.first};
        const double volume = volume_of_tetrahedra(body, n);
        if (!(volume > 0)) return nodal_patch;
        const Matrix3& H = state.gradients[n];
        const ShapeState shape_part = shape_state(part, H);
        nodal_patch.energy += (1 - tetrahedron_part) * volume * shape_part.energy;
        nodal_patch.stress = (1 - tetrahedron_part) * shape_part.stress +
                             U.first * part.dilatation(H).first;
        const bool ends_at_inversion = !std::holds_alternative<Hooke>(law.constitution);
        if (ends_at_inversion && !((Matrix3::Identity() + H).determinant() > 0))
          nodal_patch.energy = std::numeric_limits<double>::infinity();
        return nodal_patch;
      },
      law.constitution);
}

/// F_n - I and t_n.
void update_means(const CellLaw& law, const Discretisation& body,
                  const Eigen::VectorXd& displacements, NodalPatchState& state) {
  std::vector<Matrix3> of_tetrahedra(body.cells.size());
  std::vector<double> of_others(body.cells.size(), 0);
  tbb::parallel_for(std::size_t{0}, body.cells.size(), [&](std::size_t c) {
    const Shape& shape = *body.cells[c].shape;
    const CellVectors u = of_cell(displacements, body.cells[c]);
    if (is_tetrahedron(body.cells[c]))
      of_tetrahedra[c] = displacement_gradient(shape, u, shape.weights.size());
    else
      of_others[c] = mean_dilatation(law, shape, u);
  });
  tbb::parallel_for(std::size_t{0}, body.nodal_patches.size(), [&](std::size_t n) {
    double t = 0;
    for (const auto& [cell, weight] : body.nodal_patches[n])
      t += weight * of_others[cell];
    if (const double volume = volume_of_tetrahedra(body, n); volume > 0) {
      Matrix3 H = Matrix3::Zero();
      for (const auto& [cell, weight] : body.tetrahedron_patches[n])
        H += weight * of_tetrahedra[cell];
      state.gradients[n] = H;
      t += volume / body.nodal_patches.volumes[n] * dilatation(law, H).value;
    }
    state.dilatations[n] = t;
  });
}

}  // namespace

NodalPatchState nodal_patch_state(const CellLaw& law, const Discretisation& body,
                                  const Eigen::VectorXd& displacements) {
  const std::size_t nodes = body.nodal_patches.size();
  NodalPatchState state{
      .energy = 0,
      .gradients = std::vector<Matrix3>(body.tetrahedron_patches.size()),
      .dilatations = std::vector<double>(nodes),
      .pressures = std::vector<double>(nodes),
      .on_cells = {}};
  if (nodes == 0) return state;
  state.on_cells.resize(body.cells.size());
  update_means(law, body, displacements, state);
  std::vector<NodalPatchStress> stresses(nodes);
  tbb::parallel_for(std::size_t{0}, nodes, [&](std::size_t n) {
    stresses[n] = patch_stress(law, body, state, n);
    state.pressures[n] = stresses[n].pressure;
  });
  for (const NodalPatchStress& nodal_patch : stresses) state.energy += nodal_patch.energy;
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    FromNodalPatches& share = state.on_cells[c];
    const std::vector<NodeIndex>& at = body.cells[c].nodes;
    for (const NodeIndex node : at)
      if (is_tetrahedron(body.cells[c]))
        share.stress += stresses[node].stress / 4;
      else
        share.pressure += stresses[node].pressure / static_cast<double>(at.size());
    if (is_tetrahedron(body.cells[c])) share.own_part = tetrahedron_part;
  }
  return state;
}

std::vector<NodeIndex> patch_nodes(const Discretisation& body, NodeIndex node) {
  return nodes_of_patch(
      body.nodal_patches[node], [&](NodeIndex cell) -> auto& {
        return body.cells[cell].nodes;
      });
}

NodalPatchTangent patch_tangent(const CellLaw& law, const Discretisation& body,
                                const Eigen::VectorXd& displacements,
                                const NodalPatchState& state, NodeIndex node) {
  const std::vector<NodeIndex> nodes = patch_nodes(body, node);
  const auto count = std::ssize(nodes);
  NodalPatchTangent tangent{.gradients = CellVectors::Zero(3, count),
                            .shape = Matrix9::Zero(),
                            .dilatation_gradients = CellVectors::Zero(3, count),
                            .volumetric = 0};
  const auto add = [&](CellVectors& sum, const Cell& cell, const CellVectors& part) {
    for (std::size_t a = 0; a < cell.nodes.size(); ++a)
      sum.col(std::ranges::lower_bound(nodes, cell.nodes[a]) - nodes.begin()) +=
          part.col(static_cast<Eigen::Index>(a));
  };
  for (const auto& [number, weight] : body.nodal_patches[node]) {
    const Cell& cell = body.cells[number];
    if (is_tetrahedron(cell)) continue;
    add(tangent.dilatation_gradients, cell,
        weight / cell.shape->volume *
            integrated_dilatation_gradient(law, *cell.shape,
                                           of_cell(displacements, cell)));
  }
  const double volume = volume_of_tetrahedra(body, node);
  if (volume > 0) {
    for (const auto& [number, weight] : body.tetrahedron_patches[node]) {
      const Cell& cell = body.cells[number];
      add(tangent.gradients, cell, weight * cell.shape->mean_gradients());
    }
    tangent.dilatation_gradients += volume / body.nodal_patches.volumes[node] *
                                    dilatation(law, state.gradients[node]).first *
                                    tangent.gradients;
  }
  std::visit(
      [&](const auto& part) {
        tangent.volumetric = body.nodal_patches.volumes[node] *
                             part.volumetric_energy(state.dilatations[node]).second;
        if (!(volume > 0)) return;
        const Matrix3& H = state.gradients[node];
        tangent.shape = volume * ((1 - tetrahedron_part) * part.tangent(H) +
                                  state.pressures[node] * part.dilatation(H).second);
      },
      law.constitution);
  return tangent;
}

CellMatrix matrix(const NodalPatchTangent& tangent) {
  const auto d = tangent.dilatation_gradients.reshaped();
  CellMatrix sum = tangent.volumetric * d * d.transpose();
  if (!tangent.shape.isZero(0)) add_stiffness(sum, tangent.shape, tangent.gradients);
  return sum;
}

}  // namespace springcheck::fem_reference
