// mss-uniform as a user meets it: what the formula promises of a whole body.

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "comparisons/cases/mechanical_scene.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(uniform_test)

namespace {

/// The stress and contraction of a cube of 2^3 cells between sliding plates.
struct Stretched {
  double stress;       // nominal, along the axis [Pa]
  double contraction;  // of its width
};

Stretched stretched(double nu, double strain) {
  const CaseSettings settings =
      case_of("uniaxial", {"method=mss-uniform", "cells=2,2,2", "size=.05,.05,.05",
                           "nu=" + std::to_string(nu), "young=10kPa",
                           "deformation=" + std::to_string(strain)});
  const Mesh mesh = build_mesh(settings.body);
  const Scene scene = mechanical_scene(settings, mesh);
  const Solution solution = settings.method.solve(settings, mesh, scene, 1, {});
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok));
  double force = 0, width = 0;
  for (NodeIndex n = 0; n < mesh.nodes().size(); ++n) {
    if (mesh.nodes()[n].z() > 0.049) force += solution.reactions[n].z();
    width = std::max(width, mesh.nodes()[n].x() + solution.displacements[n].x());
  }
  return {.stress = force / (0.05 * 0.05), .contraction = 1 - width / 0.05};
}

/// The odd part of a quantity over the strain, at strain 0: what is even in it is gone in
/// differences, what is of third order by Richardson's rule; of fifth order 1e-12 is
/// left.
template <class Of>
double slope_at_rest(double nu, const Of& of) {
  constexpr double e = 1e-3;
  const auto slope = [&](double strain) {
    return (of(stretched(nu, strain)) - of(stretched(nu, -strain))) / (2 * strain);
  };
  return (4 * slope(e) - slope(2 * e)) / 3;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_cube_has_youngs_modulus_along_its_axis,
                     *boost::unit_test::tolerance(1e-10)) {
  for (const double nu : {0., 0.25, 0.4})
    BOOST_TEST(slope_at_rest(nu, [](const Stretched& s) { return s.stress; }) == 1e4);
}

BOOST_AUTO_TEST_CASE(its_poisson_ratio_is_five_nineteenths_whatever_is_asked_for,
                     *boost::unit_test::tolerance(1e-10)) {
  for (const double nu : {0., 0.4})
    BOOST_TEST(slope_at_rest(nu, [](const Stretched& s) { return s.contraction; }) ==
               5. / 19);
}

BOOST_AUTO_TEST_CASE(boxes_are_refused_in_words) {
  const CaseSettings settings =
      case_of("compression", {"method=mss-uniform", "cells=2,2,2", "size=.05,.05,.06"});
  const Mesh mesh = build_mesh(settings.body);
  const Solution solution =
      settings.method.solve(settings, mesh, mechanical_scene(settings, mesh), 1, {});
  BOOST_TEST((solution.status == SolveStatus::refused));
  BOOST_TEST(solution.reason == "its springs need cubic cells, and hexahedron 1 is none");
}

BOOST_AUTO_TEST_SUITE_END()
