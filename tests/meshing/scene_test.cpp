#define BOOST_TEST_MODULE scene
#include "meshing/scene.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

#include "meshing/gmsh.hpp"
#include "meshing/input_error.hpp"

using namespace springcheck;

namespace {

// A quarter turn about an upright axis through (1, 1, 0), then 0.5 up.
const RigidMotion screw{.translation = {0, 0, 0.5},
                        .axis = Vector3::UnitZ(),
                        .centre = {1, 1, 0},
                        .angle = std::numbers::pi / 2};

void check_close(const Vector3& a, const Vector3& b) {
  BOOST_TEST((a - b).norm() < 1e-15, a.transpose() << " is not " << b.transpose());
}

Scene scene_with_plates(const std::vector<std::string>& regions) {
  Scene scene{.material = {.young_modulus = 1, .poisson_ratio = 0, .density = 1},
              .plates = {},
              .gravity = Vector3::Zero()};
  for (const std::string& region : regions)
    scene.plates.push_back({.region = region, .motion = screw});
  return scene;
}

}  // namespace

// By hand, with E = 8 Pa; round-off.
BOOST_AUTO_TEST_CASE(lame_constants_have_their_textbook_values,
                     *boost::unit_test::tolerance(1e-15)) {
  struct Row {
    double nu, lambda, mu;
  };
  for (const Row& row :
       {Row{0, 0, 4}, Row{0.25, 3.2, 3.2}, Row{1. / 3, 6, 3}, Row{-0.5, -4, 8}}) {
    const auto [lambda, mu] =
        lame_constants({.young_modulus = 8, .poisson_ratio = row.nu, .density = 1000});
    BOOST_TEST(lambda == row.lambda);
    BOOST_TEST(mu == row.mu);
  }
}

// The points are of size 1: round-off.
BOOST_AUTO_TEST_CASE(rigid_motion_turns_about_its_centre_and_then_moves) {
  const Vector3 point(2, 1, 3);
  check_close(displacement(screw, point, 1), Vector3(-1, 1, 0.5));
  check_close(displacement(screw, screw.centre, 1), screw.translation);
}

BOOST_AUTO_TEST_CASE(half_the_load_is_half_the_angle_and_half_the_way) {
  const double s = std::sqrt(0.5);
  check_close(displacement(screw, {2, 1, 0}, 0.5), Vector3(s - 1, s, 0.25));
  check_close(displacement(screw, {2, 1, 0}, 0), Vector3::Zero());
}

BOOST_AUTO_TEST_CASE(rotation_is_right_handed_about_any_axis) {
  RigidMotion motion = screw;
  motion.axis = Vector3::UnitX();
  motion.translation.setZero();
  check_close(displacement(motion, {1, 2, 0}, 1), Vector3(0, -1, 1));
}

BOOST_AUTO_TEST_CASE(prescribed_nodes_are_the_plates_nodes_in_ascending_order) {
  const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 2}});
  const auto prescribed = prescribed_nodes(mesh, scene_with_plates({"top", "bottom"}));
  std::vector<NodeIndex> nodes;
  std::vector<std::size_t> plates;
  for (const auto& [node, plate] : prescribed) {
    nodes.push_back(node);
    plates.push_back(plate);
  }
  BOOST_TEST(nodes == (std::vector<NodeIndex>{0, 1, 2, 3, 8, 9, 10, 11}),
             boost::test_tools::per_element());
  BOOST_TEST(plates == (std::vector<std::size_t>{1, 1, 1, 1, 0, 0, 0, 0}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(two_plates_at_one_node_are_refused) {
  const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  BOOST_CHECK_EXCEPTION(
      prescribed_nodes(mesh, scene_with_plates({"bottom", "x_max"})), InputError,
      [](const InputError& error) {
        BOOST_TEST(
            error.what() ==
            std::string("block 1 x 1 x 1 m in 1 x 1 x 1 cells: node 1: expected at "
                        "most one plate, got two ('bottom' and 'x_max')"));
        return true;
      });
}

BOOST_AUTO_TEST_CASE(plate_on_an_unknown_region_is_refused) {
  const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  BOOST_CHECK_THROW(prescribed_nodes(mesh, scene_with_plates({"lid"})), InputError);
}
