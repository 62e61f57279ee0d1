#include "fem_reference/explicit/explicit_kernel.hpp"

#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>

#include "fem_reference/explicit/explicit_dynamics.hpp"
#include "fem_reference/explicit/plain_forces.hpp"
#include "tests/dynamics/blocks/block_forces.hpp"
#include "tests/dynamics/blocks/shuffled_cells.hpp"
#include "tests/fem_reference/explicit/fields.hpp"
#include "tests/fem_reference/laws.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;
using dynamics::even;
using dynamics::graded;
using dynamics::InstructionSet;
using dynamics::shuffled_cells;

BOOST_AUTO_TEST_SUITE(kernel_test)

namespace {

using Blocks = std::vector<dynamics::Block>;

constexpr double h = 0.005;  // m, the cells' edge

Mesh turned_and_sheared(const Mesh& mesh) {
  Eigen::Matrix3d map;
  map << 1, 0.3, 0, 0, 1.1, -0.2, 0, 0, 0.9;
  map = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()) * map;
  return mapped(mesh, [&](const Vector3& x) -> Vector3 { return map * x; });
}

/// Calls check(mesh, name) for boxes, parallelepipeds, single cells of a grid, cells of
/// any shape in a grid and cells in no grid.
template <class Check>
void on_meshes(const Check& check) {
  const Mesh boxes = shuffled_cells({even(9, h), even(8, 1.5 * h), even(7, h)}, 0.6, 1);
  check(cube(10), "cube");
  check(boxes, "random boxes");
  check(turned_and_sheared(boxes), "random parallelepipeds");
  check(shuffled_cells({graded(9, h), even(10, h), graded(12, h)}, 0.8, 3), "graded");
  check(cube(10, CellPattern::hexahedron, 0.2), "distorted cube");
  check(cube(4, CellPattern::free_hexahedron), "free hexahedra");
}

Blocks blocks_of(const Mesh& mesh) {
  const auto grid = dynamics::grid_of(mesh);
  return grid ? dynamics::grid_blocks(*grid) : dynamics::free_blocks(mesh);
}

/// Largest difference between the kernel's force on a node and the plain loops', over the
/// longest of these, with displacements of up to a tenth of a cell.
template <class Real>
double difference(const Mesh& mesh, const Material& material, ExplicitElement element,
                  const Blocks& blocks, double rate, InstructionSet set) {
  const double size = 0.1 * mesh.mean_cell_edge();
  std::vector<Vector3> u = random_at_nodes(mesh, size, 1),
                       v = random_at_nodes(mesh, 0.1, 2);
  for (Vector3& a : u) a = a.cast<Real>().template cast<double>();
  for (Vector3& a : v) a = a.cast<Real>().template cast<double>();
  const std::vector<double> masses = lumped_masses(mesh, material.density);
  std::vector<Vector3> expected =
      plain_forces(mesh, lame_constants(material), element, u);
  for (std::size_t n = 0; n < u.size(); ++n) expected[n] -= rate * masses[n] * v[n];
  const auto found = dynamics::summed_forces<Real>(
      blocks, explicit_kernel<Real>(mesh, material, element, blocks, rate, set), set,
      {u, v}, masses);
  double largest = 0;
  for (std::size_t n = 0; n < u.size(); ++n)
    largest = std::max(largest, (found[n] - expected[n]).norm());
  return largest / longest(expected);
}

}  // namespace

// The tolerance is round-off of a few hundred operations in each type.
BOOST_AUTO_TEST_CASE(kernels_equal_the_plain_loops) {
  on_meshes([](const Mesh& mesh, const std::string& name) {
    const Blocks blocks = blocks_of(mesh);
    for (const ExplicitElement element : explicit_elements)
      for (const double nu : {0., .25, .499})
        for (const InstructionSet set : dynamics::all_instruction_sets) {
          if (!dynamics::is_available(set)) continue;
          for (const double rate : {0., 100.})
            BOOST_TEST_CONTEXT(name << ", " << words(element) << ", nu " << nu << ", "
                                    << dynamics::name_of(set) << ", drag " << rate) {
              const Material material = of_poisson_ratio(nu);
              BOOST_TEST(difference<double>(mesh, material, element, blocks, rate, set) <
                         1e-13);
              BOOST_TEST(difference<float>(mesh, material, element, blocks, rate, set) <
                         2e-6);
            }
        }
  });
}

// It does not matter in which of the two ways a block's nodes are read.
BOOST_AUTO_TEST_CASE(cells_of_a_grid_need_no_grid) {
  const Mesh mesh = cube(8, CellPattern::hexahedron, 0.2);
  for (const ExplicitElement element : explicit_elements)
    BOOST_TEST(difference<double>(mesh, of_poisson_ratio(.25), element,
                                  dynamics::free_blocks(mesh), 0,
                                  dynamics::best_instruction_set()) < 1e-13);
}

// Strains of 1e-9 keep their digits: (F^T F - I)/2 would leave seven of them, and four of
// a float's none.
BOOST_AUTO_TEST_CASE(small_strains_keep_their_digits) {
  const Mesh mesh = cube(3);
  const Material material = of_poisson_ratio(.25);
  const Blocks blocks = blocks_of(mesh);
  const auto u = random_at_nodes(mesh, 1e-9 * edge / 3, 1);
  const std::vector<Vector3> at_rest(u.size(), Vector3::Zero());
  const std::vector<double> masses = lumped_masses(mesh, material.density);
  for (const ExplicitElement element : explicit_elements) {
    const auto expected = plain_forces(mesh, lame_constants(material), element, u);
    const auto set = dynamics::best_instruction_set();
    const auto found = dynamics::summed_forces<float>(
        blocks, explicit_kernel<float>(mesh, material, element, blocks, 0, set), set,
        {u, at_rest}, masses);
    for (std::size_t n = 0; n < u.size(); ++n)
      BOOST_TEST((found[n] - expected[n]).norm() < 2e-6 * longest(expected));
  }
}

// Sums over blocks are made in the blocks' order, on any number of threads.
BOOST_AUTO_TEST_CASE(threads_change_no_bit) {
  for (const Mesh& mesh : {cube(14), cube(14, CellPattern::hexahedron, 0.2),
                           cube(6, CellPattern::free_hexahedron)}) {
    const Material material = of_poisson_ratio(.25);
    const Scene scene{.material = material,
                      .plates = {{"bottom", moved_by({0, 0, 0}), all_components}},
                      .gravity = {1, 2, 3}};
    for (const ExplicitElement element : explicit_elements) {
      std::vector<Solution> solutions;
      for (const int threads : {1, 2, 4})
        solutions.push_back(run_dynamics(
            mesh, scene,
            {.element = element,
             .protocol = {.integrator = dynamics::Integrator::semi_implicit_euler,
                          .duration = 20 * 1e-5,
                          .time_step = 1e-5,
                          .force_time_step = true},
             .damping_ratio = 0.1,
             .threads = threads}));
      for (const Solution& solution : solutions) {
        BOOST_TEST(solution.steps == 20);
        BOOST_TEST((solution.displacements == solutions.front().displacements));
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
