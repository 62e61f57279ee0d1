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

// What a case has, its test is declared to have, and the other way round.
BOOST_AUTO_TEST_CASE(measures_are_of_the_tests_that_have_them) {
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
        if (value) BOOST_TEST(measure.further.is_of(test));
        const bool is_of_all =
            std::ranges::all_of(value_names<Test>, measure.further.is_of);
        // The states reached were all stable.
        const bool of_instability = measure.name == "definite_up_to_deformation";
        if (measure.further.is_of(test) && !is_of_all && !of_instability)
          BOOST_TEST(value.has_value());
      }
    });
  }
}

BOOST_AUTO_TEST_SUITE_END()
