#include <boost/test/unit_test.hpp>

#include "mss/forces/forces.hpp"
#include "mss/statics/equilibrium.hpp"
#include "tests/mss/blocks.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(large_equilibrium_test)

// 30^3 cells, 84,000 unknowns: solved iteratively. The plate's force is as
// recorded of this program's direct solver; residuals of 1e-10 leave it about eight
// digits.
BOOST_AUTO_TEST_CASE(large_block_is_in_balance) {
  constexpr double side = 0.05, strain = 0.05;  // [m]
  const Mesh mesh = cube(30, side / 30);
  for (const double nu : {0.25, 0.499}) {
    const Scene scene{
        .material = {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000},
        .plates = {{"bottom", translation(Vector3::Zero()), all_components},
                   {"top", translation({0, 0, -strain * side}), all_components}},
        .gravity = Vector3::Zero()};
    const Network network =
        build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::cf));
    const Solution solution = find_equilibrium(mesh, scene, network);
    BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
    BOOST_TEST(solution.linear_iterations.has_value());
    std::vector<Vector3> forces(mesh.nodes().size());
    nodal_forces(network, sum(mesh.nodes(), solution.displacements), forces);
    BOOST_TEST(norm(sum(forces, solution.reactions)) < 1e-10 * norm(forces));
    BOOST_TEST(total(solution.reactions).norm() < 1e-9 * norm(solution.reactions));
    double force = 0;
    for (const NodeIndex node : mesh.region("top").nodes)
      force -= solution.reactions[node].z();
    BOOST_TEST(force == (nu == 0.25 ? 1.268763156 : 1.602229129),
               boost::test_tools::tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_SUITE_END()
