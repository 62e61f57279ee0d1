#include "mss/network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "mss/cell.hpp"

namespace springcheck::mss {
namespace {

LatticeStiffness lattice_stiffness(const Material& material, double cell_edge,
                                   const NetworkSettings& settings) {
  if (settings.method == Method::custom) return settings.constants.value().stiffness;
  if (settings.method == Method::baudet)
    return baudet_stiffness(material.young_modulus, material.poisson_ratio, cell_edge);
  const double A = settings.method == Method::nfd ? 0 : settings.diagonal_ratio;
  return settings.stiffness_form == StiffnessForm::shear_modulus
             ? shear_modulus_form(lame_constants(material).mu, cell_edge, A)
             : young_modulus_form(material.young_modulus, cell_edge, A);
}

double volume_modulus(const Material& material, const NetworkSettings& settings) {
  switch (settings.method) {
    case Method::nfd:
    case Method::cf:
      return volume_correction_modulus(material);
    case Method::custom:
      return settings.constants.value().volume_modulus;
    case Method::baudet:
    case Method::fd:
      return 0;
  }
  return 0;
}

double rest_length(const CornerPositions& x, const LocalSpring& spring) {
  return (x.col(static_cast<Eigen::Index>(spring[1])) -
          x.col(static_cast<Eigen::Index>(spring[0])))
      .norm();
}

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

}  // namespace

std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Material& material,
                                            Method method) {
  if (method == Method::baudet && material.poisson_ratio <= -0.25)
    return fmt::format(
        "mss-baudet covers nu in (-0.25, 0.5): its edge stiffness is not positive at "
        "nu = {:g}",
        material.poisson_ratio);
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const CellType type = type_of(mesh.cells()[c]);
    if (type != CellType::hexahedron)
      return fmt::format("its springs need cubic cells, and cell {} is a {}", c,
                         name_of(type));
    const CornerPositions x = corners(mesh.cells()[c], mesh.nodes());
    const double h = std::cbrt(mesh.cell_volumes()[c]);
    const auto deviates = [&](const LocalSpring& spring, double length) {
      return std::abs(rest_length(x, spring) - length) > 1e-6 * h;
    };
    if (std::ranges::any_of(cell_edges, [&](auto& s) { return deviates(s, h); }) ||
        std::ranges::any_of(cell_inner_diagonals,
                            [&](auto& s) { return deviates(s, std::sqrt(3.) * h); }))
      return fmt::format("its springs need cubic cells, and hexahedron {} is none", c);
  }
  return std::nullopt;
}

Network build_network(const Mesh& mesh, const Material& material,
                      const NetworkSettings& settings) {
  Network network{.rest_positions = mesh.nodes(),
                  .springs = {},
                  .cells = {},
                  .volume_modulus = volume_modulus(material, settings),
                  .masses = std::vector<double>(mesh.nodes().size(), 0)};
  std::vector<Spring> springs;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const CellNodes& nodes = mesh.cells()[c];
    const CornerPositions x = corners(nodes, mesh.nodes());
    const double volume = mesh.cell_volumes()[c];
    const LatticeStiffness k = lattice_stiffness(material, std::cbrt(volume), settings);
    const LatticeStiffness share{.edge = k.edge / 4,
                                 .face_diagonal = k.face_diagonal / 2,
                                 .inner_diagonal = k.inner_diagonal};
    network.cells.push_back(
        {.nodes = nodes, .share = share, .rest_volume = mean_edge_volume(x)});
    for (const NodeIndex node : nodes)
      network.masses[node] += material.density * volume / 8;

    const auto add = [&](const auto& pairs, double stiffness) {
      if (stiffness == 0) return;
      for (const LocalSpring& pair : pairs) {
        const auto [a, b] = std::minmax(nodes[pair[0]], nodes[pair[1]]);
        springs.push_back({.a = a,
                           .b = b,
                           .stiffness = stiffness,
                           .rest_length = rest_length(x, pair)});
      }
    };
    add(cell_edges, share.edge);
    add(cell_face_diagonals, share.face_diagonal);
    add(cell_inner_diagonals, share.inner_diagonal);
  }
  network.springs = merged(std::move(springs));
  return network;
}

}  // namespace springcheck::mss
