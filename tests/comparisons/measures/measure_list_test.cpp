#include "comparisons/measures/measure_list.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "comparisons/measures/measures.hpp"
#include "comparisons/studies/study.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(measure_list_test)

// A value by its entry is the value by its member, which a member that is named twice, or
// never, cannot be.
BOOST_AUTO_TEST_CASE(every_member_has_one_entry) {
  std::set<std::string_view> names, labels;
  Measures all;
  std::size_t count = 0;
  for_each_measure(all, [&](const Measure& measure, auto& value) {
    BOOST_TEST(!value.has_value(), measure.name << " shares its member with another");
    value.emplace();
    ++count;
    names.insert(measure.name);
    labels.insert(measure.label);
    BOOST_TEST(!measure.description.empty(), measure.name);
    BOOST_TEST(find_measure(measure.name) == &measure);
  });
  BOOST_TEST(names.size() == count);
  BOOST_TEST(labels.size() == count);
  // Nothing but members with an entry is in the struct.
  std::size_t size = 0;
  for (const Measure& measure : measure_list)
    size += component_count(measure) == 1   ? sizeof(Measures::Value)
            : component_count(measure) == 3 ? sizeof(Measures::Vector)
                                            : sizeof(Measures::Matrix);
  BOOST_TEST(size == sizeof(Measures));
}

BOOST_AUTO_TEST_CASE(headings_have_the_unit_that_people_read) {
  BOOST_TEST(heading_of(*find_measure("volume_change")) == "volume change [%]");
  BOOST_TEST(shown_factor(*find_measure("volume_change")) == 100);
  BOOST_TEST(heading_of(*find_measure("plate_torque")) == "torque [N m]");
  BOOST_TEST(shown_factor(*find_measure("plate_torque")) == 1);
  BOOST_TEST(heading_of(*find_measure("cell_volume_ratio_min")) == "least V/V0");
  BOOST_TEST(find_measure("plate_farce") == nullptr);
}

// What a case has, its test is declared to have, and the other way round, but for what
// other cases than stable ones at rest beside a reference on the same mesh have.
BOOST_AUTO_TEST_CASE(measures_are_of_the_tests_that_have_them) {
  const std::set<std::string_view> of_others{"definite_up_to_deformation",
                                             "critical_wavelength",
                                             "reference_order",
                                             "reference_bar",
                                             "reference_bar_l2_relative",
                                             "kinetic_energy",
                                             "transit_count"};
  const std::set<std::string_view> is_homogeneous{"uniaxial", "traction", "affine"};
  MeshStore meshes;
  for (const char* scene : {"compression", "tension", "shearing", "torsion", "bending",
                            "uniaxial", "traction", "affine"}) {
    const auto result =
        run_study(requests(run_of(scene, {"method=mss-cf", "reference=fem-hooke:q1"})),
                  meshes, 2, [](std::size_t, std::size_t) {})
            .front();
    const TestName& test = entry_of(result.request.settings.test);
    BOOST_TEST_REQUIRE((result.status == Status::ok), scene);
    for_each_measure(result.measures, [&](const Measure& measure, const auto& value) {
      BOOST_TEST_CONTEXT(measure.name << " in " << scene) {
        const bool is_of_round_off =
            measure.name.ends_with("_alternation") && is_homogeneous.contains(scene);
        BOOST_TEST(value.has_value() ==
                   (measure.traits.is_of(test) && !of_others.contains(measure.name) &&
                    !is_of_round_off));
      }
    });
  }
}

BOOST_AUTO_TEST_SUITE_END()
