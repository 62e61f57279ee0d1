#include "comparisons/cases/test.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

#include "comparisons/cases/mechanical_scene.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(test_test)

BOOST_AUTO_TEST_CASE(deformations_are_told_in_their_unit) {
  BOOST_TEST(deformation_text(Test::torsion, std::numbers::pi / 4) == "45 deg");
  BOOST_TEST(deformation_text(Test::compression, 0.05) == "5 %");
  BOOST_TEST(deformation_text(Test::uniaxial, -0.2) == "-20 %");
}

// What an entry says of plates and loads is what holds and loads the body.
BOOST_AUTO_TEST_CASE(entries_are_what_their_scenes_do) {
  for (const TestName& test : value_names<Test>) BOOST_TEST_CONTEXT(test.name) {
      const CaseSettings settings = case_of(std::string(test.name), {"cells=2,2,2"});
      BOOST_TEST_REQUIRE((settings.test == test.value));
      BOOST_TEST(settings.deformation.has_value() == test.deforms);
      const Scene scene = mechanical_scene(settings, build_mesh(settings.body));
      BOOST_TEST(scene.plates.empty() == !test.lower_plate);
      const bool is_moved = scene.plates.size() == 2;
      BOOST_TEST(is_moved == test.deforms);
      BOOST_TEST((is_moved || !scene.tractions.empty()) == test.upper_plate);
      BOOST_TEST((is_moved && scene.plates[1].motion.angle != 0) == test.turns);
      BOOST_TEST((is_moved && !scene.pins.empty()) == test.slides);
    }
}

BOOST_AUTO_TEST_SUITE_END()
