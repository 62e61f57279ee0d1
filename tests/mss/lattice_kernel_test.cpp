#define BOOST_TEST_MODULE lattice_kernel
#include "mss/lattice_kernel.hpp"

#include <boost/test/unit_test.hpp>
#include <numeric>
#include <set>

#include "../dynamics/block_forces.hpp"
#include "blocks.hpp"
#include "mss/forces.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::InstructionSet;

namespace {

Material tissue(double nu) {
  return {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000};
}

/// Some of the cells of a grid with these planes, kept with a probability, in random order
/// with random numbers and every cell turned at random: whatever a file may hold.
Mesh shuffled_cells(const std::array<std::vector<double>, 3>& planes, double kept,
                    unsigned seed) {
  std::mt19937 random(seed);
  const std::size_t nx = planes[0].size(), ny = planes[1].size();
  std::vector<CellNodes> cells;
  std::vector<std::size_t> used;
  // The cube's rotations that keep it right-handed, as images of gmsh's corners.
  const std::array<std::array<std::uint8_t, 8>, 4> turns{{{0, 1, 2, 3, 4, 5, 6, 7},
                                                          {1, 2, 3, 0, 5, 6, 7, 4},
                                                          {0, 3, 7, 4, 1, 2, 6, 5},
                                                          {5, 4, 7, 6, 1, 0, 3, 2}}};
  std::uniform_real_distribution<double> chance(0, 1);
  for (std::size_t k = 0; k + 1 < planes[2].size(); ++k)
    for (std::size_t j = 0; j + 1 < ny; ++j)
      for (std::size_t i = 0; i + 1 < nx; ++i) {
        if (chance(random) > kept) continue;
        const auto at = [&](std::size_t x, std::size_t y, std::size_t z) {
          return static_cast<NodeIndex>(x + nx * (y + ny * z));
        };
        const std::array<NodeIndex, 8> corners{
            at(i, j, k),         at(i + 1, j, k),     at(i + 1, j + 1, k),
            at(i, j + 1, k),     at(i, j, k + 1),     at(i + 1, j, k + 1),
            at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)};
        CellNodes cell;
        const auto& turn = turns[random() % turns.size()];
        for (const std::uint8_t c : turn) cell.push_back(corners[c]);
        cells.push_back(cell);
        used.insert(used.end(), corners.begin(), corners.end());
      }
  std::ranges::sort(used);
  used.erase(std::ranges::unique(used).begin(), used.end());
  std::ranges::shuffle(used, random);
  std::ranges::shuffle(cells, random);
  std::vector<NodeIndex> number(nx * ny * planes[2].size());
  std::vector<Vector3> nodes;
  for (const std::size_t node : used) {
    number[node] = static_cast<NodeIndex>(nodes.size());
    nodes.emplace_back(planes[0][node % nx], planes[1][node / nx % ny],
                       planes[2][node / nx / ny]);
  }
  for (CellNodes& cell : cells)
    for (NodeIndex& node : cell) node = number[node];
  return Mesh("shuffled", std::move(nodes), std::move(cells), {});
}

std::vector<double> even(int cells, double h) {
  std::vector<double> planes;
  for (int i = 0; i <= cells; ++i) planes.push_back(i * h);
  return planes;
}

std::vector<double> graded(int cells, double h) {
  std::vector<double> planes;
  for (int i = 0; i <= cells; ++i) planes.push_back(i * h * (1 + 0.02 * i));
  return planes;
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

/// Calls check(mesh, name) for a regular cube, loose random cells, and boxes of all sizes.
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
