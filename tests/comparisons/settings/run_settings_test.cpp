#include <unistd.h>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/methods/families.hpp"
#include "comparisons/settings/case_json.hpp"
#include "meshing/input_error.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(run_settings_test)

namespace {

/// The message of reading this text as a scene file.
std::string message_of_scene(const std::string& text) {
  std::string name =
      (std::filesystem::temp_directory_path() / "springcheck_XXXXXX.toml").string();
  close(mkstemps(name.data(), 5));
  const std::filesystem::path file(name);
  std::ofstream(file) << text;
  struct Remove {
    const std::filesystem::path& file;
    ~Remove() { std::filesystem::remove(file); }
  } const remove{file};
  try {
    const SceneFile scene = read_scene(file.string());
    make_run_settings(scene.name, "scene.toml", scene.settings);
  } catch (const InputError& error) {
    std::string message = error.what();
    if (const auto at = message.find(file.string()); at != std::string::npos)
      message.replace(at, file.string().size(), "scene.toml");
    return message;
  }
  return "accepted";
}

std::string message_of_option(const std::string& scene, const std::string& change) {
  try {
    run_of(scene, {change});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string good =
    "test = \"compression\"\nsize = [1, 1, 1]\ncells = [2, 2, 2]\nyoung = 1e4\n"
    "nu = 0.25\ndensity = 1000\ndeformation = 0.05\nmethod = \"mss-cf\"\n";

std::string with(const std::string& from, const std::string& to) {
  std::string text = good;
  return text.replace(text.find(from), from.size(), to);
}

/// The good scene with springs of one's own, whose constants are to follow in line 9.
const std::string own = with("mss-cf", "mss-custom");

/// The good scene as another test, with this in the place of its deformation (line 7).
std::string of_test(const std::string& test, const std::string& instead) {
  std::string text = with("deformation = 0.05", instead);
  return text.replace(text.find("compression"), 11, test);
}

struct Bad {
  std::string scene;
  std::string message_start;
};
std::ostream& operator<<(std::ostream& out, const Bad& bad) {
  return out << bad.message_start;
}

const std::vector<Bad> bad_scenes{
    {"", "scene.toml:1:1: expected settings, got an empty scene"},
    {"test = ", "scene.toml:1:"},
    {good + "colour = 3\n",
     "scene.toml:9:1: unknown key 'colour', expected one of test, method"},
    {with("nu = 0.25", "nu = \"soft\""),
     "scene.toml:5:6: nu: expected a finite number, got 'soft'"},
    {with("nu = 0.25\n", ""),
     "scene.toml:1:1: key 'nu': expected a number in (-1, 0.5), got none"},
    {with("nu = 0.25", "nu = 0.5"),
     "scene.toml:5:6: nu: expected a number in (-1, 0.5), got 0.5"},
    {with("nu = 0.25", "nu = -1"),
     "scene.toml:5:6: nu: expected a number in (-1, 0.5), got -1"},
    {with("nu = 0.25", "nu = nan"),
     "scene.toml:5:6: nu: expected a finite number, got nan"},
    {with("young = 1e4", "young = -1"),
     "scene.toml:4:9: young: expected a positive finite number"},
    {with("young = 1e4", "young = inf"),
     "scene.toml:4:9: young: expected a positive finite number"},
    {with("density = 1000", "density = 0"),
     "scene.toml:6:11: density: expected a positive"},
    {with("density = 1000", "density = {x = 1}"),
     "scene.toml:6:11: density: expected a positive finite number, got a table"},
    {with("[1, 1, 1]", "[1, 1]"),
     "scene.toml:2:8: size: expected 3 finite numbers, got [1, 1]"},
    {with("[1, 1, 1]", "[1, 0, 1]"),
     "scene.toml:2:8: size: expected three lengths between 1e-9 and 1e9 m, got [1, 0, "
     "1]"},
    {with("[2, 2, 2]", "[2, 0, 2]"),
     "scene.toml:3:9: cells: expected three counts of at least 1"},
    {with("[2, 2, 2]", "[2, 2.5, 2]"), "scene.toml:3:9: cells: expected three integers"},
    {with("[2, 2, 2]", "[2, 4.0, 2]"),
     "scene.toml:3:9: cells: expected three integers, got [2, 4.0, 2]"},
    {with("nu = 0.25", "nu = [0.25]"),
     "scene.toml:5:6: nu: expected a finite number, got [0.25]"},
    {with("deformation = 0.05", "deformation = 1e200"),
     "scene.toml:7:15: deformation: expected a deformation of at most 100"},
    {with("deformation = 0.05", "deformation = \"5deg\""),
     "scene.toml:7:15: deformation: expected a finite number, plain or in %, as in '5%', "
     "got '5deg'"},
    {with("[2, 2, 2]", "[2, 99999999999, 2]"),
     "scene.toml:3:9: cells: expected three counts"},
    {with("deformation = 0.05", "deformation = -0.05"),
     "scene.toml:7:15: deformation: expected a positive"},
    {with("deformation = 0.05", "deformation = 1"),
     "scene.toml:7:15: deformation: expected a strain below 1"},
    {with("deformation = 0.05", "deformation = \"5kg\""),
     "scene.toml:7:15: deformation: expected a finite number, plain or in %, as in '5%', "
     "got '5kg'"},
    {with("\"mss-cf\"", "\"mss-fc\""),
     "scene.toml:8:10: method: unknown value 'mss-fc', did you mean 'mss-cf'? expected "
     "one of mss-"
     "baudet, mss-nfd"},
    {with("\"mss-cf\"", "[]"),
     "scene.toml:8:10: method: expected at least one name, got []"},
    {with("\"mss-cf\"", "[\"mss-cf\", \"mss-cf\"]"),
     "scene.toml:8:10: method: expected each name once"},
    {with("\"compression\"", "\"squeezing\""),
     "scene.toml:1:8: test: unknown value 'squeezing', expected one of compression, "
     "tension"},
    {good + "element = \"q9\"\n",
     "scene.toml:9:11: element: unknown value 'q9', did you mean 'q1'? expected one of "
     "q1, q1-sri"},
    {good + "solver = \"magic\"\n",
     "scene.toml:9:10: solver: unknown value 'magic', expected one of static, limit, "
     "explicit, semi-implicit, "
     "verlet, implicit"},
    {good + "dt = 0\n",
     "scene.toml:9:6: dt: expected a positive time [s] or 'auto', got 0"},
    {good + "dt = \"soon\"\n",
     "scene.toml:9:6: dt: expected a positive time [s] or 'auto', got 'soon'"},
    {good + "damping = -1\n",
     "scene.toml:9:11: damping: expected a number of at least 0"},
    {good + "gravity = [0, 0, -1]\n",
     "scene.toml:9:11: gravity: expected no gravity but in bending"},
    {good + "expect = \"fine\"\n",
     "scene.toml:9:10: expect: unknown value 'fine', expected one of ok, wrinkled"},
    {good + "reference = \"fem-stvk@fine\"\n",
     "scene.toml:9:13: reference: expected a method, or METHOD:ELEMENT, METHOD:SOLVER "
     "or METHOD:ELEMENT:SOLVER, and behind it @NX,NY,NZ"},
    {good + "reference = \"mss-cf:q1@4\"\n",
     "scene.toml:9:13: reference: unknown value 'q1', expected one of static, explicit, "
     "semi-implicit, verlet, implicit"},
    {good + "reference = \"mss-cf:limit\"\n",
     "scene.toml:9:13: reference: unknown value 'limit', expected one of static"},
    {good + "reference = \"fem-explicit-stvk:verlet\"\n",
     "scene.toml:9:13: reference: unknown value 'verlet', expected one of q1, q1-sri"},
    {good + "reference = \"fem-explicit-stvk:q1:static\"\n",
     "scene.toml:9:13: reference: unknown value 'static', expected one of "
     "semi-implicit, explicit, verlet"},
    {good + "reference = \"fem-stvk:q1:static\"\n",
     "scene.toml:9:13: reference: expected fem-stvk without a solver: as a reference it "
     "has "
     "one"},
    {good + "reference = \"fem-tissue:static\"\n",
     "scene.toml:9:13: reference: expected fem-tissue without a solver: as a reference "
     "it "
     "has one"},
    {good + "reference = \"fem@converged\"\n",
     "scene.toml:9:13: reference: unknown value 'fem', expected one of mss-baudet"},
    {good + "traction = [0, 0, 1]\n",
     "scene.toml:9:12: traction: expected no traction but in traction"},
    {good + "gradient = [1, 0, 0, 0, 0, 0, 0, 0, 0]\n",
     "scene.toml:9:12: gradient: expected no gradient but in affine"},
    {good + "plates = \"sliding\"\n",
     "scene.toml:9:10: plates: expected no plates but in traction"},
    {good + "lattice = \"fem-hooke\"\n",
     "scene.toml:9:11: lattice: unknown value 'fem-hooke', expected one of "
     "mss-baudet, mss-nfd, mss-fd, mss-cf, mss-stvk, mss-hencky, mss-affine, "
     "mss-affine-stvk, mss-affine-hencky"},
    {good + "lattice = \"mss-fd\"\n",
     "scene.toml:9:11: lattice: expected no lattice without fem-cauchy-born"},
    {good + "spring-strain = \"grean\"\n",
     "scene.toml:9:17: spring-strain: unknown value 'grean', did you mean 'green'? "},
    {good + "directions = 7\n",
     "scene.toml:9:14: directions: unknown value '7', did you mean '6'? "},
    {good + "lattice-direction = 110\n",
     "scene.toml:9:21: lattice-direction: expected no lattice-direction without"},
    {good + "lattice-direction = 101\n",
     "scene.toml:9:21: lattice-direction: unknown value '101', did you mean '110'? "
     "expected one of 100, 110, 111"},
    {good + "linear-solver = \"cholesky\"\n",
     "scene.toml:9:17: linear-solver: unknown value 'cholesky', expected one of "
     "auto, "
     "direct, conjugate-gradients, multigrid"},
    {good + "stiffness = [1, 2, 3]\n",
     "scene.toml:9:13: stiffness: expected no stiffness without mss-custom as method or "
     "reference, got [1, 2, 3]"},
    {good + "kappa = 1\n", "scene.toml:9:9: kappa: expected no kappa without mss-custom"},
    {own,
     "scene.toml:1:1: key 'stiffness': expected KE,KF,KC [N/m], got "
     "none"},
    {own + "kappa = 1\n", "scene.toml:1:1: key 'stiffness': expected KE,KF,KC"},
    {own + "stiffness = [1, 2]\n",
     "scene.toml:9:13: stiffness: expected 3 finite numbers, got [1, 2]"},
    {own + "stiffness = [1, nan, 3]\n",
     "scene.toml:9:13: stiffness: expected 3 finite numbers, got [1, nan, 3]"},
    {own + "stiffness = [1, 2, -3]\n",
     "scene.toml:9:13: stiffness: expected KE,KF,KC of at least 0 N/m, one of them above "
     "0, got [1, 2, -3]"},
    {own + "stiffness = [0, 0, 0]\n",
     "scene.toml:9:13: stiffness: expected KE,KF,KC of at least 0 N/m, one of them above "
     "0, got [0, 0, 0]"},
    {own + "stiffness = [1, 2, 3]\nkappa = nan\n",
     "scene.toml:10:9: kappa: expected a finite number, got nan"},
    {own + "stiffness = [1, 2, 3]\nreference = \"mss-custom@4\"\n",
     "scene.toml:10:13: reference: expected mss-custom on the case's own mesh"},
    {of_test("uniaxial", "deformation = 0"),
     "scene.toml:7:15: deformation: expected a strain above -1 other than 0"},
    {of_test("uniaxial", "deformation = -1"),
     "scene.toml:7:15: deformation: expected a strain above -1 other than 0"},
    {of_test("torsion", "deformation = 45"),
     "scene.toml:7:15: deformation: expected an angle of at most a turn, or one with a "
     "unit: degrees are written '45deg', got 45"},
    {of_test("uniaxial", "deformation = 101"),
     "scene.toml:7:15: deformation: expected a deformation of at most 100"},
    {of_test("uniaxial", "traction = [0, 0, 1]"),
     "scene.toml:7:12: traction: expected no traction but in traction"},
    {good + "dt = 1979-05-27\n",
     "scene.toml:9:6: dt: expected a positive time [s] or 'auto', got 1979-05-27"},
    {of_test("affine", "gradient = [[0.1, 0, 0], [0, 0.1, 0], [0, 0]]"),
     "scene.toml:7:12: gradient: expected 9 finite numbers, got [[0.1, 0, "
     "0], [0, 0.1, 0], [0, 0]]"},
    {of_test("traction", ""),
     "scene.toml:1:1: key 'traction': expected a force per area [Pa], got none"},
    {of_test("traction", "traction = [0, 0, 0]"),
     "scene.toml:7:12: traction: expected a vector other than zero [Pa]"},
    {of_test("traction", "traction = [1, 2]"),
     "scene.toml:7:12: traction: expected 3 finite numbers"},
    {of_test("traction", "traction = [0, 1, 2]\nplates = 'sliding'"),
     "scene.toml:7:12: traction: expected a traction along z: the body slides"},
    {of_test("traction", "traction = [0, 0, 1]\nplates = 'loose'"),
     "scene.toml:8:10: plates: unknown value 'loose', expected one of glued, sliding"},
    {of_test("traction", "traction = [0, 0, 1]\ndeformation = 0.1"),
     "scene.toml:8:15: deformation: expected no deformation in traction"},
    {of_test("affine", ""),
     "scene.toml:1:1: key 'gradient': expected nine numbers, row by row, got none"},
    {of_test("affine", "gradient = [1, 2, 3]"),
     "scene.toml:7:12: gradient: expected 9 finite numbers"},
    {of_test("affine", "gradient = [0, 0, 0, 0, 0, 0, 0, 0, 0]"),
     "scene.toml:7:12: gradient: expected a gradient other than zero"},
    {of_test("affine", "gradient = [0, 0, 0, 0, 101, 0, 0, 0, 0]"),
     "scene.toml:7:12: gradient: expected components between -100 and 100"},
    {of_test("affine", "gradient = [0, 0, 0, 0, 0, 0, 0, 0, -1]"),
     "scene.toml:7:12: gradient: expected a gradient H that turns no body inside out"},
    // Half a turn about z: its end is regular, the way there is not.
    {of_test("affine", "gradient = [-2, 0, 0, 0, -2, 0, 0, 0, 0]"),
     "scene.toml:7:12: gradient: expected a gradient H that turns no body inside out"},
    {of_test("affine", "deformation = 0.1"),
     "scene.toml:7:15: deformation: expected no deformation in affine"},
    {good + "nu = 0.3\n", "scene.toml:9:6: expected TOML, got"}};  // a key twice

}  // namespace

BOOST_DATA_TEST_CASE(a_bad_scene_is_refused_with_line_and_column,
                     data::make(bad_scenes)) {
  const std::string message = message_of_scene(sample.scene);
  BOOST_TEST(message.starts_with(sample.message_start), message);
  BOOST_TEST(message.find('\n') == std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_scene_that_cannot_be_read_is_named) {
  BOOST_CHECK_EXCEPTION(read_scene("no/such.toml"), InputError, [](const InputError& e) {
    return std::string(e.what()).starts_with(
        "no/such.toml:1:1: expected a readable scene");
  });
  BOOST_CHECK_EXCEPTION(read_scene("compresion"), InputError, [](const InputError& e) {
    return std::string(e.what()).find("compression-thesis-raw, kidney") !=
           std::string::npos;
  });
}

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

  // By the deformation at the end the usual law is chosen; a limit has no load of its
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

// As tables write it; before the setting `element`, which the others keep.
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

BOOST_AUTO_TEST_CASE(the_reference_itself_has_none) {
  const auto all = requests(run_of("compression", {"method=mss-cf,fem-stvk"}));
  BOOST_TEST_REQUIRE(all.size() == 2U);
  BOOST_TEST(all[0].reference.has_value());
  BOOST_TEST(!all[1].reference.has_value());
}

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
  // Beside it, the others' keys are what they are without.
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
