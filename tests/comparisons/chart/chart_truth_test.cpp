#include "comparisons/chart/chart_truth.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/chart/chart_models.hpp"
#include "comparisons/settings/case_json.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(chart_truth_test)

namespace {

TruthGrids grids_of_cube() {
  const GivenSettings options = {{"size", std::array{0.1, 0.1, 0.1}},
                                 {"deformation", 0.01}};
  return truth_grids("compression", options, "fem-hooke", 2);
}

/// A run in which all nodes have moved [m] along x.
CaseResult moved(const CaseSettings& settings, double by, MeshStore& meshes) {
  const Mesh& mesh = meshes.mesh(settings.body);
  CaseResult run{};
  run.request.settings = settings;
  run.solution.displacements.assign(mesh.nodes().size(), Vector3(by, 0, 0));
  run.solution.cell_volumes = mesh.cell_volumes();
  run.measures.volume_error = 0;
  return run;
}

/// How far the limit of q2, which does not move, is from that of grids that do.
double apart(const std::array<double, 3>& check) {
  MeshStore meshes;
  const TruthGrids grids = grids_of_cube();
  std::vector<CaseResult> runs;
  for (const CaseSettings& grid : grids.grids) runs.push_back(moved(grid, 0, meshes));
  for (std::size_t i = 0; i < 3; ++i)
    runs.push_back(moved(grids.check[i], check[i], meshes));
  std::vector<const CaseResult*> places;
  for (const CaseResult& run : runs) places.push_back(&run);
  const std::span<const CaseResult* const> all(places);
  return apart_in_places(all.first(3), all.last(3), meshes).value();
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_truth_is_checked_by_other_elements_on_its_nodes) {
  const TruthGrids grids = grids_of_cube();
  for (std::size_t i = 0; i < 3; ++i) {
    const CaseSettings &own = grids.grids[i], &check = grids.check[i];
    BOOST_TEST(own.elements.element.name == "q2");
    BOOST_TEST(check.elements.element.name == "q1-sri");
    const int across = 2 << i;
    BOOST_TEST(own.body.block.cells == (Cells{across, across, across}));
    BOOST_TEST(check.body.block.cells == (Cells{2 * across, 2 * across, 2 * across}));
    CaseSettings same = check;
    same.elements = own.elements;
    same.body = own.body;
    BOOST_TEST(settings_json(same) == settings_json(own));
  }
}

// Changes that turn back, of c, leave an error bound of 3 c/(2^(1/2) - 1) about the
// finest: 7.2 c. Over the 1 mm that the plate moves.
BOOST_AUTO_TEST_CASE(places_are_as_unsure_as_two_limits_are_apart,
                     *boost::unit_test::tolerance(1e-6)) {
  constexpr double c = 1e-5, plate = 1e-3;
  const double error_bound = 3 * c / (std::sqrt(2.) - 1);
  BOOST_TEST(apart({6 * c, 5 * c, 6 * c}) == 6 * c / plate);
  // Farther apart than both error bounds: with the other's.
  BOOST_TEST(apart({9 * c, 8 * c, 9 * c}) == (9 * c + error_bound) / plate);
}

BOOST_AUTO_TEST_SUITE_END()
