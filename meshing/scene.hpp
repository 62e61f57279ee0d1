#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

struct Material {
  double young_modulus;  // [Pa], positive
  double poisson_ratio;  // [-], in (-1, 1/2)
  double density;        // [kg/m^3], positive
};

/// Lame's constants [Pa]: mu = E/(2(1+nu)), lambda = E nu/((1+nu)(1-2nu)).
struct LameConstants {
  double lambda;
  double mu;
};
LameConstants lame_constants(const Material& material);

/// Rigid motion of a plate, driven by the load fraction s in [0, 1]: a rotation by
/// s * angle about the axis through the centre, then a translation by s * translation.
struct RigidMotion {
  Vector3 translation;  // [m]
  Vector3 axis;         // unit vector
  Vector3 centre;       // [m]
  double angle;         // [rad]
};

/// Displacement of the material point X at load fraction s [m].
Vector3 displacement(const RigidMotion& motion, const Vector3& point,
                     double load_fraction);

/// A region of the mesh glued to a rigid plate: all three components are prescribed.
struct Plate {
  std::string region;
  RigidMotion motion;
};

/// One mechanical problem, as both solvers receive it together with a Mesh.
struct Scene {
  Material material;
  std::vector<Plate> plates;
  Vector3 gravity;  // [m/s^2], applied in proportion to the load fraction
};

/// How a solver ended. The meaning of each is fixed by the command-line interface.
enum class SolveStatus {
  ok,              // equilibrium, tangent positive definite
  indefinite,      // equilibrium, tangent not positive definite
  no_equilibrium,  // a limit point before the full load
  diverged,        // dynamics blew up
  not_converged,   // the solver gave up short of the full load
  refused          // the method does not cover this scene or value
};

/// Configuration in which a plate's lever arms are taken.
enum class LeverArms { undeformed, deformed };

/// What a solver returns. Vectors hold one entry per node of the mesh.
struct Solution {
  SolveStatus status;
  std::string reason;  // why; with ok, what was passed on the way
  // [m] of the last state reached; empty when refused:
  std::vector<Vector3> displacements;
  // [N] what the plates apply to the body, 0 on free nodes:
  std::vector<Vector3> reactions;
  LeverArms lever_arms;
  double strain_energy;              // [J]
  double load_fraction;              // reached, 1 = all of it
  int steps;                         // load steps or time steps
  int force_evaluations;             // of the whole internal force vector
  std::optional<double> dt{};        // [s] dynamics only
  std::optional<double> dt_limit{};  // [s] dynamics only: largest stable step at rest
};

/// The Solution of a method that does not cover the scene.
Solution refused(const std::string& reason);

/// A node held by a plate, the plate's index in Scene::plates.
struct PrescribedNode {
  NodeIndex node;
  std::size_t plate;
};

/// Nodes held by plates, ascending. Throws InputError when two plates share one, or a
/// plate's region is not in the mesh.
std::vector<PrescribedNode> prescribed_nodes(const Mesh& mesh, const Scene& scene);

}  // namespace springcheck
