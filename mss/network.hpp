#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meshing/scene.hpp"
#include "mss/stiffness.hpp"

namespace springcheck::mss {

enum class Method {
  baudet,  // edges and inner diagonals by Baudet's formulas, no correction
  nfd,     // no face diagonals (A = 0), with volume correction
  fd,      // face diagonals, no correction: right at nu = 1/4 only
  cf,      // face diagonals and volume correction: the thesis's method
  custom   // constants of the user's choice
};

enum class StiffnessForm { shear_modulus, young_modulus };

struct NetworkSettings {
  Method method;
  StiffnessForm stiffness_form;
  double diagonal_ratio;  // A of fd and cf
  // Of custom, which needs them, as they stand: they belong to the mesh's cell size, and
  // the same material in cells of edge h' has the stiffness times h'/h, kappa unchanged.
  std::optional<LatticeConstants> constants{};
};

/// A linear spring between two nodes, tension k (|d| - L).
struct Spring {
  NodeIndex a;
  NodeIndex b;
  double stiffness;    // k [N/m], summed over the cells that share it
  double rest_length;  // L [m]
};

/// A cell's own share of the lattice: a quarter of an edge, half a face diagonal.
struct Cell {
  CellNodes nodes;
  LatticeStiffness share;  // [N/m]
  double rest_volume;      // [m^3]
};

/// A mass-spring system with volume correction, at rest in the mesh's positions.
struct Network {
  std::vector<Vector3> rest_positions;  // [m]
  std::vector<Spring> springs;          // each pair of nodes once
  std::vector<Cell> cells;              // the same springs, cell by cell
  double volume_modulus;                // kappa [Pa]; 0 without correction
  std::vector<double> masses;           // [kg] rho V/8 per cell corner, Eq. 3.19
};

/// Why the method cannot treat this mesh and material, or nothing when it can: cells
/// must be cubes (to 1e-6 of their edge), and mss-baudet needs nu in (-1/4, 1/2).
std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Material& material,
                                            Method method);

/// Springs and correction cells of the mesh. Every cell adds k_e/4 to its edges, k_f/2
/// to its face diagonals, k_c to its inner diagonals, so that an edge of n cells gets
/// k_e n/4 and a boundary face diagonal k_f/2 without special cases (Golec 2018, 5.3).
/// The mesh must not be one that reason_to_refuse names.
Network build_network(const Mesh& mesh, const Material& material,
                      const NetworkSettings& settings);

}  // namespace springcheck::mss
