#include "mss/tissue/tissue_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "meshing/cell_geometry.hpp"
#include "mss/box_lattice.hpp"
#include "mss/masses.hpp"
#include "tissue/memory_energy.hpp"

namespace springcheck::mss {
namespace {

using Eigen::Index;

std::size_t state_size_of(const TissueBody& body) {
  return tissue::state_size(body.solid.shear.branches.size());
}

/// Calls visit(cell, its memory, its C).
template <class Number, class Visit>
void for_each_cell(const TissueBody& body, std::span<Number> memories,
                   std::span<const Vector3> positions, Visit visit) {
  const std::size_t size = state_size_of(body);
  assert(memories.size() == size * body.cells.size());
  for (std::size_t c = 0; c < body.cells.size(); ++c)
    visit(c, memories.subspan(c * size, size),
          right_cauchy_green(positions_of(body, c, positions), body.edges[c]));
}

}  // namespace

std::optional<std::string> reason_to_refuse_tissue(const Mesh& mesh) {
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const CornerPositions x = corners(mesh.cells()[c], mesh.nodes());
    const CellType type = type_of(mesh.cells()[c]);
    if (type != CellType::hexahedron)
      return fmt::format("tissue needs cubic cells, and cell {} is a {}", c,
                         name_of(type));
    const auto box = box_edges(x);
    if (!box || !is_cube(*box))
      return fmt::format("tissue needs cubic cells, and hexahedron {} is none", c);
  }
  return std::nullopt;
}

TissueBody build_tissue_body(const Mesh& mesh, const tissue::Solid& solid,
                             double density) {
  check(solid);
  assert(!reason_to_refuse_tissue(mesh));
  TissueBody body{.solid = solid,
                  .rest_positions = mesh.nodes(),
                  .cells = mesh.cells(),
                  .edges = {},
                  .masses = std::vector<double>(mesh.nodes().size(), 0.)};
  for (const CellNodes& cell : mesh.cells()) {
    const CornerPositions x = corners(cell, mesh.nodes());
    const std::array<double, 3> box = box_edges(x).value();
    body.edges.push_back((box[0] + box[1] + box[2]) / 3);
    const std::vector<double> volumes = nodal_volumes(x);
    for (std::size_t a = 0; a < cell.size(); ++a)
      body.masses[cell[a]] += density * volumes[a];
  }
  return body;
}

std::vector<double> memories_at_rest(const TissueBody& body) {
  std::vector<double> memories(state_size_of(body) * body.cells.size());
  tissue::set_to_rest(memories);
  return memories;
}

HexahedronPositions positions_of(const TissueBody& body, std::size_t cell,
                                 std::span<const Vector3> positions) {
  HexahedronPositions x;
  for (std::size_t a = 0; a < 8; ++a)
    x.col(static_cast<Index>(a)) = positions[body.cells[cell][a]];
  return x;
}

void stresses_after(const TissueBody& body, const tissue::MemoryStep& step,
                    std::span<const double> memories, std::span<const Vector3> positions,
                    std::span<tissue::PointStress> stresses) {
  for_each_cell(body, memories, positions,
                [&](std::size_t c, std::span<const double> memory,
                    const tissue::SymmetricTensor& C) {
                  stresses[c] = tissue::stress_after(body.solid, step, memory, C);
                });
}

void advance(const TissueBody& body, const tissue::MemoryStep& step,
             std::span<double> memories, std::span<const Vector3> positions,
             std::span<tissue::PointStress> stresses) {
  for_each_cell(
      body, memories, positions,
      [&](std::size_t c, std::span<double> memory, const tissue::SymmetricTensor& C) {
        stresses[c] = tissue::advance(body.solid, step, memory, C);
      });
}

void stresses_at(const TissueBody& body, std::span<const double> memories,
                 std::span<const Vector3> positions, std::span<const Vector3> velocities,
                 std::span<tissue::PointStress> stresses) {
  for_each_cell(body, memories, positions,
                [&](std::size_t c, std::span<const double> memory,
                    const tissue::SymmetricTensor& C) {
                  const tissue::SymmetricTensor rate = right_cauchy_green_rate(
                      positions_of(body, c, positions), positions_of(body, c, velocities),
                      body.edges[c]);
                  stresses[c] = tissue::stress_at(body.solid, memory, C, rate);
                });
}

void nodal_forces(const TissueBody& body, std::span<const tissue::PointStress> stresses,
                  std::span<const Vector3> positions, std::span<Vector3> forces) {
  std::ranges::fill(forces, Vector3::Zero());
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const HexahedronPositions f =
        tissue_forces(positions_of(body, c, positions), body.edges[c], stresses[c]);
    for (std::size_t a = 0; a < 8; ++a)
      forces[body.cells[c][a]] += f.col(static_cast<Index>(a));
  }
}

double free_energy(const TissueBody& body, std::span<const double> memories,
                   std::span<const Vector3> positions) {
  double energy = 0;
  for_each_cell(body, memories, positions,
                [&](std::size_t c, std::span<const double> memory,
                    const tissue::SymmetricTensor& C) {
                  const double h = body.edges[c];
                  energy += h * h * h * tissue::free_energy(body.solid, memory, C);
                });
  return energy;
}

}  // namespace springcheck::mss
