#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "comparisons/settings/case_json.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(reference_settings_test)

// INTERFACE: fem-hooke:q1-sri up to .02, fem-stvk:q1-sri above, on the same mesh.
BOOST_AUTO_TEST_CASE(the_default_reference_depends_on_the_deformation) {
  const auto reference = [](const std::string& scene, const std::string& change) {
    return label(*requests(run_of(scene, {"method=mss-cf", change})).front().reference);
  };
  BOOST_TEST(reference("compression", "deformation=.02") == "fem-hooke:q1-sri");
  BOOST_TEST(reference("compression", "deformation=.021") == "fem-stvk:q1-sri");
  BOOST_TEST(reference("torsion", "deformation=1deg") == "fem-hooke:q1-sri");
  BOOST_TEST(reference("bending", "nu=.2") == "fem-stvk:q1-sri");
  BOOST_TEST(reference("bending-cm", "nu=.2") == "fem-hooke:q1-sri");
  BOOST_TEST(reference("uniaxial", "deformation=-.02") == "fem-hooke:q1-sri");
  BOOST_TEST(reference("uniaxial", "deformation=-.2") == "fem-stvk:q1-sri");
  BOOST_TEST(reference("traction", "nu=.2") == "fem-stvk:q1-sri");
  BOOST_TEST(reference("affine", "nu=.2") == "fem-stvk:q1-sri");
  BOOST_TEST(reference("compression", "reference=fem-cauchy-born:q2") ==
             "fem-cauchy-born:q2");
  BOOST_TEST(reference("compression", "reference=fem-hooke:q1") == "fem-hooke:q1");
  BOOST_TEST(reference("compression", "reference=mss-fd") == "mss-fd");
}

const std::vector<std::string> half_sheared{"method=mss-cf,fem-stvk", "solver=verlet",
                                            "deformation=.1", "load-times=2",
                                            "load-fractions=.5"};

// A motion is compared with rest at the load that it ends with.
BOOST_AUTO_TEST_CASE(bodies_at_rest_are_held_at_the_load_that_a_path_ends_with) {
  const auto all = requests(run_of("shearing", half_sheared));
  BOOST_TEST_REQUIRE(all.size() == 2U);
  BOOST_TEST(*all[0].settings.deformation == 0.1);
  BOOST_TEST(all[0].settings.dynamics.load.back().fraction == 0.5);
  BOOST_TEST(*all[0].reference->deformation == 0.05);
  BOOST_TEST(*all[1].settings.deformation == 0.05);
  BOOST_TEST(settings_json(all[1].settings) ==
             settings_json(case_of("shearing", {"method=fem-stvk", "deformation=.05"})));

  std::vector<std::string> back = half_sheared;
  back.insert(back.end(), {"load-times=1,2", "load-fractions=1,0"});
  const Request unloaded = requests(run_of("shearing", back))[0];
  BOOST_TEST(!unloaded.reference.has_value());
  BOOST_TEST(unloaded.no_reference ==
             "the load ends at 0: no deviation from bodies at rest");
  back.insert(back.end(), {"method=mss-cf", "reference=mss-affine"});
  const Request moved = requests(run_of("shearing", back))[0];
  BOOST_TEST(*moved.reference->deformation == 0.1);  // it moves, too
  BOOST_TEST(reference_label(moved) == "mss-affine:verlet");
  BOOST_TEST(moved.no_reference == "");

  // The usual law is chosen by the deformation at the end; a limit has no load of its
  // own.
  std::vector<std::string> small = half_sheared;
  small.push_back("deformation=.04");
  BOOST_TEST(label(*requests(run_of("shearing", small))[0].reference) ==
             "fem-hooke:q1-sri");
  small.insert(small.end(), {"method=mss-cf", "solver=limit", "reference=mss-cf:verlet"});
  BOOST_TEST(*requests(run_of("shearing", small))[0].settings.deformation == 0.04);

  const auto parts = [](const char* scene, const std::vector<std::string>& load) {
    std::vector<std::string> changes{"method=mss-cf", "solver=verlet", "load-times=2",
                                     "load-fractions=.5", "reference=mss-cf:static"};
    changes.insert(changes.end(), load.begin(), load.end());
    return *requests(run_of(scene, changes))[0].reference;
  };
  BOOST_TEST((parts("bending", {"gravity=-8,0,0"}).gravity == Vector3(-4, 0, 0)));
  BOOST_TEST((parts("traction", {"traction=0,0,6"}).traction == Vector3(0, 0, 3)));
  BOOST_TEST(parts("affine", {"gradient=.2,0,0,0,0,0,0,0,0"}).gradient(0, 0) == 0.1);
}

BOOST_AUTO_TEST_CASE(a_motion_is_held_against_its_own_statics) {
  std::vector<std::string> changes = half_sheared;
  changes.insert(changes.end(), {"method=mss-cf", "reference=mss-cf:static"});
  const Request request = requests(run_of("shearing", changes))[0];
  BOOST_TEST_REQUIRE(request.reference.has_value());
  BOOST_TEST(settings_json(*request.reference) ==
             settings_json(case_of("shearing", {"method=mss-cf", "deformation=.05"})));
  BOOST_TEST(reference_label(request) == "mss-cf:static");
  changes.back() = "reference=mss-cf";
  BOOST_TEST(!requests(run_of("shearing", changes))[0].reference.has_value());
}

BOOST_AUTO_TEST_CASE(the_reference_itself_has_none) {
  const auto all = requests(run_of("compression", {"method=mss-cf,fem-stvk"}));
  BOOST_TEST_REQUIRE(all.size() == 2U);
  BOOST_TEST(all[0].reference.has_value());
  BOOST_TEST(!all[1].reference.has_value());
}

BOOST_AUTO_TEST_SUITE_END()
