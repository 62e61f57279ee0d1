#pragma once

#include <optional>
#include <string>

#include "comparisons/cases/body.hpp"
#include "comparisons/cases/method.hpp"
#include "comparisons/cases/test.hpp"
#include "comparisons/names/named.hpp"
#include "mss/motion/dynamics.hpp"
#include "statics/search.hpp"
#include "tissue/bipower_law.hpp"

namespace springcheck {

/// How a body touches its plates: all components held, or the one along the normal.
enum class PlateContact { glued, sliding };

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

struct ElementSettings {
  ElementName element;
  LatticeName lattice;  // of fem-cauchy-born
  fem_reference::LatticeDirection lattice_direction;
};

/// The settings of methods of tissue.
struct Tissue {
  tissue::BipowerLaw law;
  int branches;
  int steps;  // of the quasi-static solver, on each straight piece of the load
};

template <>
inline constexpr std::array value_names<PlateContact>{
    Named{PlateContact::glued, "glued"}, Named{PlateContact::sliding, "sliding"}};
template <>
inline constexpr std::array value_names<mss::StiffnessForm>{
    Named{mss::StiffnessForm::shear_modulus, "mu"},
    Named{mss::StiffnessForm::young_modulus, "E"}};
template <>
inline constexpr std::array value_names<mss::VolumeCorrection>{
    Named{mss::VolumeCorrection::on, "on"}, Named{mss::VolumeCorrection::off, "off"}};
template <>
inline constexpr std::array value_names<mss::StrainMeasure>{
    Named{mss::StrainMeasure::engineering, "engineering"},
    Named{mss::StrainMeasure::green, "green"},
    Named{mss::StrainMeasure::logarithmic, "logarithmic"},
    Named{mss::StrainMeasure::hencky, "hencky"}};
template <>
inline constexpr std::array value_names<mss::Axes>{Named{mss::Axes::six, "6"},
                                                   Named{mss::Axes::sixteen, "16"},
                                                   Named{mss::Axes::twenty_five, "25"}};
template <>
inline constexpr std::array value_names<fem_reference::LatticeDirection>{
    Named{fem_reference::LatticeDirection::d100, "100"},
    Named{fem_reference::LatticeDirection::d110, "110"},
    Named{fem_reference::LatticeDirection::d111, "111"}};
template <>
inline constexpr std::array value_names<statics::LinearSolver>{
    Named{statics::LinearSolver::automatic, "auto"},
    Named{statics::LinearSolver::direct, "direct"},
    Named{statics::LinearSolver::conjugate_gradients, "conjugate-gradients"},
    Named{statics::LinearSolver::multigrid, "multigrid"}};

/// Everything that determines one simulation.
struct CaseSettings {
  std::string scene;
  Test test;
  Body body;
  Material material;
  Vector3 gravity = Vector3::Zero();   // [m/s^2]; zero but in bending
  Vector3 traction = Vector3::Zero();  // [Pa]; zero but in traction
  PlateContact plates;  // of the lower plate in traction; the test decides in others
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();  // H of u = H X; zero but in affine
  std::optional<double> deformation;  // strain, [rad] in torsion; none in bending,
                                      // traction and affine
  Method method;
  // The settings of springs, without their method; form and ratio are also those of
  // fem-cauchy-born's lattice:
  mss::NetworkSettings springs{};
  ElementSettings elements;
  std::optional<Solver> solver;  // none: the method's own
  Dynamics dynamics;             // of solvers through time, and tissue
  statics::Search search{};      // of static solvers; `solver` says whether to a limit
  Tissue tissue;                 // of methods of tissue
};

/// The case's springs with what is fixed, and without what its method does not read.
mss::NetworkSettings springs_of(const CaseSettings& settings, const FixedSprings& fixed);

/// The case under so much of its load: deformation, gravity, traction and gradient times
/// the fraction.
CaseSettings at_load(CaseSettings settings, double fraction);

/// The load fraction at which its path ends.
double last_load(const Dynamics& dynamics);

/// The case under the load at which its path ends, for methods at rest, which know no way
/// to it; for others, which go it themselves, the case as it is.
CaseSettings at_last_load(const CaseSettings& settings);

/// The case under the largest load of its path, whatever its sign; without a path, under
/// the fraction that it reached.
CaseSettings at_largest_load(const CaseSettings& settings, double reached);

/// Whether the load acts against the whole one at the fraction that was reached; where
/// that is 0, whether it did so when it acted last.
bool acts_backwards(const CaseSettings& settings, double reached);

/// The case under the whole load, in the direction in which it acts, or acted last.
CaseSettings in_last_direction(const CaseSettings& settings, double reached);

/// The case as one that others are held against, without noise on its solution.
CaseSettings without_noise(CaseSettings settings);

/// Whether anything deforms the body.
bool has_load(const CaseSettings& settings);

/// The solver given, or else the method's own; static where the method follows none.
Solver solver_of(const CaseSettings& settings);

/// Whether it solves with tangents: without inertia, or by implicit steps.
bool needs_tangents(const CaseSettings& settings);

/// Whether the case goes through time with inertia; and whether it has a history, which
/// some methods have without inertia too, by the static solver.
bool goes_through_time(const CaseSettings& settings);
bool has_history(const CaseSettings& settings);

/// Nodes along x, y, z, for estimates (equivalent_grid): those of the finite element,
/// where the method reads one.
std::array<double, 3> element_nodes(const CaseSettings& settings);

/// The case's method as tables call it: "fem-stvk:q1-sri" where it reads an element,
/// "mss-cf" where not.
std::string label(const CaseSettings& settings);

}  // namespace springcheck
