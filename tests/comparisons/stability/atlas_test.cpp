#include "comparisons/stability/atlas.hpp"

#include <boost/test/unit_test.hpp>

#include "comparisons/stability/atlas_tables.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(atlas_test)

namespace {

AtlasPlan plan_of(const std::string& scene, const std::vector<std::string>& over,
                  const std::vector<std::pair<std::string, std::string>>& options) {
  AtlasPlan plan{.scene = scene, .options = {}, .axes = {}};
  for (const std::string& axis : over) plan.axes.push_back(axis_named("--over", axis));
  for (const auto& [key, value] : options)
    plan.options.push_back({key, Given::from_text("--" + key, value)});
  return plan;
}

Atlas atlas_of(const AtlasPlan& plan) {
  CaseRunner runner(std::nullopt, 2);
  return make_atlas(plan, runner);
}

}  // namespace

// The limit is where the largest eigenvalue says: a step of 2/omega_max.
BOOST_AUTO_TEST_CASE(steps_fail_from_their_limit_on) {
  const AtlasPlan plan = plan_of("compression", {"dt-ratio=0.9:1.1:3"},
                                 {{"cells", "4,4,4"},
                                  {"solver", "verlet"},
                                  {"duration", "4"},
                                  {"deformation", "1%"},
                                  {"damping", "0"},
                                  {"method", "mss-cf,fem-explicit-1p"}});
  const Atlas atlas = atlas_of(plan);
  BOOST_TEST(atlas.points.size() == 6U);
  BOOST_TEST_REQUIRE(atlas.limits.size() == 2U);
  for (const AtlasLimit& limit : atlas.limits) {
    BOOST_TEST_CONTEXT(limit.method) {
      BOOST_TEST((limit.failure == Failure::blow_up));
      BOOST_TEST(limit.low.value() == 1, boost::test_tools::tolerance(.02));
      BOOST_TEST(limit.high.value() - *limit.low <= .011);
      BOOST_TEST(limit.cases.size() == 1U);
    }
  }
}

// Along a deformation the path itself gives the limit: no bisection of cases is needed.
BOOST_AUTO_TEST_CASE(a_map_has_a_limit_for_every_column_and_method) {
  const AtlasPlan plan = plan_of("compression", {"deformation=1%:6%:3", "nu=0,0.25"},
                                 {{"cells", "6,6,6"}, {"method", "mss-cf,mss-nfd"}});
  CaseRunner runner(std::nullopt, 2);
  const Atlas atlas = make_atlas(plan, runner);
  BOOST_TEST(atlas.points.size() == 12U);
  BOOST_TEST(runner.computed() == 16U);  // one more for each method and nu
  BOOST_TEST_REQUIRE(atlas.limits.size() == 4U);
  for (const AtlasLimit& limit : atlas.limits) {
    if (limit.method == "mss-cf") {
      BOOST_TEST((limit.failure == Failure::none));
      BOOST_TEST(limit.low.value() == 6);
      BOOST_TEST(!limit.high);
      continue;
    }
    BOOST_TEST((limit.failure == Failure::wrinkling));
    BOOST_TEST(limit.low.value() < *limit.high);
    BOOST_TEST(*limit.high < 6);
    BOOST_TEST(limit.wavelength.value() < 4);
    // What static solutions show lies on the right side.
    for (const AtlasPoint& point : atlas.points)
      if (point.method == limit.method && point.values[1] == limit.other &&
          point.failure == Failure::wrinkling)
        BOOST_TEST(number_of(point.values[0]) > *limit.low);
  }
  BOOST_TEST(points_table(atlas, plan).rows.size() == 12U);
  BOOST_TEST(limits_table(atlas, plan).rows.size() == 4U);
  BOOST_TEST(maps_text(atlas, plan).find("mss-nfd: deformation against nu") !=
             std::string::npos);
}

// The paths of finite elements give limits too; with noise, which no path has, cases are
// bisected.
BOOST_AUTO_TEST_CASE(limits_of_elements_are_those_of_their_paths) {
  for (const bool has_noise : {false, true}) {
    const AtlasPlan plan = plan_of("compression", {"deformation=10%:50%:3"},
                                   {{"cells", "3,3,3"},
                                    {"method", "fem-stvk"},
                                    {"noise", has_noise ? "1e-3" : "0"}});
    CaseRunner runner(std::nullopt, 2);
    const Atlas atlas = make_atlas(plan, runner);
    BOOST_TEST_REQUIRE(atlas.limits.size() == 1U);
    const AtlasLimit& limit = atlas.limits.front();
    BOOST_TEST((runner.computed() == 4) == !has_noise);
    BOOST_TEST((limit.failure == Failure::inversion) == !has_noise);
    BOOST_TEST(limit.wavelength.has_value() == !has_noise);
    BOOST_TEST(*limit.high - *limit.low <= (has_noise ? .01 : .0021) * *limit.high);
  }
}

BOOST_AUTO_TEST_CASE(what_fails_at_once_or_never_says_so) {
  const Atlas atlas =
      atlas_of(plan_of("compression", {"nu=-0.5:-0.3:2"},
                       {{"cells", "2,2,2"}, {"method", "mss-baudet,mss-affine"}}));
  BOOST_TEST_REQUIRE(atlas.limits.size() == 2U);
  BOOST_TEST((atlas.limits[0].failure == Failure::not_covered));
  BOOST_TEST(!atlas.limits[0].low);
  BOOST_TEST(!atlas.limits[0].high);  // a refusal is no limit of the body
  BOOST_TEST((atlas.limits[1].failure == Failure::none));
  BOOST_TEST(atlas.limits[1].low.value() == -.3);
}

// Near nu = .5 q1 is far stiffer than q1-sri; lattices are what fem-cauchy-born says.
BOOST_AUTO_TEST_CASE(locking_is_judged_against_elements_that_do_not_lock) {
  AtlasPlan plan = plan_of("compression", {"nu=0.25,0.499"},
                           {{"cells", "3,3,3"},
                            {"deformation", "1%"},
                            {"element", "q1"},
                            {"method", "fem-stvk,mss-cf"}});
  plan.judges_locking = true;
  for (const AtlasPoint& point : atlas_of(plan).points)
    BOOST_TEST((point.failure == Failure::locking) ==
                   (point.method == "fem-stvk:q1" && point.values[0] == "0.499"),
               point.method << " at nu = " << point.values[0]);
}

BOOST_AUTO_TEST_CASE(values_that_are_no_range_have_a_map_and_no_limits) {
  const Atlas atlas =
      atlas_of(plan_of("compression", {"cell-type=hexahedron,tetrahedron"},
                       {{"cells", "2,2,2"}, {"method", "mss-affine"}}));
  BOOST_TEST(atlas.points.size() == 2U);
  BOOST_TEST(atlas.limits.empty());
}

// A second run of the same atlas takes everything from the file, limits included.
BOOST_AUTO_TEST_CASE(an_atlas_goes_on_where_it_was_left) {
  const OwnFolder folder;
  const auto file = folder.path / "atlas.h5";
  const AtlasPlan plan = plan_of("compression", {"dt-ratio=0.9:1.1:2"},
                                 {{"cells", "3,3,3"},
                                  {"solver", "verlet"},
                                  {"duration", "1"},
                                  {"damping", "0"},
                                  {"method", "mss-cf"}});
  std::string first;
  {
    CaseRunner runner(file, 2);
    first = format_table(limits_table(make_atlas(plan, runner), plan), TableFormat::csv);
    BOOST_TEST(runner.computed() > 2U);
  }
  CaseRunner runner(file, 2);
  BOOST_TEST(format_table(limits_table(make_atlas(plan, runner), plan),
                          TableFormat::csv) == first);
  BOOST_TEST(runner.computed() == 0U);
}

BOOST_AUTO_TEST_SUITE_END()
