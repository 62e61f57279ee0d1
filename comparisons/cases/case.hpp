#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "comparisons/cases/body.hpp"
#include "comparisons/cases/methods.hpp"
#include "mss/solve.hpp"
#include "tissue/bipower_law.hpp"

namespace springcheck {

/// The deformation tests; mechanical_scene says what holds and loads the body.
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

/// How the deformed state is found: at once, or through time.
enum class Solver {
  static_equilibrium,
  path_limit,  // static too: to where the path loses its stability
  explicit_euler,
  semi_implicit_euler,
  verlet,
  implicit_euler
};

/// A load that swings, sin(omega t), for so many cycles.
struct Oscillation {
  double angular_frequency;  // omega [rad/s]
  double cycles;
};

struct Dynamics {
  double duration;                  // [s] over which the load acts
  std::optional<double> time_step;  // [s]; none: step_ratio of the stability limit
  double step_ratio;
  bool force_time_step;  // run even above the stability limit
  double damping_ratio;  // zeta of critical
  mss::Precision precision;
  int history;                // samples on the way, on each straight piece of the load
  dynamics::LoadPath load{};  // none: it grows in proportion to the time
  std::optional<Oscillation> oscillation{};  // whose path the load is
};

/// Of methods of tissue.
struct Tissue {
  tissue::BipowerLaw law;
  int branches;
  int steps;  // of the quasi-static solver, on each straight piece of the load
};

const std::vector<Test>& all_tests();

/// Whether the body stands on a plate; whether there is one on it that is moved or
/// loaded.
bool has_lower_plate(Test test);
bool has_upper_plate(Test test);

std::string_view name_of(Test test);
std::string_view name_of(PlateContact contact);
std::string_view name_of(Solver solver);
std::string_view name_of(mss::Precision precision);
std::string_view name_of(mss::StiffnessForm form);
std::string_view name_of(mss::VolumeCorrection correction);
std::string_view name_of(fem_reference::LatticeDirection direction);
std::string_view name_of(fem_reference::LinearSolver solver);

/// Everything that determines one simulation.
struct CaseSettings {
  std::string scene;
  Test test;
  Body body;
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
  // Springs, from `solver` on explicit elements too:
  std::optional<mss::LatticeConstants> constants;  // of mss-custom, at this cell size
  mss::VolumeCorrection correction;                // of mss-vangelder and mss-lloyd
  std::optional<Solver> solver;                    // none: the method's own
  Dynamics dynamics;                               // of solvers through time, and tissue
  unsigned seed;                                   // of the static solver
  double noise;  // [cell edges] of a static solution, which is solved again from there
  std::optional<Tissue> tissue{};  // where tissue runs
};

/// The solver given, or else the static one, and of explicit elements semi-implicit
/// Euler; the other finite elements are static anyway.
Solver solver_of(const CaseSettings& settings);

/// With inertia. Tissue has a history without, by the static solver.
bool goes_through_time(const CaseSettings& settings);
bool has_history(const CaseSettings& settings);

/// The finite elements' part of the settings.
fem_reference::Settings reference_settings(const CaseSettings& settings);

/// The scene's name and the settings its method reads, and no others, as JSON: a setting
/// that cannot change the result does not change it. What was measured has instead
/// "source": "measured" and the SHA-256 of its numbers, "displacements" and "forces".
nlohmann::json settings_json(const CaseSettings& settings);

/// "fem-stvk:q1-sri" for finite elements, "mss-cf" for springs and likewise for others.
std::string label(const CaseSettings& settings);

}  // namespace springcheck
