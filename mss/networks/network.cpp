#include "mss/networks/network.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "meshing/cell_geometry.hpp"
#include "mss/networks/masses.hpp"
#include "mss/networks/spring_model_table.hpp"

namespace springcheck::mss {
namespace {

/// Puts springs between the same two nodes together, in ascending order of nodes.
std::vector<Spring> merged(std::vector<Spring> springs) {
  std::ranges::stable_sort(
      springs, {}, [](const Spring& spring) { return std::tie(spring.a, spring.b); });
  std::vector<Spring> unique;
  for (const Spring& spring : springs)
    if (!unique.empty() && unique.back().a == spring.a && unique.back().b == spring.b)
      unique.back().stiffness += spring.stiffness;
    else
      unique.push_back(spring);
  return unique;
}

Spring between(const CellNodes& nodes, const LocalEdge& ends, double stiffness,
               double rest_length) {
  const auto [a, b] = std::minmax(nodes[ends[0]], nodes[ends[1]]);
  return {.a = a, .b = b, .stiffness = stiffness, .rest_length = rest_length};
}

/// G of hencky's volume correction [Pa]: sum k L^2/(15 V) of springs that are not
/// virtual.
double cubic_modulus(const Network& network) {
  if (network.strain_measure != StrainMeasure::hencky ||
      network.cell_springs == RestLength::affine)
    return 0;
  double sum = 0, volume = 0;
  for (std::size_t c = 0; c < network.cells.size(); ++c)
    volume += network.cells.volume(c);
  for (const Spring& spring : network.springs)
    sum += spring.stiffness * spring.rest_length * spring.rest_length;
  return sum / (15 * volume);
}

}  // namespace

Network build_network(const Mesh& mesh, const Material& material,
                      const NetworkSettings& settings) {
  const SpringModelEntry& model = entry_of(settings.model);
  const bool is_affine = model.has_virtual_springs;
  const double mu = lame_constants(material).mu;
  Network network{.rest_positions = mesh.nodes(),
                  .cell_springs = is_affine ? RestLength::affine : RestLength::constant,
                  .strain_measure = settings.strain_measure,
                  .axes = settings.axes,
                  .spring_modulus = is_affine ? mu : 0,
                  .masses = std::vector<double>(mesh.nodes().size(), 0)};
  std::vector<Spring> springs, damped_edges;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const CellNodes& nodes = mesh.cells()[c];
    const CornerPositions x = corners(nodes, mesh.nodes());
    const double volume = mesh.cell_volumes()[c];
    const CornerPositions area = cell_volume_gradient(x);
    std::array<Vector3, 8> gradients;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      gradients[i] = area.col(static_cast<Eigen::Index>(i)) / volume;
    const std::vector<CellSpring> own = model.springs({x, volume, material, settings});
    network.cells.add({nodes.begin(), nodes.size()},
                      std::span(gradients).first(nodes.size()), volume, own);

    const std::vector<double> shares = nodal_volumes(x);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      network.masses[nodes[i]] += material.density * shares[i];

    if (!is_affine) {
      for (const auto& [ends, stiffness, rest] : own)
        springs.push_back(between(nodes, ends, stiffness, rest.norm()));
      continue;
    }
    const auto cell_edges = edges(type_of(nodes));
    for (const LocalEdge& edge : cell_edges) {
      const double length = along(x, edge).norm();
      const double share = 15 * mu * volume / static_cast<double>(cell_edges.size());
      damped_edges.push_back(between(nodes, edge, share / (length * length), length));
    }
  }
  network.springs = merged(std::move(springs));
  network.damped_edges = merged(std::move(damped_edges));
  if (const auto kappa = model.volume_modulus(material, settings))
    network.volume_moduli = {.kappa = *kappa, .cubic = cubic_modulus(network)};
  if (is_affine) {
    network.shape_patches = nodal_patches(mesh, NodalPatchCells::tetrahedra);
    if (network.volume_moduli.kappa > 0)
      network.volume_patches = nodal_patches(mesh, NodalPatchCells::all);
  }
  return network;
}

}  // namespace springcheck::mss
