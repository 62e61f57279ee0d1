#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meshing/mesh.hpp"
#include "mss/tissue/tissue_cell.hpp"

namespace springcheck::mss {

/// A body of living tissue in cubes, at rest in the mesh's positions.
struct TissueBody {
  tissue::Solid solid;
  std::vector<Vector3> rest_positions;  // [m]
  std::vector<CellNodes> cells;         // hexahedra
  std::vector<double> edges;            // h of each cell [m]
  std::vector<double> masses;           // [kg], of the nodes
};

/// Why tissue cannot be made of these cells, or nothing when it can: they must be cubes,
/// to 1e-6 of their edge.
std::optional<std::string> reason_to_refuse_tissue(const Mesh& mesh);

/// density [kg/m^3]. The mesh must not be one that reason_to_refuse_tissue names.
TissueBody build_tissue_body(const Mesh& mesh, const tissue::Solid& solid,
                             double density);

/// The memories of all cells, state_size each, in one list.
std::vector<double> memories_at_rest(const TissueBody& body);

HexahedronPositions positions_of(const TissueBody& body, std::size_t cell,
                                 std::span<const Vector3> positions);

/// The stress of each cell at the end of a step that leads to the positions; advance: and
/// the memories become those after the step.
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

/// What the cells have stored [J], sum h^3 psi.
double free_energy(const TissueBody& body, std::span<const double> memories,
                   std::span<const Vector3> positions);

}  // namespace springcheck::mss
