#include <fmt/format.h>

#include <boost/test/unit_test.hpp>

#include "meshing/generators/generate_block.hpp"
#include "mss/statics/equilibrium.hpp"
#include "tests/mss/blocks.hpp"
#include "tests/referee/figures.hpp"

// A slender cantilever with one cell across: what a cell makes of bending.

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(bending_test)

namespace {

constexpr double thickness = 0.01, length = 6 * thickness, E = 1e4, nu = 0.25;

/// Mean deflection [m] of the end face under a sideways traction, cells^2 cubes across.
double deflection(SpringModel model, int cells) {
  constexpr double stress = 1e-2;  // [Pa]: a deflection of 1e-4 of the length
  const Mesh mesh = generate_block(
      {.size = {thickness, thickness, length}, .cells = {cells, cells, 6 * cells}});
  const Scene scene{
      .material = {.young_modulus = E, .poisson_ratio = nu, .density = 1000},
      .plates = {{"bottom", translation(Vector3::Zero()), all_components}},
      .tractions = {{"top", {stress, 0, 0}}},
      .gravity = Vector3::Zero()};
  const Solution solution = find_equilibrium(
      mesh, scene, build_network(mesh, scene.material, in_shear_modulus_form(model)));
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
  const std::vector<NodeIndex>& end = mesh.region("top").nodes;
  double tip = 0;
  for (const NodeIndex n : end)
    tip += solution.displacements[n].x() / static_cast<double>(end.size());
  return tip;
}

}  // namespace

// The tolerance is 1e-7: what the iterations leave of so small a load, 1e-8 of it, moves
// the soft end by more than that part of its way.
BOOST_AUTO_TEST_CASE(cantilevers_of_few_cells_bend_as_the_referee_s,
                     *boost::unit_test::tolerance(1e-7)) {
  for (const auto& [name, model] : {std::pair("mss-cf", SpringModel::cf),
                                    std::pair("mss-affine", SpringModel::affine)})
    for (const int cells : {1, 2, 4})
      BOOST_TEST(deflection(model, cells) ==
                 referee::figure("small_strain",
                                 fmt::format("cantilever {} {} across", name, cells),
                                 "mean deflection of the end"));
}

BOOST_AUTO_TEST_SUITE_END()
