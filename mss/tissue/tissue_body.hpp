#pragma once

#include <span>
#include <vector>

#include "meshing/mesh.hpp"
#include "mss/tissue/tissue_cell.hpp"

namespace springcheck::mss {

/// A body of living tissue, at rest in the mesh's positions.
struct TissueBody {
  tissue::Solid solid;
  std::vector<Vector3> rest_positions;  // [m]
  std::vector<CellNodes> cells;
  std::vector<TissueShape> shapes{};    // each once
  std::vector<std::size_t> shape_of{};  // each cell
  std::vector<double> masses;           // [kg], of the nodes

  [[nodiscard]] const TissueShape& shape(std::size_t cell) const {
    return shapes[shape_of[cell]];
  }
};

/// The body of a mesh of any cells, of the density [kg/m^3].
TissueBody build_tissue_body(const Mesh& mesh, const tissue::Solid& solid,
                             double density);

/// The memories of all cells, state_size each, in one list.
std::vector<double> memories_at_rest(const TissueBody& body);

CornerPositions positions_of(const TissueBody& body, std::size_t cell,
                             std::span<const Vector3> positions);

/// The stress of each cell at the end of a step that leads to the positions. advance also
/// makes the memories those after the step.
void stresses_after(const TissueBody& body, const tissue::MemoryStep& step,
                    std::span<const double> memories, std::span<const Vector3> positions,
                    std::span<tissue::PointStress> stresses);
void advance(const TissueBody& body, const tissue::MemoryStep& step,
             std::span<double> memories, std::span<const Vector3> positions,
             std::span<tissue::PointStress> stresses);

/// The same at nodes that move at these velocities [m/s], with the memories as they are.
void stresses_at(const TissueBody& body, std::span<const double> memories,
                 std::span<const Vector3> positions, std::span<const Vector3> velocities,
                 std::span<tissue::PointStress> stresses);

/// Forces on the nodes [N] at these stresses, see tissue_forces. Overwrites `forces`.
void nodal_forces(const TissueBody& body, std::span<const tissue::PointStress> stresses,
                  std::span<const Vector3> positions, std::span<Vector3> forces);

/// sqrt(tr C' - 3) of the cell where it is largest [-], C' as in memory.hpp: in simple
/// shear the strain.
double largest_shear_strain(const TissueBody& body, std::span<const Vector3> positions);

/// What the cells have stored [J], sum V psi.
double free_energy(const TissueBody& body, std::span<const double> memories,
                   std::span<const Vector3> positions);

}  // namespace springcheck::mss
