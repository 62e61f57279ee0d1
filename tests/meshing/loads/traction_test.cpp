#include "meshing/loads/traction.hpp"
#include "meshing/generators/generate_block.hpp"

#include <boost/test/unit_test.hpp>
#include <numeric>

#include "meshing/basics/input_error.hpp"

using namespace springcheck;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(traction_test)

namespace {

/// A unit cube whose upper face has these corners, counter-clockwise seen from above.
Mesh lid(const std::array<Vector3, 4>& top) {
  return {"lid",
          {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, top[0], top[1], top[2], top[3]},
          {{0, 1, 2, 3, 4, 5, 6, 7}},
          {{"top", {{4, 5, 6, 7}}}}};
}

}  // namespace

// A rectangle's corners share it alike; a node of a grid has up to four. The tolerance is
// round-off.
BOOST_AUTO_TEST_CASE(nodes_of_a_grid_stand_for_quarters_of_their_faces,
                     *utf::tolerance(1e-12)) {
  const Mesh mesh = generate_block({.size = {0.6, 0.2, 1}, .cells = {3, 2, 1}});
  const std::vector<double> areas = nodal_areas(mesh, mesh.region("top"));
  BOOST_TEST_REQUIRE(areas.size() == mesh.nodes().size());
  for (std::size_t n = 0; n < areas.size(); ++n) {
    const Vector3& x = mesh.nodes()[n];
    const bool is_top = x.z() > 0.5, x_end = x.x() < 0.1 || x.x() > 0.5,
               y_end = x.y() < 0.05 || x.y() > 0.15;
    const double faces = (x_end ? 1. : 2.) * (y_end ? 1. : 2.);
    BOOST_TEST(areas[n] == (is_top ? faces * 0.2 * 0.1 / 4 : 0.));
  }
}

// int N_a dA over the trapezium with corners (0,0), (2,0), (1,1), (0,1): dA/dxi deta is
// (3 - eta)/8 (its area 3/2), so the lower nodes get 1/4 (1 + 2/3)  = 5/12 each and the
// upper ones 4/12, computed by hand. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(nodes_of_a_trapezium_stand_for_their_shape_functions,
                     *utf::tolerance(1e-12)) {
  const Mesh mesh =
      lid({Vector3(0, 0, 1), Vector3(2, 0, 1), Vector3(1, 1, 1), Vector3(0, 1, 1)});
  const std::vector<double> areas = nodal_areas(mesh, mesh.region("top"));
  BOOST_TEST(areas[4] == 5. / 12);
  BOOST_TEST(areas[5] == 5. / 12);
  BOOST_TEST(areas[6] == 4. / 12);
  BOOST_TEST(areas[7] == 4. / 12);
}

// Whatever the plane face: the forces add up to stress times area, and their moment is
// that of the resultant at the centroid, as sum A_a x_a = int x dA. The tolerance is
// round-off.
BOOST_AUTO_TEST_CASE(traction_forces_have_the_loads_resultant_and_moment) {
  // The face lies in the plane z = 1 + x/2.
  const Mesh mesh = lid({Vector3(0, 0, 1), Vector3(1.5, 0.25, 1.75), Vector3(1, 1, 1.5),
                         Vector3(-0.25, 1, 0.875)});
  const Vector3 stress(3, -1, 2);
  const Scene scene{.material = {.young_modulus = 1, .poisson_ratio = 0, .density = 1},
                    .plates = {},
                    .tractions = {{.region = "top", .stress = stress}},
                    .gravity = Vector3::Zero()};
  const std::vector<Vector3> forces = traction_forces(mesh, scene);
  // Two triangles: area and first moment.
  const auto& x = mesh.nodes();
  double area = 0;
  Vector3 moment = Vector3::Zero();
  for (const auto& [a, b, c] : {std::array{4, 5, 6}, std::array{4, 6, 7}}) {
    const auto corner = [&](int i) { return x[static_cast<std::size_t>(i)]; };
    const double part = (corner(b) - corner(a)).cross(corner(c) - corner(a)).norm() / 2;
    area += part;
    moment += part / 3 * (corner(a) + corner(b) + corner(c));
  }
  Vector3 total = Vector3::Zero(), total_moment = Vector3::Zero();
  for (std::size_t n = 0; n < forces.size(); ++n) {
    total += forces[n];
    total_moment += x[n].cross(forces[n]);
  }
  BOOST_TEST((total - area * stress).norm() < 1e-14);
  BOOST_TEST((total_moment - moment.cross(stress)).norm() < 1e-14);
}

BOOST_AUTO_TEST_CASE(traction_on_an_unknown_region_is_refused) {
  const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Scene scene{.material = {.young_modulus = 1, .poisson_ratio = 0, .density = 1},
                    .plates = {},
                    .tractions = {{.region = "lid", .stress = Vector3::UnitX()}},
                    .gravity = Vector3::Zero()};
  BOOST_CHECK_THROW(traction_forces(mesh, scene), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
