#include "mss/networks/network.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "meshing/cell_geometry.hpp"
#include "mss/networks/box_lattice.hpp"
#include "mss/networks/cell_springs.hpp"
#include "mss/networks/hourglass.hpp"
#include "mss/networks/masses.hpp"

namespace springcheck::mss {
namespace {

const LatticeConstants& constants_of(const NetworkSettings& settings) {
  if (!settings.constants)
    throw std::invalid_argument("mss: method custom needs NetworkSettings::constants");
  return *settings.constants;
}

double volume_modulus(const Material& material, const NetworkSettings& settings) {
  switch (settings.method) {
    case Method::nfd:
    case Method::cf:
    case Method::affine:
      return volume_correction_modulus(material);
    case Method::vangelder:
    case Method::lloyd:
      return settings.volume_correction == VolumeCorrection::on
                 ? volume_correction_modulus(material)
                 : 0;
    case Method::custom:
      return constants_of(settings).volume_modulus;
    case Method::baudet:
    case Method::fd:
      return 0;
  }
  return 0;
}

/// mu of the springs.
double spring_modulus(const Material& material, StiffnessForm form) {
  return form == StiffnessForm::shear_modulus ? lame_constants(material).mu
                                              : 0.4 * material.young_modulus;
}

LatticeStiffness cube_stiffness(const Material& material, double cell_edge,
                                const NetworkSettings& settings) {
  if (settings.method == Method::custom) return constants_of(settings).stiffness;
  if (settings.method == Method::baudet)
    return baudet_stiffness(material.young_modulus, material.poisson_ratio, cell_edge);
  const double A = settings.method == Method::nfd ? 0 : settings.diagonal_ratio;
  return settings.stiffness_form == StiffnessForm::shear_modulus
             ? shear_modulus_form(lame_constants(material).mu, cell_edge, A)
             : young_modulus_form(material.young_modulus, cell_edge, A);
}

/// One spring for each of the pairs, of stiffness(pair, r) where that is not 0.
template <class Stiffness>
void add_springs(std::vector<CellSpring>& springs, const CornerPositions& x,
                 std::span<const LocalEdge> pairs, const Stiffness& stiffness) {
  for (const LocalEdge& ends : pairs) {
    const Vector3 r = along(x, ends);
    if (const double k = stiffness(ends, r); k != 0)
      springs.push_back({.ends = ends, .stiffness = k, .rest = r});
  }
}

std::vector<CellSpring> cube_springs(const CornerPositions& x,
                                     const LatticeStiffness& k) {
  std::vector<CellSpring> springs;
  const auto add = [&](std::span<const LocalEdge> pairs, double share) {
    add_springs(springs, x, pairs,
                [&](const LocalEdge&, const Vector3&) { return share; });
  };
  add(edges(CellType::hexahedron), k.edge / 4);
  add(face_diagonals(CellType::hexahedron), k.face_diagonal / 2);
  add(inner_diagonals(CellType::hexahedron), k.inner_diagonal);
  return springs;
}

std::vector<CellSpring> box_springs(const CornerPositions& x, const BoxLattice& q) {
  std::vector<CellSpring> springs;
  add_springs(springs, x, edges(CellType::hexahedron),
              [&](const LocalEdge& edge, const Vector3& r) {
                return q.edge[edge_direction(edge)] * r.squaredNorm();
              });
  add_springs(springs, x, face_diagonals(CellType::hexahedron),
              [&](const LocalEdge& diagonal, const Vector3& r) {
                return q.face_diagonal[face_direction(diagonal)] * r.squaredNorm();
              });
  add_springs(springs, x, inner_diagonals(CellType::hexahedron),
              [&](const LocalEdge&, const Vector3& r) {
                return q.inner_diagonal * r.squaredNorm();
              });
  return springs;
}

std::vector<CellSpring> cell_springs(const CornerPositions& x, double volume,
                                     const Material& material,
                                     const NetworkSettings& settings) {
  switch (settings.method) {
    case Method::affine:
      return hourglass_springs(x, volume, material);
    case Method::vangelder:
    case Method::lloyd: {
      std::vector<CellSpring> springs;
      const double E = material.young_modulus;
      add_springs(springs, x, edges(CellType::tetrahedron),
                  [&](const LocalEdge&, const Vector3& r) {
                    return settings.method == Method::vangelder
                               ? van_gelder_stiffness(E, volume, r.norm())
                               : lloyd_stiffness(E, r.norm());
                  });
      return springs;
    }
    default:
      break;
  }
  const std::array<double, 3> box = box_edges(x).value();
  if (is_cube(box))
    return cube_springs(x, cube_stiffness(material, std::cbrt(volume), settings));
  const double mu = spring_modulus(material, settings.stiffness_form);
  return box_springs(x, box_lattice(mu, box).value());
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

Spring between(const CellNodes& nodes, const LocalEdge& ends, double stiffness,
               double rest_length) {
  const auto [a, b] = std::minmax(nodes[ends[0]], nodes[ends[1]]);
  return {.a = a, .b = b, .stiffness = stiffness, .rest_length = rest_length};
}

}  // namespace

Network build_network(const Mesh& mesh, const Material& material,
                      const NetworkSettings& settings) {
  const bool is_affine = settings.method == Method::affine;
  const double mu = lame_constants(material).mu;
  Network network{.rest_positions = mesh.nodes(),
                  .springs = {},
                  .cells = {},
                  .cell_springs = is_affine ? RestLength::affine : RestLength::constant,
                  .spring_modulus = is_affine ? mu : 0,
                  .volume_modulus = volume_modulus(material, settings),
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
    const std::vector<CellSpring> own = cell_springs(x, volume, material, settings);
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
  if (is_affine) {
    const std::size_t count = mesh.nodes().size();
    network.shape_stars = stars(network.cells, count, StarCells::tetrahedra);
    if (network.volume_modulus > 0)
      network.volume_stars = stars(network.cells, count, StarCells::all);
  }
  return network;
}

}  // namespace springcheck::mss
