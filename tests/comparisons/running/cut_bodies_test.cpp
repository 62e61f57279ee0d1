// Bodies cut before they are loaded, held against figures of independent prototypes and,
// for q1, of CalculiX.

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "comparisons/running/simulate.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(cut_bodies_test)

namespace {

CaseResult simulated(const std::string& scene, std::vector<std::string> changes) {
  const CaseSettings settings = case_of(scene, changes);
  return simulate(settings, build_mesh(settings.body));
}

struct Figure {
  std::string scene, method, element_or_directions;
  double expected;  // force [N], or torque [N m]
  double relative;
};
std::ostream& operator<<(std::ostream& out, const Figure& figure) {
  return out << figure.scene << ' ' << figure.method << ' '
             << figure.element_or_directions;
}

// Prototypes were printed with five digits.
const std::vector<Figure> figures{
    {"slit", "mss-cf", "", .83968, 1e-4},
    {"slit", "mss-affine", "directions=6", .82843, 1e-4},
    {"slit", "fem-hooke", "element=q1-sri", .79116, 1e-4},
    {"slit", "fem-stvk", "element=q1-sri", .86794, 1e-4},
    {"slit", "fem-hooke", "element=q1", .7996081, 1e-6},  // CalculiX, MODEL.md section 7
    {"slit-shearing", "mss-cf", "", .31248, 1e-4},
    {"slit-shearing", "fem-hooke", "element=q1-sri", .30433, 1e-4},
    {"slit-torsion", "mss-cf", "", 12.274e-3, 1e-4},
    {"slit-torsion", "fem-hooke", "element=q1-sri", 12.002e-3, 1e-4},
    {"cavity", "mss-cf", "", 1.11553, 1e-4},
    {"cavity", "fem-hooke", "element=q1-sri", 1.13929, 1e-4},
    {"cavity", "fem-stvk", "element=q1-sri", 1.04552, 1e-4}};

}  // namespace

BOOST_DATA_TEST_CASE(forces_are_those_of_the_prototypes, data::make(figures)) {
  std::vector<std::string> changes{"method=" + sample.method};
  if (!sample.element_or_directions.empty())
    changes.push_back(sample.element_or_directions);
  const CaseResult result = simulated(sample.scene, changes);
  BOOST_TEST((result.status == Status::ok));
  const Measures& measures = result.measures;
  const double got =
      sample.scene == "slit-torsion" ? *measures.plate_torque : *measures.plate_force;
  BOOST_TEST(got == sample.expected, boost::test_tools::tolerance(sample.relative));
}

// A slit between cells that are pulled along it changes nothing.
BOOST_AUTO_TEST_CASE(a_slit_along_the_load_is_not_felt) {
  const std::string upright =
      "cut=split,plane=1,0,0,0.025,within=0,0,0.01,0.05,0.05,0.04";
  const CaseResult whole = simulated("uniaxial", {"method=mss-cf"}),
                   slit = simulated("uniaxial", {"method=mss-cf", upright});
  BOOST_TEST(*slit.measures.plate_force == *whole.measures.plate_force,
             boost::test_tools::tolerance(1e-9));
}

// Beam theories know whole beams alone.
BOOST_AUTO_TEST_CASE(cut_beams_have_no_theory) {
  const CaseResult split = simulated(
      "bending", {"method=fem-hooke", "cells=2,2,8", "cut=split,plane=1,0,0,0.2"});
  BOOST_TEST(split.measures.tip_deflection.has_value());
  BOOST_TEST(!split.measures.tip_euler_bernoulli.has_value());
  BOOST_TEST(!split.measures.centre_line_elastica.has_value());
  const CaseResult short_one = simulated(
      "bending", {"method=fem-hooke", "cells=2,2,8", "cut=remove,box=-1,-1,1,1,1,100"});
  BOOST_TEST(!short_one.measures.tip_deflection.has_value());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_cut_or_held_is_refused) {
  const auto message = [](const std::string& scene, std::vector<std::string> changes) {
    changes.insert(changes.begin(), "method=mss-affine");
    try {
      simulated(scene, changes);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto cube = [&](const std::string& cut) {
    return message("compression", {"cells=4,4,4", "cut=" + cut});
  };
  BOOST_TEST(
      cube("split,plane=0,0,1,0.08") ==
      "--cut: cut 'cut': expected a face between cells on its two sides, got none: "
      "the nearest face between two cells is at (0.00625, 0.00625, 0.0375) m, "
      "0.0425 m off");
  BOOST_TEST(cube("remove,box=0,0,0,0.05,0.05,0.05") ==
             "--cut: cut 'cut': expected at least one cell that stays, got none");
  BOOST_TEST(
      cube("remove,name=top,box=0,0,0,0.0125,0.0125,0.0125") ==
      "--cut: cut 'top': expected a name of its own for each surface, got a second "
      "one of 'top'");
  BOOST_TEST(
      cube("remove,name=lid,box=0,0,0.03,0.05,0.05,0.05,split,plane=0,0,1,0.0125") ==
      "--cut: cut 'lid': expected faces left on 'top', which is held or moved, got "
      "none");
  BOOST_TEST(message("affine", {"cut=split,plane=0,0,1,0.025"}) ==
             "--cut: expected no cut in affine, got ['split', 'plane=0', 0, 1, 0.025]");
  BOOST_TEST(message("uniaxial",
                     {"cells=4,4,4", "cut=remove,box=-1,-1,-1,0.0125,0.0125,0.0125"}) ==
             "--cut: expected a corner left whole at (0, 0, 0) m, where a pin holds the "
             "body, got one that is parted or gone");
  BOOST_TEST(message("uniaxial",
                     {"cells=2,2,2", "cell-type=prism", "cut=split,plane=1,-1,0,0"}) ==
             "--cut: expected a corner left whole at (0, 0, 0) m, where a pin holds the "
             "body, got one that is parted or gone");
  // A disc's plates turn about their centres.
  BOOST_TEST(message("tissue-torsion",
                     {"method=mss-tissue", "cut=remove,box=-1,-1,0.0022,0,0,1"})
                 .find("left, whose centre is the plate's of a body that is no block") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
