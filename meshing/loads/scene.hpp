#pragma once

#include <array>
#include <cstdint>
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

/// K = lambda + 2 mu/3 [Pa].
double bulk_modulus(const LameConstants& lame);

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

/// Components of a displacement that are prescribed.
using Held = std::array<bool, 3>;
inline constexpr Held all_components{true, true, true};

/// A region of the mesh on a rigid plate: all three components follow it where the body
/// is glued, only the one along its normal where the body slides.
struct Plate {
  std::string region;
  RigidMotion motion;
  Held held;
};

/// A material point (a node of the mesh, the nearest to `point`) that stays where it is
/// in some components: takes away the rigid motions that sliding plates leave.
struct Pin {
  Vector3 point;  // [m]
  Held held;
};

/// Uniform dead load on a region, in proportion to the load fraction.
struct Traction {
  std::string region;
  Vector3 stress;  // force per undeformed area [Pa]
};

/// One mechanical problem, as both solvers receive it together with a Mesh.
struct Scene {
  Material material;
  std::vector<Plate> plates{};
  std::vector<Pin> pins{};
  std::vector<Traction> tractions{};
  // Displacement gradient H that the whole boundary follows, u = s H X:
  std::optional<Eigen::Matrix3d> boundary_gradient{};
  Vector3 gravity;  // [m/s^2], applied in proportion to the load fraction
};

/// How a solver ended. Whether a state wrinkles no solver judges: `springcheck run` does,
/// by measures of the solution, and tells `wrinkled` where this is ok.
enum class SolveStatus {
  ok,              // equilibrium, tangent positive definite
  indefinite,      // equilibrium, tangent not positive definite
  no_equilibrium,  // the path from rest ends before the full load
  inverted,        // a cell is turned inside out before the full load
  diverged,        // dynamics blew up
  not_converged,   // the solver gave up short of the full load
  refused          // the method does not cover this scene or value
};

/// Configuration in which a plate's lever arms are taken.
enum class LeverArms { undeformed, deformed };

/// What a solver returns. Vectors hold one entry per node of the mesh.
struct Solution {
  SolveStatus status;
  std::string reason{};  // why; with ok, what was passed on the way
  // The displacements of the last state reached [m]; empty when refused:
  std::vector<Vector3> displacements{};
  // What the supports apply to the body [N], 0 in free components; loads are not in it:
  std::vector<Vector3> reactions{};
  LeverArms lever_arms;
  double strain_energy;   // [J]
  double load_fraction;   // reached, 1 = all of it
  int steps;              // load steps or time steps
  int force_evaluations;  // of the whole internal force vector
  // Load fraction up to which the tangent was positive definite, where it was lost:
  std::optional<double> definite_up_to{};
  // The wavelength of the mode that becomes unstable where the path ends [-], see
  // shortest_wavelength:
  std::optional<double> critical_wavelength{};
  std::optional<int> linear_iterations{};  // of the iterative linear solver, all together
  std::optional<int> factorisations{};     // of the direct one, all together
  // The time before the first load step [s]: network or discretisation, patterns of
  // matrices, and through time the first look at the stability limit:
  double setup_wall_s = 0;
  // The deformed volume of each cell [m^3]; empty where the field in a cell is trilinear:
  // then it is that of cell_volumes() of meshing/cell_geometry.hpp at the deformed
  // positions:
  std::vector<double> cell_volumes{};
  // The strain l/L - 1 of each cell's most strained spring [-]; empty for methods without
  // springs:
  std::vector<double> spring_strains{};
  // The mean int u dA/A over the undeformed face of each of the scene's tractions [m];
  // empty where the mesh's nodes tell it:
  std::vector<Vector3> loaded_face_displacements{};
  std::optional<double> kinetic_energy{};  // [J] dynamics only
  std::optional<double> dt{};              // [s] dynamics only: of the last step
  std::optional<double> dt_limit{};        // [s] dynamics only: the last one looked at
  // The largest shear strain of any cell on the way [-], for tissue only; in simple shear
  // it is the strain:
  std::optional<double> largest_shear_strain{};
  // What of the way is outside the range that the law was fitted to; empty if nothing:
  std::string extrapolation{};
};

/// The Solution of a method that does not cover the scene.
Solution refused(const std::string& reason);

/// Adds to what a reason says already, if anything, after a semicolon; an empty one adds
/// nothing.
void add_reason(std::string& reason, const std::string& more);

/// A displacement component that the scene prescribes.
struct PrescribedComponent {
  NodeIndex node;
  std::uint8_t component;            // 0, 1, 2
  std::optional<std::size_t> plate;  // index in Scene::plates; none: pin or boundary
};

/// What plates, pins and boundary_gradient prescribe, by node and component, ascending.
/// Throws InputError when one component is prescribed twice, or a region is not in the
/// mesh.
std::vector<PrescribedComponent> prescribed_components(const Mesh& mesh,
                                                       const Scene& scene);

/// The prescribed displacement at load fraction s [m].
double prescribed_displacement(const Mesh& mesh, const Scene& scene,
                               const PrescribedComponent& prescribed,
                               double load_fraction);

/// For each component of each node, 3 node + component, whether nothing prescribes it.
std::vector<bool> free_components(const Mesh& mesh,
                                  const std::vector<PrescribedComponent>& prescribed);

}  // namespace springcheck
