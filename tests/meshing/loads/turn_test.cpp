#include "meshing/loads/turn.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "meshing/generators/generate_block.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(turn_test)

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double height = .1;
const Vector3 centre(.02, .03, height);

Mesh block(CellPattern pattern, std::array<int, 3> cells) {
  return generate_block({.size = {.04, .06, height}, .cells = cells, .pattern = pattern});
}

Plate plate(const std::string& region, double degrees) {
  return {.region = region,
          .motion = {.translation = Vector3::Zero(),
                     .axis = Vector3::UnitZ(),
                     .centre = centre,
                     .angle = degrees * degree},
          .held = all_components};
}

Scene turned_plates(double lower, double upper) {
  return {.material = {.young_modulus = 1, .poisson_ratio = 0, .density = 1},
          .plates = {plate("bottom", lower), plate("top", upper)},
          .gravity = Vector3::Zero()};
}

/// Every section turned by its part of the way from the lower plate's turn to the upper
/// one's, and moved sideways as a column is that a twist buckles.
std::vector<Vector3> twisted(const Mesh& mesh, double lower, double upper) {
  std::vector<Vector3> positions;
  for (const Vector3& X : mesh.nodes()) {
    const double part = X.z() / height;
    const RigidMotion turn = plate("", std::lerp(lower, upper, part)).motion;
    const Vector3 aside(height * std::sin(std::numbers::pi * part), 0, 0);
    positions.emplace_back(X + displacement(turn, X, 1) + aside);
  }
  return positions;
}

}  // namespace

// Closed form; a layer takes less than half a turn, the column is moved by half its
// height. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(a_twisted_column_shows_its_turn,
                     *boost::unit_test::tolerance(1e-13)) {
  for (const CellPattern pattern : {CellPattern::hexahedron, CellPattern::tetrahedron})
    for (const double upper : {-700., -200., -95., 100., 180., 350., 719.}) {
      const Mesh mesh = block(pattern, {2, 3, 6});
      const Scene scene = turned_plates(0, upper);
      const auto positions = twisted(mesh, 0, upper);
      BOOST_TEST(shown_turn(mesh, scene, positions, 1).value() == upper * degree);
      BOOST_TEST(shows_imposed_turn(mesh, scene, positions, 1));
    }
}

// The plates stand where they would after the turn imposed.
BOOST_AUTO_TEST_CASE(a_column_twisted_by_whole_turns_less_shows_that,
                     *boost::unit_test::tolerance(1e-13)) {
  for (const double imposed : {185., 370., -200., 710.})
    for (const double missing : {-360., 360.}) {
      const Mesh mesh = block(CellPattern::hexahedron, {2, 2, 8});
      const Scene scene = turned_plates(0, imposed);
      const auto positions = twisted(mesh, 0, imposed + missing);
      BOOST_TEST(shown_turn(mesh, scene, positions, 1).value() ==
                 (imposed + missing) * degree);
      BOOST_TEST(!shows_imposed_turn(mesh, scene, positions, 1));
    }
}

// Half of both turns is on the way there.
BOOST_AUTO_TEST_CASE(the_turn_is_that_of_one_plate_against_the_other,
                     *boost::unit_test::tolerance(1e-13)) {
  const Mesh mesh = block(CellPattern::hexahedron, {2, 2, 6});
  const auto positions = twisted(mesh, 250, -200);
  BOOST_TEST(shown_turn(mesh, turned_plates(250, -200), positions, 1).value() ==
             -450 * degree);
  BOOST_TEST(shown_turn(mesh, turned_plates(500, -400), positions, .5).value() ==
             -450 * degree);
}

// The parts are like those of elements whose field bends within them: half a turn and
// more in one layer.
BOOST_AUTO_TEST_CASE(parts_of_cells_show_more_than_half_a_turn,
                     *boost::unit_test::tolerance(1e-13)) {
  const Mesh whole = block(CellPattern::hexahedron, {2, 2, 1});
  const Mesh parts = block(CellPattern::hexahedron, {4, 4, 2});
  const Scene scene = turned_plates(0, 250);
  BOOST_TEST(shown_turn(whole, scene, twisted(whole, 0, 250), 1).value() ==
             -110 * degree);
  BOOST_TEST(
      shown_turn(parts, scene, {parts.cells(), parts.nodes()}, twisted(parts, 0, 250), 1)
          .value() == 250 * degree);
}

BOOST_AUTO_TEST_CASE(where_nothing_turns_far_no_turn_is_looked_at) {
  const Mesh mesh = block(CellPattern::hexahedron, {1, 1, 1});
  BOOST_TEST(!shown_turn(mesh, turned_plates(0, 90), mesh.nodes(), 1));
  BOOST_TEST(!shown_turn(mesh, turned_plates(0, 180), mesh.nodes(), .5));
  Scene hanging = turned_plates(180, 0);
  hanging.plates.pop_back();
  BOOST_TEST(!shown_turn(mesh, hanging, mesh.nodes(), 1));
  BOOST_TEST(shows_imposed_turn(mesh, hanging, mesh.nodes(), 1));
}

BOOST_AUTO_TEST_SUITE_END()
