#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

// A second opinion from CalculiX. Nothing here uses the program's own code: mesh and
// result are read from files.
namespace referee {

using Vector3 = Eigen::Vector3d;

/// Nodes [m] and C3D8 cells of an .inp file that numbers both 1, 2, 3, ...; here from 0.
struct InpMesh {
  std::vector<Vector3> nodes;
  std::vector<std::array<std::size_t, 8>> cells;
};
InpMesh read_inp(const std::filesystem::path& file);

/// Volume of all cells with their nodes at `positions` [m^3]. Exact: the Jacobian
/// determinant of a trilinear map is quadratic in each coordinate, and two Gauss points
/// a coordinate integrate cubics.
double volume(const InpMesh& mesh, const std::vector<Vector3>& positions);

/// linear: small strain (Hooke). nlgeom: Green-Lagrange strain and the second
/// Piola-Kirchhoff stress, which makes *ELASTIC the law of St-Venant and Kirchhoff.
enum class Kinematics { linear, nlgeom };

struct HeldSet {
  std::string set;
  Vector3 displacement;  // [m]
};

struct Pressure {
  std::string surface;
  double value;  // [Pa], into the body
};

/// What CalculiX is asked to solve on a mesh file of node sets and surfaces.
struct Problem {
  Kinematics kinematics;
  double young_modulus;  // [Pa]
  double poisson_ratio;
  std::vector<HeldSet> held;
  std::vector<Pressure> pressures;
  std::string reaction_of;  // set whose reaction is asked for
};

/// Seven significant digits each.
struct Equilibrium {
  std::vector<Vector3> displacements;  // [m], one per node
  Vector3 reaction;                    // [N] of the supports on the body
};

/// Appends the problem to the mesh file, runs `program` on one thread in the file's
/// folder and reads what it printed. Throws std::runtime_error with the reason when it
/// cannot be run or did not reach the full load.
Equilibrium solve(const std::filesystem::path& mesh_file, const Problem& problem,
                  const std::string& program = "ccx");

}  // namespace referee
