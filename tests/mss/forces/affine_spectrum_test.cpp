#include <boost/test/unit_test.hpp>

#include "tests/mss/any_cells.hpp"
#include "tests/mss/assembled.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(affine_spectrum_test)

namespace {

Eigen::VectorXd rest_spectrum(const Mesh& mesh, double nu) {
  const Network network =
      build_network(mesh, {.young_modulus = 1, .poisson_ratio = nu, .density = 1},
                    in_shear_modulus_form(SpringModel::affine));
  const Eigen::MatrixXd lower =
      lower_triangle(network, tangent_at(network, network.rest_positions),
                     std::vector<bool>(3 * mesh.nodes().size(), true));
  // Reads the lower triangle alone.
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(lower, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace

// The six rigid motions, to round-off of the largest eigenvalue (kappa is 333 mu at
// .499), and a clear gap above them.
BOOST_AUTO_TEST_CASE(free_body_at_rest_has_six_zero_modes_and_no_negative_one) {
  for (const int n : {1, 2})
    for (const auto& [name, mesh] : distorted_cubes(n, 1))
      for (const double nu :
           {-0.99, -0.5, -0.2, 0., 0.2, 0.25, 0.3, 0.45, 0.499, 0.4999}) {
        const Eigen::VectorXd spectrum = rest_spectrum(mesh, nu);
        BOOST_TEST_CONTEXT(n << "^3 " << name << ", nu = " << nu) {
          const double largest = spectrum[spectrum.size() - 1];
          BOOST_TEST(spectrum.head<6>().cwiseAbs().maxCoeff() < 1e-13 * largest);
          BOOST_TEST(spectrum[6] > 1e-3);
        }
      }
}

BOOST_AUTO_TEST_SUITE_END()
