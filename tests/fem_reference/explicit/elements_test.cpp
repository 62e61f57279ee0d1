#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "fem_reference/explicit/hexahedra.hpp"
#include "fem_reference/explicit/plain_forces.hpp"
#include "fem_reference/solve.hpp"
#include "meshing/cell_geometry.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/fem_reference/explicit/fields.hpp"
#include "tests/fem_reference/laws.hpp"

// The elements by plain loops.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(elements_test)

namespace {

const LameConstants lame = lame_constants(of_poisson_ratio(0.3));

std::vector<Mesh> meshes() {
  std::vector<Mesh> all;
  all.push_back(cube(3));
  all.push_back(distorted_cube(3, 0.2, Moved::all_nodes));
  all.push_back(cube(2, CellPattern::free_hexahedron));
  return all;
}

Eigen::Matrix3d some_gradient() {
  Eigen::Matrix3d gradient;
  gradient << 0.1, -0.2, 0.05, 0.3, 0.15, -0.1, 0.02, 0.25, -0.2;
  return gradient;
}

}  // namespace

// Any homogeneous deformation is an equilibrium of the inner nodes, and by S = lambda
// tr(E) I + 2 mu E the energy is the volume's times that of the law. The tolerance is
// round-off.
BOOST_AUTO_TEST_CASE(affine_displacements_are_exact_on_any_hexahedra) {
  const Eigen::Matrix3d gradient = some_gradient();
  const Eigen::Matrix3d strain =
      (gradient + gradient.transpose() + gradient.transpose() * gradient) / 2;
  const double density =
      lame.lambda / 2 * strain.trace() * strain.trace() + lame.mu * strain.squaredNorm();
  for (const Mesh& mesh : meshes())
    for (const ExplicitElement element : explicit_elements) {
      const auto u = at_nodes(mesh, [&](const Vector3& x) -> Vector3 {
        return gradient * x + Vector3(1, 2, 3);
      });
      const auto forces = plain_forces(mesh, lame, element, u);
      std::vector<Vector3> inside = forces;
      for (const NodeIndex node : mesh.boundary().nodes) inside[node].setZero();
      BOOST_TEST(longest(inside) < 1e-12 * longest(forces));
      BOOST_TEST(plain_energy(mesh, lame, element, u) == density * mesh.volume(),
                 boost::test_tools::tolerance(1e-12));
    }
}

// Forces of a turned body are the turned forces, those of one that only turns are zero:
// the hourglass control's too.
BOOST_AUTO_TEST_CASE(forces_turn_with_the_body) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2, Vector3(1, -2, 3).normalized()).toRotationMatrix();
  for (const Mesh& mesh : meshes())
    for (const ExplicitElement element : explicit_elements) {
      const auto u = random_at_nodes(mesh, 0.1 * edge / 3, 3);
      const auto forces = plain_forces(mesh, lame, element, u);
      std::vector<Vector3> turned = u, only_turned = u;
      for (std::size_t n = 0; n < u.size(); ++n) {
        const Vector3& x = mesh.nodes()[n];
        turned[n] = turn * (x + u[n]) - x;
        only_turned[n] = turn * x - x;
      }
      const auto forces_then = plain_forces(mesh, lame, element, turned);
      for (std::size_t n = 0; n < u.size(); ++n)
        BOOST_TEST((forces_then[n] - turn * forces[n]).norm() < 1e-12 * longest(forces));
      BOOST_TEST(longest(plain_forces(mesh, lame, element, only_turned)) <
                 1e-12 * longest(forces));
    }
}

// The forces are compared with central differences of the energy, whose error is the h^2
// = 1e-10 of a quartic.
BOOST_AUTO_TEST_CASE(forces_are_the_derivative_of_the_energy) {
  const Mesh mesh = distorted_cube(1, 0.2, Moved::all_nodes);
  const double step = 1e-5 * edge;
  for (const ExplicitElement element : explicit_elements) {
    auto u = random_at_nodes(mesh, 0.1 * edge, 3);
    const auto forces = plain_forces(mesh, lame, element, u);
    for (std::size_t n = 0; n < u.size(); ++n)
      for (int i = 0; i < 3; ++i) {
        const double here = u[n][i];
        u[n][i] = here + step;
        const double ahead = plain_energy(mesh, lame, element, u);
        u[n][i] = here - step;
        const double behind = plain_energy(mesh, lame, element, u);
        u[n][i] = here;
        BOOST_TEST(std::abs(forces[n][i] + (ahead - behind) / (2 * step)) <
                   1e-8 * longest(forces));
      }
  }
}

// Six eigenvalues of a single element's tangent are zero, those of the rigid motions:
// hourglass control leaves no other.
BOOST_AUTO_TEST_CASE(only_rigid_motions_cost_nothing) {
  for (const Mesh& mesh : {cube(1), distorted_cube(1, 0.2, Moved::all_nodes)})
    for (const ExplicitElement element : explicit_elements) {
      const double step = 1e-6 * edge;
      Eigen::Matrix<double, 24, 24> tangent;
      for (Eigen::Index column = 0; column < 24; ++column) {
        std::vector<Vector3> u(8, Vector3::Zero());
        const auto node = static_cast<std::size_t>(column / 3);
        u[node][column % 3] = step;
        const auto ahead = plain_forces(mesh, lame, element, u);
        u[node][column % 3] = -step;
        const auto behind = plain_forces(mesh, lame, element, u);
        for (Eigen::Index row = 0; row < 24; ++row) {
          const auto other = static_cast<std::size_t>(row / 3);
          tangent(row, column) =
              (behind[other][row % 3] - ahead[other][row % 3]) / (2 * step);
        }
      }
      const Eigen::Matrix<double, 24, 1> eigenvalues =
          Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 24, 24>>(tangent)
              .eigenvalues();
      for (Eigen::Index i = 0; i < 6; ++i)
        BOOST_TEST(std::abs(eigenvalues[i]) < 1e-8 * eigenvalues[23]);
      BOOST_TEST(eigenvalues[6] > 0.01 * eigenvalues[23]);
    }
}

// u_x = c xi eta bends a cube of edge h, u_x = c eta zeta shears it: W = mu/2 8/3 h c^2.
// For the latter it is the integral over the cube, which eight points have too.
BOOST_AUTO_TEST_CASE(hourglass_modes_of_a_cube_have_their_energies,
                     *boost::unit_test::tolerance(1e-10)) {
  const Mesh mesh = cube(1);
  const double c = 1e-7 * edge;
  const auto in_mode = [&](std::size_t s) {
    return at_nodes(mesh, [&](const Vector3& x) -> Vector3 {
      return {c * mode(s, 2 / edge * x - Vector3::Ones()), 0, 0};
    });
  };
  for (const std::size_t s : {3U, 5U, 6U})
    BOOST_TEST(plain_energy(mesh, lame, ExplicitElement::one_point, in_mode(s)) ==
               lame.mu / 2 * 8 / 3 * edge * c * c);
  BOOST_TEST(plain_energy(mesh, lame, ExplicitElement::eight_points, in_mode(6)) ==
                 lame.mu / 2 * 8 / 3 * edge * c * c,
             boost::test_tools::tolerance(1e-6));
}

// Both plates of a flat body hold all its nodes, in a state that is not homogeneous:
// deal.II's reactions are the nodal forces of its element q1. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(eight_points_are_the_implicit_solvers_q1) {
  const Mesh mesh = mapped(
      generate_block({.size = {edge, edge, edge / 3}, .cells = {3, 3, 1}}),
      [](const Vector3& x) -> Vector3 {
        return x + 0.1 * edge / 3 *
                       Vector3(std::sin(200 * x.y()), std::sin(150 * x.z() + 60 * x.x()),
                               std::sin(120 * x.x()));
      });
  const Material material = of_poisson_ratio(0.3);
  const RigidMotion turn{.translation = {0.1 * edge, 0, -0.05 * edge},
                         .axis = Vector3(1, 2, 8).normalized(),
                         .centre = {edge / 2, edge / 2, edge / 3},
                         .angle = 0.3};
  const Scene scene{.material = material,
                    .plates = {{"bottom", moved_by({0, 0, 0}), all_components},
                               {"top", turn, all_components}},
                    .gravity = Vector3::Zero()};
  const Solution solution =
      solve(mesh, scene, {.law = Law::st_venant_kirchhoff, .element = Element::q1});
  BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
  const auto forces =
      plain_forces(mesh, lame, ExplicitElement::eight_points, solution.displacements);
  for (std::size_t n = 0; n < forces.size(); ++n)
    BOOST_TEST((forces[n] + solution.reactions[n]).norm() < 1e-12 * longest(forces));
  BOOST_TEST(plain_energy(mesh, lame, ExplicitElement::eight_points,
                          solution.displacements) == solution.strain_energy,
             boost::test_tools::tolerance(1e-12));
}

// sum_a int N_a = V and sum_a X_a int N_a = int X, whose centroid the mesh tells by
// another way; of a parallelepiped all are V/8.
BOOST_AUTO_TEST_CASE(lumped_masses_have_the_cells_mass_and_centre) {
  const Mesh mesh = distorted_cube(1, 0.2, Moved::all_nodes);
  const auto masses = lumped_masses(mesh, 1000);
  double mass = 0;
  Vector3 moment = Vector3::Zero();
  for (std::size_t n = 0; n < 8; ++n) {
    mass += masses[n];
    moment += masses[n] * mesh.nodes()[n];
  }
  BOOST_TEST(mass == 1000 * mesh.volume(), boost::test_tools::tolerance(1e-13));
  const Vector3 centroid = cell_centroid(corners(mesh.cells()[0], mesh.nodes()));
  BOOST_TEST((moment / mass - centroid).norm() < 1e-13 * edge);
  for (const double m : lumped_masses(cube(1), 1000))
    BOOST_TEST(m == 125 * edge * edge * edge, boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_SUITE_END()
