#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meshing/loads/scene.hpp"
#include "meshing/nodal_patches.hpp"
#include "mss/networks/cells.hpp"
#include "mss/networks/spring_model.hpp"

namespace springcheck::mss {

/// A spring between two nodes, its tension by the network's strain measure.
struct Spring {
  NodeIndex a;
  NodeIndex b;
  double stiffness;    // k [N/m], summed over the cells that share it
  double rest_length;  // L [m]
};

/// What the springs of a cell pull towards: their length at rest, or in the cell's mean
/// deformation, |F r|. The latter resist hourglasses alone.
enum class RestLength { constant, affine };

/// A mass-spring system with volume correction, at rest in the mesh's positions. Energy:
/// see strain_energy.
struct Network {
  std::vector<Vector3> rest_positions;  // [m]
  std::vector<Spring> springs{};  // of constant rest length, each pair of nodes once
  // Edges that carry the dashpots of the virtual springs, and do not pull; once each:
  std::vector<Spring> damped_edges{};
  Cells cells{};  // their springs are those above, cell by cell, where those are constant
  RestLength cell_springs = RestLength::constant;
  StrainMeasure strain_measure = StrainMeasure::engineering;  // of springs and correction
  Axes axes = Axes::six;                                      // of the virtual springs
  double spring_modulus = 0;      // mu of the virtual springs [Pa]; 0: there are none
  VolumeModuli volume_moduli{};   // 0 without correction
  NodalPatches shape_patches{};   // means of F; none: virtual springs act on cells alone
  NodalPatches volume_patches{};  // means of volume change; none: correction on cells
  std::vector<double> masses{};   // [kg] density times nodal_volumes
};

/// Why the method cannot treat this mesh and material, or nothing when it can:
///
///     mss-affine              takes all
///     mss-cf, mss-fd          cubes, and boxes that box_lattice covers
///     mss-nfd, mss-custom     cubes
///     mss-baudet              cubes, and nu in (-1/4, 1/2)
///     vangelder, lloyd        tetrahedra
///
/// Shapes are judged to 1e-6 of a cell's edge. Mss-affine is stable at rest for every nu
/// in (-1, 1/2): all its parts are then positive or zero, Hooke's law and springs without
/// tension. Tried from -.99 to .4999 on distorted and mixed meshes of all types: no
/// negative eigenvalue, and six of zero. With vangelder and lloyd a negative kappa, below
/// nu = 1/4, may leave no stable rest state; the solver says so.
std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Material& material,
                                            SpringModel model);

/// Springs and correction cells of the mesh. Every cube adds k_e/4 to its edges, k_f/2
/// to its face diagonals, k_c to its inner diagonals, so that an edge of n cells gets
/// k_e n/4 and a boundary face diagonal k_f/2 without special cases (Golec 2018, 5.3).
/// The mesh must not be one that reason_to_refuse names.
///
/// mss-affine: virtual springs in every cell (VirtualSprings), hourglass_springs where
/// there are any, and on tetrahedra three quarters of the virtual springs' energy on the
/// mean deformation of the tetrahedra around each node, a quarter on their own. Above
/// nu = 1/4 the volume correction acts on the mean volume change over the cells around
/// each node; at or below, where kappa is not positive, wherever the virtual springs do.
/// Its dashpots lie on the edges, where springs of sum k l^2 = 15 mu V, as in the virtual
/// springs of a cell, would be shared equally among them: k = 15 mu V/(n_edges l^2).
Network build_network(const Mesh& mesh, const Material& material,
                      const NetworkSettings& settings);

}  // namespace springcheck::mss
