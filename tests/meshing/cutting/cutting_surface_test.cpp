#include "meshing/cutting/cutting_surface.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace springcheck;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_SUITE(cutting_surface_test)

BOOST_AUTO_TEST_CASE(heights_over_planes_boxes_and_cylinders) {
  const Plane plane{.normal = Vector3(1, 2, 2) / 3, .offset = 1};
  BOOST_TEST(height_over(plane, {3, 3, 3}) == 4, tolerance(1e-14));
  BOOST_TEST(height_over(plane, {0, 0, 0}) == -1);

  const Box box{.low = {0, 0, 0}, .high = {1, 2, 3}};
  BOOST_TEST(height_over(box, {0.5, 1, 0.25}) == -0.25);
  BOOST_TEST(height_over(box, {1.5, 1, 1}) == 0.5);

  const Cylinder cylinder{.from = {1, 0, 0}, .to = {1, 0, 2}, .radius = 0.5};
  BOOST_TEST(height_over(cylinder, {1, 2, 1}) == 1.5, tolerance(1e-14));
  BOOST_TEST(height_over(cylinder, {1.25, 0, 7}) == -0.25, tolerance(1e-14));
  BOOST_TEST(past_end(plane, {3, 3, 3}) == 0);
  BOOST_TEST(past_end(box, {3, 3, 3}) == 0);
  BOOST_TEST(past_end(cylinder, {1, 5, 2}) == 0);
  BOOST_TEST(past_end(cylinder, {1, 0, 2.25}) == 0.25);
  BOOST_TEST(past_end(cylinder, {1, 0, -0.125}) == 0.125);
}

// Along x to (1, 0, 1), then along y, which goes up; 0.5 deep.
BOOST_AUTO_TEST_CASE(blade_goes_around_a_bend) {
  const Blade blade{.points = {{0, 0, 1}, {1, 0, 1}, {1, 1, 2}}, .depth = {0, 0, -0.5}};
  // Left of the way is above.
  BOOST_TEST(height_over(blade, {0.5, 0.2, 0.8}) == 0.2, tolerance(1e-14));
  BOOST_TEST(height_over(blade, {0.5, -0.2, 0.8}) == -0.2, tolerance(1e-14));
  BOOST_TEST(height_over(blade, {0.8, 0.5, 1.4}) == 0.2, tolerance(1e-14));
  // Outside the bend, both stretches count.
  BOOST_TEST(height_over(blade, {1.1, -0.1, 1}) == -0.1 * std::sqrt(2), tolerance(1e-14));
  BOOST_TEST(height_over(blade, {1.3, -0.1, 1}) < 0);

  BOOST_TEST(past_end(blade, {0.5, 0.2, 0.6}) == 0);
  BOOST_TEST(past_end(blade, {0.5, 0.2, 0.25}) == 0.25);    // deeper than the blade
  BOOST_TEST(past_end(blade, {0.5, 0.2, 1.125}) == 0.125);  // above it
  BOOST_TEST(past_end(blade, {1, 0.5, 0.875}) == 0.125,
             tolerance(1e-14));  // it is at 1.5
  BOOST_TEST(past_end(blade, {1, 0.5, 1.1}) == 0);
  BOOST_TEST(past_end(blade, {-0.125, 0, 0.8}) == 0.125);  // before it begins
  BOOST_TEST(past_end(blade, {1, 1.125, 1.9}) == 0.125, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(boxes_and_cylinders_enclose) {
  BOOST_TEST(encloses(Box{.low = {0, 0, 0}, .high = {1, 1, 1}}));
  BOOST_TEST(encloses(Cylinder{.from = {0, 0, 0}, .to = {0, 0, 1}, .radius = 1}));
  BOOST_TEST(!encloses(Plane{.normal = {0, 0, 1}, .offset = 0}));
  BOOST_TEST(!encloses(Blade{.points = {{0, 0, 0}, {1, 0, 0}}, .depth = {0, 0, 1}}));
}

BOOST_AUTO_TEST_SUITE_END()
