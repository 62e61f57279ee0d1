#include "meshing/loads/scene.hpp"
#include "meshing/generators/generate_block.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "meshing/basics/input_error.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(scene_test)

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
    scene.plates.push_back({.region = region, .motion = screw, .held = all_components});
  return scene;
}

}  // namespace

// The values are computed by hand with E = 8 Pa. The tolerance is round-off.
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

BOOST_AUTO_TEST_CASE(prescribed_components_ascend_by_node_and_component) {
  const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Scene scene = scene_with_plates({"top"});
  scene.plates.push_back(
      {.region = "bottom", .motion = screw, .held = {false, false, true}});
  scene.pins = {{.point = {0.9, 0.1, 0.2}, .held = {true, false, false}}};  // node 1
  std::vector<std::array<std::size_t, 2>> held;
  std::vector<int> plates;
  for (const auto& [node, component, plate] : prescribed_components(mesh, scene)) {
    held.push_back({node, component});
    plates.push_back(plate ? static_cast<int>(*plate) : -1);
  }
  const std::vector<std::array<std::size_t, 2>> expected{
      {0, 2}, {1, 0}, {1, 2}, {2, 2}, {3, 2}, {4, 0}, {4, 1}, {4, 2}, {5, 0},
      {5, 1}, {5, 2}, {6, 0}, {6, 1}, {6, 2}, {7, 0}, {7, 1}, {7, 2}};
  BOOST_TEST((held == expected));
  BOOST_TEST(plates == (std::vector{1, -1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}),
             boost::test_tools::per_element());

  const std::vector<bool> is_free =
      free_components(mesh, prescribed_components(mesh, scene));
  BOOST_TEST(is_free.size() == 24U);
  for (const auto& [node, component] : expected)
    BOOST_TEST(!is_free[3 * node + component]);
  BOOST_TEST(std::ranges::count(is_free, true) == 24 - 17);
}

// Sums and products of binary fractions are exact.
BOOST_AUTO_TEST_CASE(prescribed_displacements_follow_their_plate_pin_or_gradient) {
  const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Scene scene = scene_with_plates({"top"});
  scene.pins = {{.point = {0, 0, 0}, .held = {false, true, false}}};
  for (const PrescribedComponent& held : prescribed_components(mesh, scene)) {
    const double expected =
        held.plate ? displacement(screw, mesh.nodes()[held.node], 0.5)[held.component]
                   : 0;
    BOOST_TEST(prescribed_displacement(mesh, scene, held, 0.5) == expected);
  }
  Scene affine = scene_with_plates({});
  Eigen::Matrix3d H;
  H << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  affine.boundary_gradient = H;
  const auto all = prescribed_components(mesh, affine);
  BOOST_TEST(all.size() == 24U);  // every node is on the boundary
  for (const PrescribedComponent& held : all)
    BOOST_TEST(prescribed_displacement(mesh, affine, held, 0.5) ==
               0.5 * (H * mesh.nodes()[held.node])[held.component]);
}

BOOST_AUTO_TEST_CASE(component_prescribed_twice_is_refused) {
  const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  BOOST_CHECK_EXCEPTION(
      prescribed_components(mesh, scene_with_plates({"bottom", "x_max"})), InputError,
      [](const InputError& error) {
        BOOST_TEST(error.what() ==
                   std::string("block 1 x 1 x 1 m in 1 x 1 x 1 cells: node 2, component "
                               "x: expected prescribed at most once, got twice: by plate "
                               "'bottom' and plate 'x_max'"));
        return true;
      });
  // Plates that slide on each other at an edge hold different components.
  Scene sliding = scene_with_plates({"bottom", "x_max"});
  sliding.plates[0].held = {false, false, true};
  sliding.plates[1].held = {true, false, false};
  BOOST_CHECK_NO_THROW(prescribed_components(mesh, sliding));
  sliding.pins = {{.point = {0, 0, 0}, .held = {false, false, true}}};
  BOOST_CHECK_THROW(prescribed_components(mesh, sliding), InputError);
}

BOOST_AUTO_TEST_CASE(plate_on_an_unknown_region_is_refused) {
  const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  BOOST_CHECK_THROW(prescribed_components(mesh, scene_with_plates({"lid"})), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
