#define BOOST_TEST_MODULE lattice_kernel
#include "mss/lattice_kernel.hpp"

#include <boost/test/unit_test.hpp>

#include "../dynamics/block_forces.hpp"
#include "../dynamics/shuffled_cells.hpp"
#include "blocks.hpp"
#include "mss/forces.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::even;
using dynamics::graded;
using dynamics::InstructionSet;
using dynamics::shuffled_cells;

namespace {

Material tissue(double nu) {
  return {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000};
}

/// Largest difference between the kernel's force on a node and the oracle's, over the
/// largest k L, with displacements of up to a tenth of a cell.
template <class Real>
double difference(const Mesh& mesh, const Network& network, double damping_ratio,
                  InstructionSet set) {
  constexpr double h = 0.005;
  std::vector<Vector3> u = random_field(mesh.nodes().size(), 0.1 * h, 1),
                       v = random_field(mesh.nodes().size(), 0.01, 2);
  for (Vector3& a : u) a = a.cast<Real>().template cast<double>();
  for (Vector3& a : v) a = a.cast<Real>().template cast<double>();
  const std::vector<Vector3> x = sum(mesh.nodes(), u);
  std::vector<Vector3> expected(x.size());
  nodal_forces(network, x, expected);
  if (damping_ratio > 0) add_dashpot_forces(network, damping_ratio, x, v, expected);
  const auto blocks = dynamics::grid_blocks(dynamics::grid_of(mesh).value());
  const auto found = dynamics::summed_forces<Real>(
      blocks, lattice_kernel<Real>(network, blocks, damping_ratio, set), u, v,
      network.masses);
  double largest = 0, scale = 0;
  for (std::size_t n = 0; n < x.size(); ++n)
    largest = std::max(largest, (found[n] - expected[n]).norm());
  for (const Spring& spring : network.springs)
    scale = std::max(scale, spring.stiffness * spring.rest_length);
  return largest / scale;
}

/// Calls check(mesh, name) for a regular cube, loose random cells, and boxes of all
/// sizes.
template <class Check>
void on_meshes(const Check& check) {
  constexpr double h = 0.005;
  check(cube(10, h), "cube");
  check(shuffled_cells({even(13, h), even(12, h), even(11, h)}, 0.6, 1), "random cells");
  check(shuffled_cells({even(21, h), even(2, h), even(1, h)}, 0.9, 2), "plate");
  check(shuffled_cells({graded(9, h), even(10, h), graded(12, h)}, 0.8, 3), "boxes");
}

}  // namespace

// The bound is the issue's: a few units of rounding of k L, magnified by kappa/mu = 7 at
// nu = .45 and 50 at .49. Boxes of any edges are covered by mss-cf alone.
BOOST_AUTO_TEST_CASE(kernels_equal_the_plain_loops) {
  on_meshes([](const Mesh& mesh, const std::string& name) {
    for (const auto& [method_name, method] : methods)
      for (const double nu : {0., .25, .45, .49}) {
        if (reason_to_refuse(mesh, tissue(nu), method)) continue;
        const Network network =
            build_network(mesh, tissue(nu), in_shear_modulus_form(method));
        for (const InstructionSet set : dynamics::all_instruction_sets) {
          if (!dynamics::is_available(set)) continue;
          for (const double zeta : {0., .3})
            BOOST_TEST_CONTEXT(name << ", " << method_name << ", nu " << nu << ", "
                                    << dynamics::name_of(set) << ", zeta " << zeta) {
              BOOST_TEST(difference<double>(mesh, network, zeta, set) < 1e-13);
              BOOST_TEST(difference<float>(mesh, network, zeta, set) < 2e-6);
            }
        }
      }
  });
}
