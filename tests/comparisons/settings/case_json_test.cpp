#include "comparisons/settings/case_json.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(case_json_test)

// Two cases that cannot differ must share a key, two that can must not.
BOOST_AUTO_TEST_CASE(settings_json_holds_what_a_method_reads) {
  const auto json = [](const std::vector<std::string>& changes) {
    return settings_json(case_of("compression", changes)).dump();
  };
  BOOST_TEST(json({"method=fem-hooke"}) != json({"method=fem-hooke", "seed=7"}));
  BOOST_TEST(json({"method=fem-hooke"}) != json({"method=fem-hooke", "element=q1"}));
  BOOST_TEST(json({"method=mss-cf"}) == json({"method=mss-cf", "element=q1"}));
  BOOST_TEST(json({"method=mss-cf"}) != json({"method=mss-cf", "diagonal-ratio=2"}));
  for (const char* method : {"method=mss-nfd", "method=mss-hencky", "method=fem-stvk"})
    BOOST_CHECK_THROW(json({method, "diagonal-ratio=2"}), InputError);
  BOOST_TEST(json({"method=mss-cf"}) != json({"method=mss-cf", "seed=7"}));
  BOOST_CHECK_THROW(json({"method=mss-cf", "dt=.001"}), InputError);  // read by none
  BOOST_TEST(json({"method=mss-cf"}) != json({"method=mss-cf", "solver=semi-implicit"}));
  const auto differ = [&](const std::string& method, const std::string& change) {
    const std::string reference = "reference=fem-cauchy-born";  // may have a lattice
    return json({"method=" + method, reference}) !=
           json({"method=" + method, reference, change});
  };
  BOOST_TEST(differ("fem-stvk", "linear-solver=direct"));
  BOOST_TEST(differ("fem-stvk", "element=q2"));
  BOOST_TEST(differ("mss-cf", "linear-solver=direct"));
  const std::string method = "method=fem-explicit-stvk", duration = "duration=.1",
                    damping = "damping=.1";
  for (const char* change : {"seed=7", "noise=.1", "linear-solver=direct"})
    BOOST_TEST(
        json({method, duration, damping}) == json({method, duration, damping, change}),
        change);
  for (const char* change : {"lattice=mss-nfd", "lattice-direction=111",
                             "diagonal-ratio=2", "stiffness-form=E"}) {
    BOOST_TEST(differ("fem-cauchy-born", change), change);
    BOOST_TEST(!differ("fem-hencky", change), change);
  }
  for (const char* change : {"diagonal-ratio=2", "stiffness-form=E"})
    BOOST_CHECK_THROW(json({"method=fem-cauchy-born", "lattice=mss-baudet", change}),
                      InputError);
}

BOOST_AUTO_TEST_CASE(springs_of_one_s_own_are_known_by_their_constants_alone) {
  const auto json = [](const std::vector<std::string>& changes) {
    std::vector<std::string> all{"method=mss-custom", "stiffness=1,2,3"};
    all.insert(all.end(), changes.begin(), changes.end());
    return settings_json(case_of("compression", all));
  };
  BOOST_TEST(json({})["stiffness"] == nlohmann::json({1., 2., 3.}));
  BOOST_TEST(json({})["kappa"] == 0.);
  BOOST_TEST(json({"kappa=-5"})["kappa"] == -5.);
  BOOST_TEST(json({}) != json({"stiffness=1,3,2"}));
  BOOST_CHECK_THROW(json({"diagonal-ratio=2"}), InputError);
  // Beside mss-custom, the other methods' keys are what they are without it.
  const auto beside = requests(
      run_of("compression", {"method=mss-cf,mss-custom", "stiffness=1,2,3", "kappa=4"}));
  BOOST_TEST(settings_json(beside.front().settings) ==
             settings_json(case_of("compression", {"method=mss-cf"})));
  BOOST_TEST(settings_json(beside.back().settings) == json({"kappa=4"}));
  const auto reference =
      requests(run_of("compression",
                      {"method=mss-cf", "reference=mss-custom", "stiffness=1,2,3"}))
          .front()
          .reference.value();
  BOOST_TEST(settings_json(reference) == json({}));
}

BOOST_AUTO_TEST_CASE(settings_json_holds_what_a_test_reads) {
  const auto json = [](const std::string& scene, const std::string& change) {
    return settings_json(case_of(scene, {"method=mss-cf", change})).dump();
  };
  BOOST_TEST(json("traction", "plates=glued") != json("traction", "plates=sliding"));
  BOOST_TEST(json("traction", "traction=0,0,1") != json("traction", "traction=0,0,2"));
  BOOST_TEST(json("affine", "gradient=.1,0,0,0,0,0,0,0,0") !=
             json("affine", "gradient=0,.1,0,0,0,0,0,0,0"));
}

BOOST_AUTO_TEST_SUITE_END()
