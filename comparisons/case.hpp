#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "comparisons/methods.hpp"
#include "meshing/gmsh.hpp"
#include "mss/solve.hpp"

namespace springcheck {

/// The deformation tests. The body is a block with its axis along z; mechanical_scene
/// says what holds and loads it.
enum class Test {
  compression,
  tension,
  shearing,
  torsion,
  bending,
  uniaxial,
  traction,
  affine
};

/// How a body touches its plates: all components held, or the one along the normal.
enum class PlateContact { glued, sliding };

const std::vector<Test>& all_tests();

std::string_view name_of(Test test);
std::string_view name_of(PlateContact contact);
std::string_view name_of(mss::Solver solver);
std::string_view name_of(mss::StiffnessForm form);
std::string_view name_of(fem_reference::LatticeDirection direction);
std::string_view name_of(fem_reference::LinearSolver solver);

/// Everything that determines one simulation.
struct CaseSettings {
  std::string scene;
  Test test;
  Block block;
  Material material;
  Vector3 gravity;           // [m/s^2]; zero but in bending
  Vector3 traction;          // [Pa]; zero but in traction
  PlateContact plates;       // of the lower plate in traction; the test decides in others
  Eigen::Matrix3d gradient;  // H of u = H X; zero but in affine
  std::optional<double> deformation;  // strain, [rad] in torsion; none in bending,
                                      // traction and affine
  Method method;
  // Springs, and the lattice of fem-cauchy-born:
  mss::StiffnessForm stiffness_form;
  double diagonal_ratio;
  // Finite elements:
  ElementName element;
  fem_reference::LinearSolver linear_solver;
  LatticeName lattice;  // of fem-cauchy-born
  fem_reference::LatticeDirection lattice_direction;
  // Springs:
  std::optional<mss::LatticeConstants> constants;  // of mss-custom, at this cell size
  mss::Solver solver;
  mss::DynamicsSettings dynamics;  // of the semi-implicit solver
  unsigned seed;                   // of the static solver
};

/// The case as both solvers receive it.
///
///     compression, tension   glued plates; the upper one moves along -z, +z by
///                            deformation * height
///     shearing               glued plates; the upper one moves along +x by as much
///     torsion                glued plates; the upper one turns about +z, through its
///                            centre
///     bending                one glued plate; gravity acts
///     uniaxial               sliding plates; the upper one moves along z by deformation
///                            * height, up if positive
///     traction               one plate, glued or sliding; a uniform dead traction acts
///     on
///                            the upper face
///     affine                 no plate; the whole boundary follows u = H X
///
/// Sliding plates hold z only. Pins take away the rigid motions they leave: the corner at
/// the origin keeps x and y, the one at (size_x, 0, 0) y.
Scene mechanical_scene(const CaseSettings& settings);

/// The finite elements' part of the settings.
fem_reference::Settings reference_settings(const CaseSettings& settings);

/// The scene's name and the settings its method reads, and no others, as JSON: a setting
/// that cannot change the result does not change it. What was measured has instead
/// "source": "measured" and the SHA-256 of its numbers, "displacements" and "forces".
nlohmann::json settings_json(const CaseSettings& settings);

/// "fem-stvk:q1-sri" for finite elements, "mss-cf" for springs and likewise for others.
std::string label(const CaseSettings& settings);

}  // namespace springcheck
