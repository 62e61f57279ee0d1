#include "comparisons/studies/formal_order.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "comparisons/methods/methods.hpp"

#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(formal_order_test)

namespace {

double order_of(const char* scene, const std::vector<std::string>& changes) {
  return formal_order(requests(run_of(scene, changes)).front().settings);
}

}  // namespace

// By hand: at nu = .3 and k = 1.8, a = .7112 has 1.8 sin^2(64.0 deg) = 1.4542 and 1.96 -
// a^2 = 1.4542. At 1/2 the equation is sin^2(a pi/2) = 1 - a^2.
BOOST_AUTO_TEST_CASE(exponents_beside_a_clamped_edge) {
  BOOST_TEST(std::abs(clamped_edge_exponent(0.3) - 0.7112) < 5e-5);
  const double near_half = clamped_edge_exponent(0.5 - 1e-12);
  BOOST_TEST(std::abs(std::pow(std::sin(near_half * std::numbers::pi / 2), 2) - 1 +
                      near_half * near_half) < 1e-10);
  BOOST_TEST(std::abs(2 * near_half - least_formal_order) < 5e-4);
  BOOST_TEST(2 * near_half >= least_formal_order);
  for (const double nu : {0., -0.3, -0.9}) BOOST_TEST(clamped_edge_exponent(nu) == 1);
  for (const double nu : {0.1, 0.25, 0.4, 0.49})
    BOOST_TEST(clamped_edge_exponent(nu) > clamped_edge_exponent(nu + 0.005));
}

// 2 a of glued plates; the element's own where plates slide, or nothing is held at an
// edge; never above the element's.
BOOST_AUTO_TEST_CASE(orders_of_scenes_and_elements) {
  const double glued = 2 * clamped_edge_exponent(0.3);
  for (const char* scene : {"compression", "shearing", "torsion", "bending"})
    for (const char* method :
         {"method=fem-hooke:q2", "method=fem-hencky", "method=mss-cf"})
      BOOST_TEST(order_of(scene, {"nu=0.3", method}) == glued);
  BOOST_TEST(order_of("uniaxial", {"nu=0.3", "method=fem-hooke:q2"}) == 3);
  BOOST_TEST(order_of("uniaxial", {"nu=0.3", "method=mss-affine"}) == 2);
  BOOST_TEST(order_of("affine", {"nu=0.3", "method=fem-hooke:q1"}) == 2);
  BOOST_TEST(order_of("compression", {"nu=-0.3", "method=fem-hooke:q2"}) == 2);
  BOOST_TEST(order_of("traction", {"nu=0.3", "plates=sliding", "method=fem-hooke"}) == 2);
  BOOST_TEST(order_of("traction", {"nu=0.3", "plates=glued", "method=fem-hooke"}) ==
             glued);
  // Their faces meet plates at any angle.
  BOOST_TEST(order_of("compression", {"body=kidney", "cell-type=free-hexahedron",
                                      "method=fem-hooke"}) == 1);
  // The lattice of mss-fd has a Poisson's ratio of its own.
  for (const char* nu : {"nu=0", "nu=0.3"})
    for (const char* method :
         {"method=fem-cauchy-born", "method=fem-explicit-cauchy-born"})
      BOOST_TEST(
          order_of("compression", {nu, method, "lattice=mss-fd"}) ==
          2 * clamped_edge_exponent(find_method("mss-fd")->own_poisson_ratio.value()));
}

BOOST_AUTO_TEST_SUITE_END()
