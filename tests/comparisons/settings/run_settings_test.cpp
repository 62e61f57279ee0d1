#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/methods/families.hpp"
#include "comparisons/settings/case_json.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(run_settings_test)

namespace {

std::string message_of_option(const std::string& scene, const std::string& change) {
  try {
    run_of(scene, {change});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

BOOST_AUTO_TEST_CASE(options_are_checked_like_keys) {
  BOOST_TEST(message_of_option("compression", "nu=.5") ==
             "--nu: expected a number in (-1, 0.5), got 0.5");
  BOOST_TEST(message_of_option("compression", "nu=a").starts_with("--nu: expected"));
  BOOST_TEST(
      message_of_option("compression", "cells=3,3").starts_with("--cells: expected"));
  BOOST_TEST(message_of_option("bending", "deformation=.1").starts_with("--deformation"));
  BOOST_TEST(message_of_option("bending", "gravity=0,0,0").starts_with("--gravity"));
}

BOOST_AUTO_TEST_CASE(a_ratio_of_steps_stands_beside_no_step_but_auto) {
  const auto ratio = [](const std::vector<std::string>& further) {
    std::vector<std::string> changes{"method=mss-cf", "solver=verlet"};
    changes.insert(changes.end(), further.begin(), further.end());
    return case_of("compression", changes).dynamics.step_ratio;
  };
  BOOST_TEST(ratio({}) == 0.9);
  BOOST_TEST(ratio({"dt-ratio=0.5"}) == 0.5);
  BOOST_TEST(ratio({"dt-ratio=0.5", "dt=auto"}) == 0.5);
  BOOST_CHECK_THROW(ratio({"dt-ratio=0.5", "dt=0.001"}), InputError);
}

BOOST_AUTO_TEST_CASE(long_texts_are_clipped_in_messages) {
  const std::string text(10'000, 'x');
  for (const char* key : {"young", "method", "mesh-unit", "seed"}) {
    const std::string message =
        message_of_option("compression", std::string(key) + "=" + text);
    BOOST_TEST(message.size() < 700U, message);
    BOOST_TEST(message.find("(10000 characters)") != std::string::npos, message);
  }
}

BOOST_AUTO_TEST_CASE(deformations_are_understood_with_units,
                     *boost::unit_test::tolerance(1e-15)) {
  BOOST_TEST(*case_of("compression", {"deformation=5%"}).deformation == 0.05);
  BOOST_TEST(*case_of("torsion", {"deformation=45deg"}).deformation ==
             std::numbers::pi / 4);
  BOOST_TEST(*case_of("compression", {"deformation=.2"}).deformation == 0.2);
  BOOST_TEST(*case_of("uniaxial", {"deformation=-5%"}).deformation == -0.05);
}

BOOST_AUTO_TEST_CASE(loads_and_gradients_reach_the_scene) {
  const auto scene_of = [](const CaseSettings& settings) {
    return mechanical_scene(settings, build_mesh(settings.body));
  };
  const Scene glued =
      scene_of(case_of("traction", {"plates=glued", "traction=1,-2,3", "method=mss-cf"}));
  BOOST_TEST((glued.plates.front().held == all_components));
  BOOST_TEST(glued.pins.empty());
  BOOST_TEST((glued.tractions.front().stress == Vector3(1, -2, 3)));
  const Scene affine = scene_of(
      case_of("affine", {"gradient=.1,.2,.3,.4,.5,.6,.7,.8,.9", "method=mss-cf"}));
  BOOST_TEST((*affine.boundary_gradient)(0, 1) == 0.2);  // row by row
  BOOST_TEST((*affine.boundary_gradient)(2, 0) == 0.7);
}

// What holds the body leaves it no rigid motion and no more: on sliding plates, one
// component of each node on them and three at two corners.
BOOST_AUTO_TEST_CASE(sliding_plates_and_pins_hold_only_rigid_motions) {
  const auto held = [](const std::string& scene) {
    const CaseSettings settings = case_of(scene, {"cells=2,2,2", "method=mss-cf"});
    const Mesh mesh = build_mesh(settings.body);
    return prescribed_components(mesh, mechanical_scene(settings, mesh)).size();
  };
  BOOST_TEST(held("uniaxial") == 2 * 9U + 3);
  BOOST_TEST(held("traction") == 9U + 3);
  BOOST_TEST(held("compression") == 2 * 27U);
  BOOST_TEST(held("bending") == 27U);
  BOOST_TEST(held("affine") == 26 * 3U);
}

// The element is named as tables write it; it takes precedence over the setting
// `element`, which the other methods keep.
BOOST_AUTO_TEST_CASE(a_method_may_name_its_element) {
  const auto all = requests(
      run_of("compression", {"method=mss-cf,fem-hooke:q2,fem-hooke", "element=q1"}));
  BOOST_TEST_REQUIRE(all.size() == 3U);
  BOOST_TEST(all[1].settings.method.name == "fem-hooke");
  BOOST_TEST(all[1].settings.elements.element.name == "q2");
  BOOST_TEST(all[2].settings.elements.element.name == "q1");
  BOOST_TEST(settings_json(all[1].settings) ==
             settings_json(case_of("compression", {"method=fem-hooke", "element=q2"})));
  const auto message = [](const std::string& method) {
    try {
      run_of("compression", {"method=" + method});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  BOOST_TEST(message("fem-hooke:q3").find("'q3'") != std::string::npos);
  BOOST_TEST(message("mss-cf:q2").find("mss-cf without ':': it has no elements") !=
             std::string::npos);
  BOOST_TEST(message("fem-hook:q2").find("did you mean 'fem-hooke'?") !=
             std::string::npos);
  BOOST_TEST(message("fem-hooke:q2,fem-hooke:q2").find("each name once") !=
             std::string::npos);
  BOOST_TEST(message("fem-hooke:q1-sri,fem-hooke").find("'fem-hooke:q1-sri' twice") !=
             std::string::npos);
  BOOST_TEST(message("fem-hooke:q2,fem-hooke:q1") == "accepted");
  BOOST_CHECK_THROW(run_of("compression", {"method=fem-hooke:q2,mss-cf", "element=q1"}),
                    InputError);
}

BOOST_AUTO_TEST_CASE(every_key_reaches_the_finite_elements) {
  const CaseSettings settings = case_of(
      "compression", {"method=fem-cauchy-born", "element=q2", "lattice=mss-fd",
                      "lattice-direction=110", "diagonal-ratio=3", "stiffness-form=E"});
  using namespace fem_reference;
  BOOST_TEST((settings.elements.element.element == Element::q2));
  const Lattice lattice = lattice_of(settings);
  BOOST_TEST((lattice.springs == Springs::fd));
  BOOST_TEST((lattice.direction == LatticeDirection::d110));
  BOOST_TEST((lattice.constants == SpringConstants::from_young_modulus));
  BOOST_TEST(lattice.diagonal_ratio == 3);
}

// What a scene says for a static solver is left alone by one through time; a text that is
// no default is refused; a reference that is elastic needs a modulus.
BOOST_AUTO_TEST_CASE(settings_of_tissue_are_read_by_their_solver) {
  const auto refusal = [](std::vector<std::string> changes) -> std::string {
    try {
      run_of("tissue-torsion", std::move(changes));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  BOOST_TEST(refusal({"solver=verlet"}) == "accepted");
  BOOST_TEST(refusal({"time-steps=auto"}) == "accepted");
  BOOST_TEST(
      refusal({"time-steps=some"}).starts_with("--time-steps: expected an integer"));
  BOOST_TEST(refusal({"reference=fem-hooke"})
                 .ends_with("expected Young's modulus [Pa], got none"));
  BOOST_TEST(refusal({"reference=fem-hooke", "young=5kPa"}) == "accepted");
  BOOST_TEST(refusal({"young=-5kPa"}).ends_with("got '-5kPa'"));
}

BOOST_AUTO_TEST_SUITE_END()
