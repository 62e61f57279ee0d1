#include <boost/test/unit_test.hpp>

#include "mss/statics/equilibrium.hpp"
#include "tests/mss/any_cells.hpp"

// The patch test: a body whose whole boundary follows an affine displacement follows it
// inside, whatever its cells.

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(affine_patch_test)

// Residuals of 1e-10 of the forces, which at nu = .499 are 1000 times those that the
// inner nodes' moves make: positions are good to 1e-10 of the body.
BOOST_AUTO_TEST_CASE(body_of_any_cells_follows_an_affine_boundary) {
  constexpr double h = 0.01;  // [m]
  std::mt19937 random(1);
  std::uniform_real_distribution<double> entry(-0.1, 0.1);
  for (const auto& [name, mesh] : distorted_cubes(3, h))
    for (const double nu : {0., 0.25, 0.45, 0.499}) {
      Eigen::Matrix3d H;
      for (double& value : H.reshaped()) value = entry(random);
      const Scene scene{
          .material = {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000},
          .plates = {},
          .boundary_gradient = H,
          .gravity = Vector3::Zero()};
      const Network network =
          build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::affine));
      const Solution solution = find_equilibrium(mesh, scene, network);
      BOOST_TEST((solution.status == SolveStatus::ok), name << ": " << solution.reason);
      double worst = 0;
      for (std::size_t n = 0; n < mesh.nodes().size(); ++n)
        worst = std::max(worst, (solution.displacements[n] - H * mesh.nodes()[n]).norm());
      BOOST_TEST(worst < 1e-10 * 3 * h, name << ", nu = " << nu << ": " << worst);
    }
}

BOOST_AUTO_TEST_SUITE_END()
