#include "fem_reference/cells/node_stars.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "fem_reference/cells/cell_stiffness.hpp"

namespace springcheck::fem_reference {
namespace {

/// U of a star and psi of its tetrahedra, per volume.
struct StarLaw {
  VolumetricEnergy volumetric;
  double energy = 0;
  Matrix3 stress = Matrix3::Zero();
};

bool ends_at_inversion(const CellLaw& law) {
  return !std::holds_alternative<Hooke>(law.constitution);
}

}  // namespace

StarsState stars_state(const CellLaw& law, const Discretisation& body,
                       const Eigen::VectorXd& displacements) {
  const std::size_t cells = body.cells.size(), nodes = body.stars.size();
  const bool has_tetrahedra = body.tetrahedron_stars.size() > 0;
  if (nodes == 0) return {.energy = 0,
            .gradients = {},
            .dilatations = {},
            .on_cells = std::vector<FromStars>(cells)};
  std::vector<Matrix3> cell_gradients(cells);
  std::vector<double> cell_dilatations(cells);
  tbb::parallel_for(std::size_t{0}, cells, [&](std::size_t c) {
    const Shape& shape = *body.cells[c].shape;
    const CellVectors u = of_cell(displacements, body.cells[c]);
    cell_gradients[c] = displacement_gradient(shape, u, shape.weights.size());
    cell_dilatations[c] = mean_dilatation(law, shape, u);
  });

  StarsState state{.energy = 0,
                   .gradients = std::vector<Matrix3>(has_tetrahedra ? nodes : 0),
                   .dilatations = std::vector<double>(nodes),
                   .on_cells = std::vector<FromStars>(cells)};
  std::vector<StarLaw> laws(nodes);
  tbb::parallel_for(std::size_t{0}, nodes, [&](std::size_t n) {
    double t = 0;
    for (const auto& [cell, weight] : body.stars[n]) t += weight * cell_dilatations[cell];
    state.dilatations[n] = t;
    if (has_tetrahedra) {
      Matrix3 H = Matrix3::Zero();
      for (const auto& [cell, weight] : body.tetrahedron_stars[n])
        H += weight * cell_gradients[cell];
      state.gradients[n] = H;
    }
    std::visit(
        [&](const auto& part) {
          laws[n].volumetric = part.volumetric_energy(t);
          if (!has_tetrahedra || body.tetrahedron_stars[n].empty()) return;
          laws[n].energy = part.energy(state.gradients[n]);
          laws[n].stress = part.stress(state.gradients[n]);
        },
        law.constitution);
  });

  for (std::size_t n = 0; n < nodes; ++n) {
    state.energy += body.stars.volumes[n] * laws[n].volumetric.value;
    if (!has_tetrahedra) continue;
    state.energy +=
        (1 - tetrahedron_part) * body.tetrahedron_stars.volumes[n] * laws[n].energy;
    const Matrix3 F = Matrix3::Identity() + state.gradients[n];
    if (ends_at_inversion(law) && !(F.determinant() > 0))
      state.energy = std::numeric_limits<double>::infinity();
  }
  for (std::size_t c = 0; c < cells; ++c) {
    const std::vector<NodeIndex>& at = body.cells[c].nodes;
    FromStars& share = state.on_cells[c];
    for (const NodeIndex node : at) {
      share.pressure += laws[node].volumetric.first / static_cast<double>(at.size());
      if (at.size() == 4) share.stress += (1 - tetrahedron_part) / 4 * laws[node].stress;
    }
    if (at.size() == 4) share.own_part = tetrahedron_part;
  }
  return state;
}

std::vector<NodeIndex> star_nodes(const Discretisation& body, NodeIndex node) {
  std::vector<NodeIndex> nodes;
  for (const auto& [cell, weight] : body.stars[node])
    nodes.insert(nodes.end(), body.cells[cell].nodes.begin(),
                 body.cells[cell].nodes.end());
  std::ranges::sort(nodes);
  nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
  return nodes;
}

StarTangent star_tangent(const CellLaw& law, const Discretisation& body,
                         const Eigen::VectorXd& displacements, const StarsState& state,
                         NodeIndex node) {
  const std::vector<NodeIndex> nodes = star_nodes(body, node);
  const auto count = std::ssize(nodes);
  StarTangent tangent{.gradients = CellVectors::Zero(3, count),
                      .shape = Matrix9::Zero(),
                      .dilatation_gradients = CellVectors::Zero(3, count),
                      .volumetric = 0};
  const auto add = [&](CellVectors& sum, const Cell& cell, const CellVectors& part) {
    for (std::size_t a = 0; a < cell.nodes.size(); ++a)
      sum.col(std::ranges::lower_bound(nodes, cell.nodes[a]) - nodes.begin()) +=
          part.col(static_cast<Eigen::Index>(a));
  };
  for (const auto& [number, weight] : body.stars[node]) {
    const Cell& cell = body.cells[number];
    add(tangent.dilatation_gradients, cell,
        weight / cell.shape->volume *
            dilatation_gradient(law, *cell.shape, of_cell(displacements, cell)));
  }
  std::visit(
      [&](const auto& part) {
        tangent.volumetric = body.stars.volumes[node] *
                             part.volumetric_energy(state.dilatations[node]).second;
        if (body.tetrahedron_stars.size() == 0 || body.tetrahedron_stars[node].empty())
          return;
        tangent.shape = (1 - tetrahedron_part) * body.tetrahedron_stars.volumes[node] *
                        part.tangent(state.gradients[node]);
      },
      law.constitution);
  if (body.tetrahedron_stars.size() > 0)
    for (const auto& [number, weight] : body.tetrahedron_stars[node]) {
      const Cell& cell = body.cells[number];
      add(tangent.gradients, cell, weight * cell.shape->mean_gradients());
    }
  return tangent;
}

CellMatrix matrix(const StarTangent& tangent) {
  const auto d = tangent.dilatation_gradients.reshaped();
  CellMatrix sum = tangent.volumetric * d * d.transpose();
  if (!tangent.shape.isZero(0)) add_stiffness(sum, tangent.shape, tangent.gradients);
  return sum;
}

}  // namespace springcheck::fem_reference
