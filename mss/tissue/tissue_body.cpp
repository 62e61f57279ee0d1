#include "mss/tissue/tissue_body.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>

#include "meshing/cell_geometry.hpp"
#include "mss/networks/masses.hpp"
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
          right_cauchy_green(body.shape(c), positions_of(body, c, positions)));
}

/// The places of a cell's nodes from the first one, in steps of 1e-9 of its size: equal
/// for cells that are translations of each other.
std::vector<std::int64_t> outline(const CornerPositions& x) {
  const double step = 1e-9 * std::cbrt(std::abs(cell_volume(x)));
  // The step is rounded to a power of two, so that cells whose volumes differ by
  // round-off share it.
  const double rounded = std::exp2(std::floor(std::log2(step)));
  std::vector<std::int64_t> places;
  for (Eigen::Index a = 1; a < x.cols(); ++a)
    for (int i = 0; i < 3; ++i)
      places.push_back(std::llround((x(i, a) - x(i, 0)) / rounded));
  return places;
}

}  // namespace

TissueBody build_tissue_body(const Mesh& mesh, const tissue::Solid& solid,
                             double density) {
  check(solid);
  TissueBody body{.solid = solid,
                  .rest_positions = mesh.nodes(),
                  .cells = mesh.cells(),
                  .masses = std::vector<double>(mesh.nodes().size(), 0.)};
  std::map<std::vector<std::int64_t>, std::size_t> known;
  for (const CellNodes& cell : mesh.cells()) {
    const CornerPositions x = corners(cell, mesh.nodes());
    const auto [found, is_new] = known.emplace(outline(x), body.shapes.size());
    if (is_new) body.shapes.push_back(tissue_shape(x));
    body.shape_of.push_back(found->second);
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

CornerPositions positions_of(const TissueBody& body, std::size_t cell,
                             std::span<const Vector3> positions) {
  return corners(body.cells[cell], positions);
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
                      body.shape(c), positions_of(body, c, positions),
                      positions_of(body, c, velocities));
                  stresses[c] = tissue::stress_at(body.solid, memory, C, rate);
                });
}

void nodal_forces(const TissueBody& body, std::span<const tissue::PointStress> stresses,
                  std::span<const Vector3> positions, std::span<Vector3> forces) {
  std::ranges::fill(forces, Vector3::Zero());
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const CornerPositions f =
        tissue_forces(body.shape(c), positions_of(body, c, positions), stresses[c]);
    for (std::size_t a = 0; a < body.cells[c].size(); ++a)
      forces[body.cells[c][a]] += f.col(static_cast<Index>(a));
  }
}

double largest_shear_strain(const TissueBody& body, std::span<const Vector3> positions) {
  double largest = 0;
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const tissue::SymmetricTensor C =
        right_cauchy_green(body.shape(c), positions_of(body, c, positions));
    const double square = C.head<3>().sum() / std::cbrt(tissue::determinant(C)) - 3;
    largest = std::max(largest, std::sqrt(std::max(square, 0.)));
  }
  return largest;
}

double free_energy(const TissueBody& body, std::span<const double> memories,
                   std::span<const Vector3> positions) {
  double energy = 0;
  for_each_cell(body, memories, positions,
                [&](std::size_t c, std::span<const double> memory,
                    const tissue::SymmetricTensor& C) {
                  energy +=
                      body.shape(c).volume * tissue::free_energy(body.solid, memory, C);
                });
  return energy;
}

}  // namespace springcheck::mss
