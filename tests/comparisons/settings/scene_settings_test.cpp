#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "comparisons/settings/run_settings.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(scene_settings_test)

namespace {

/// The message of reading this text as a scene file.
std::string message_of_scene(const std::string& text) {
  const OwnFolder own;
  const std::filesystem::path file = own / "scene.toml";
  std::ofstream(file) << text;
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
     "scene.toml:3:9: cells: expected three integers such as 4,4,4, got [2, 4.0, 2]"},
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

BOOST_AUTO_TEST_SUITE_END()
