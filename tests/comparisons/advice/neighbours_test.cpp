#include "comparisons/advice/neighbours.hpp"

#include <boost/test/unit_test.hpp>

#include "comparisons/chart/chart_models.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(neighbours_test)

namespace {

const auto round_off = boost::test_tools::tolerance(1e-12);

CaseSettings settings_of(const std::string& scene, const GivenSettings& changes) {
  return truth_grids(scene, changes, "fem-stvk", 1).grids.front();
}

std::vector<std::string> names(const std::string& scene, const GivenSettings& changes) {
  std::vector<std::string> all;
  for (const Neighbour& neighbour : neighbours_of(settings_of(scene, changes)))
    all.push_back(name_of(neighbour));
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(they_lie_on_both_sides_of_a_scene) {
  const std::vector<std::string> expected{
      "at 0.8 times the load", "at 1.2 times the load", "at nu = 0.35", "at nu = 0.39"};
  BOOST_TEST(names("compression", {{"nu", 0.37}}) == expected,
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(none_is_beyond_what_a_material_has) {
  const std::vector<std::string> expected{"at 0.8 times the load",
                                          "at 1.2 times the load", "at nu = 0.479",
                                          "at nu = 0.4995"};
  BOOST_TEST(names("compression", {{"nu", 0.499}}) == expected,
             boost::test_tools::per_element());
  BOOST_TEST(names("compression", {{"nu", 0.4999}}).back() == "at nu = 0.49995");
}

BOOST_AUTO_TEST_CASE(a_test_may_have_no_such_load) {
  const auto has_more = [](const std::string& scene, const GivenSettings& changes) {
    return moved(settings_of(scene, changes), {.load = 1.2, .poisson_ratio = 0.25})
        .has_value();
  };
  BOOST_TEST(!has_more("compression", {{"deformation", 0.9}}));
  BOOST_TEST(has_more("compression", {{"deformation", 0.8}}));
  BOOST_TEST(has_more("tension", {{"deformation", 0.9}}));
  BOOST_TEST(has_more("torsion", {{"deformation", 6}}));
  BOOST_TEST(has_more("bending", {}));
}

BOOST_AUTO_TEST_CASE(a_case_is_moved_by_strain_angle_or_weight_and_by_poisson_ratio) {
  const CaseSettings pressed = settings_of("compression", {{"deformation", 0.1}}),
                     bent = settings_of("bending", {});
  const Neighbour heavier{.load = 1.2, .poisson_ratio = 0.25};
  BOOST_TEST(moved(pressed, heavier).value().deformation.value() == 0.12, round_off);
  BOOST_TEST(moved(bent, heavier).value().gravity[0] == 1.2 * bent.gravity[0], round_off);
  const CaseSettings other = moved(pressed, {.poisson_ratio = 0.3}).value();
  BOOST_TEST(other.material.poisson_ratio == 0.3);
  BOOST_TEST(other.deformation.value() == 0.1);
}

// A grid that is a tenth too stiff and loses .001 too much of its volume in both scenes,
// and a coarser one that is a fifth too stiff, in the other scene a quarter.
BOOST_AUTO_TEST_CASE(a_truth_is_carried_by_what_one_grid_shows_in_both_scenes) {
  const ChartTruth truth{
      .grids = {},
      .answer = {.value = 10, .order = {}, .error_bound = 0.1},
      .volume_change = {.value = -0.02, .order = {}, .error_bound = 1e-4},
      .imposed = 0.1,
      .error_bounds = {.force = 0.01, .volume = 0.002, .deviation = 0.5}};
  StoredChart chart;
  chart.answer = "plate_force";
  chart.height = 2;
  TwoGrids here, there;
  here[1].plate_force = 11;
  here[1].volume_change = -0.021;
  there[1].plate_force = 11 * 1.3;
  there[1].volume_change = -0.0262;  // .0012 of 1.2 times the load too much
  here[0].plate_force = 12;
  here[0].volume_change = -0.022;
  there[0].plate_force = 12.5 * 1.3;
  there[0].volume_change = -0.0274 - 0.0006;
  const ChartTruth carried = carried_truth(truth, chart, here, there, 0.12, 0.003);
  BOOST_TEST(carried.answer.value == 13, round_off);
  BOOST_TEST(carried.volume_change.value == -0.025, round_off);
  BOOST_TEST(carried.imposed == 0.12);
  BOOST_TEST(carried.error_bounds.force.value() == 0.01 + 0.5 / 12, round_off);
  BOOST_TEST(carried.error_bounds.volume.value() == 0.002 + 0.0006 / (0.12 / 2),
             boost::test_tools::tolerance(1e-10));
  BOOST_TEST(carried.error_bounds.deviation.value() == 0.003);
  // In bending no displacement is imposed: the answer takes its place.
  BOOST_TEST(carried_truth(truth, chart, here, there, std::nullopt, 0.003).imposed == 13,
             round_off);
}

BOOST_AUTO_TEST_CASE(errors_count_beyond_their_error_bounds) {
  const ChartErrors beyond = beyond_error_bounds({.force = 0.03, .volume = 0.01},
                                                 {.force = 0.01, .volume = 0.02});
  BOOST_TEST(beyond.force.value() == 0.02, round_off);
  BOOST_TEST(beyond.volume.value() == 0);
  BOOST_TEST(!beyond.deviation.has_value());
}

BOOST_AUTO_TEST_SUITE_END()
