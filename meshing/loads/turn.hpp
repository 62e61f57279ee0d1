#pragma once

#include <optional>
#include <span>

#include "meshing/loads/scene.hpp"

namespace springcheck {

/// Whether the full load turns the last plate of a scene against the first by more than a
/// right angle: below, no turn is looked at.
bool turns_far(const Scene& scene);

/// The cells that show how the mesh's plates are turned against each other, and their
/// nodes at rest, the mesh's first: the cells are those of the mesh, or parts of them
/// where a field bends within one.
struct CellsBetween {
  std::span<const CellNodes> cells;
  std::span<const Vector3> nodes;
};

/// How far the last plate of a scene is turned against the first at load fraction s, as
/// the body between them shows it [rad]; none where there are no two plates or they turn
/// by less than a right angle. A plate tells its turn but for whole ones; the body tells
/// those as well. With a the unit vector along the last plate's axis, a cell's
/// deformation gradient F (the least-squares fit to its nodes' positions) turns by
///
///     phi = atan2(a . (F_32 - F_23, F_13 - F_31, F_21 - F_12), tr F - a . F a)
///
/// about it, and from a cell to the next ones, which share a node, by less than half a
/// turn. The first plate's cells are within half a turn of that plate; the value returned
/// is the last plate's nearest to the mean of its own cells. So a single layer of cells
/// shows less than half a turn: beyond, its linear field is inside out.
std::optional<double> shown_turn(const Mesh& mesh, const Scene& scene,
                                 const CellsBetween& between,
                                 std::span<const Vector3> positions,
                                 double load_fraction);

/// Whether that is the turn imposed, or no turn is looked at. It is not on a branch of
/// equilibria that belongs to another turn of the plates, less or more by whole ones.
bool shows_imposed_turn(const Mesh& mesh, const Scene& scene, const CellsBetween& between,
                        std::span<const Vector3> positions, double load_fraction);

// The same two by the mesh's own cells.
std::optional<double> shown_turn(const Mesh& mesh, const Scene& scene,
                                 std::span<const Vector3> positions,
                                 double load_fraction);
bool shows_imposed_turn(const Mesh& mesh, const Scene& scene,
                        std::span<const Vector3> positions, double load_fraction);

}  // namespace springcheck
