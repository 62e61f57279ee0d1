#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "comparisons/measures/measures.hpp"
#include "tests/comparisons/measures/solutions.hpp"

using namespace springcheck;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(loads_test)

// Half of a load is a load of its own: every measure is the one of a case that has it
// whole, against its direction as well. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(measures_are_of_the_load_that_was_reached) {
  constexpr double round_off = 1e-12;
  for (const std::string scene : {"compression", "tension", "shearing", "torsion",
                                  "bending", "uniaxial", "traction", "affine"})
    for (const double fraction : {0.5, -0.25}) {
      const CaseSettings settings = case_of(scene, {"method=mss-cf"});
      const Mesh mesh = build_mesh(settings.body);
      Solution part = moved(mesh, [](const Vector3& x) {
        return Vector3(0.02 * x.z(), -0.01 * x.x() * x.z(), -0.03 * x.z());
      });
      for (std::size_t n = 0; n < mesh.nodes().size(); ++n)
        part.reactions[n] = Vector3(1, -2, 3) + 10 * mesh.nodes()[n];
      Solution reference = part;
      for (Vector3& u : reference.displacements) u *= 1.1;
      Solution whole = part;
      part.load_fraction = fraction;
      Measures m = measure(settings, mesh, part),
               of_own = measure(at_load(settings, fraction), mesh, whole);
      measure_deviation(m, settings, mesh, part, reference);
      measure_deviation(of_own, at_load(settings, fraction), mesh, whole, reference);
      for (const Measure& of : measure_list) {
        const auto expected = measure_of(of_own, of.name), got = measure_of(m, of.name);
        BOOST_TEST_CONTEXT(scene << " at " << fraction << ": " << of.name) {
          BOOST_TEST_REQUIRE(got.has_value() == expected.has_value());
          if (got) BOOST_TEST(std::abs(*got - *expected) <= round_off * std::abs(*got));
        }
      }
    }
}

// 2.5 N of traction at a quarter are .625 N; the centre of a plate that is to move by
// .08 m has moved by .02 m, so that 3 N up, .2 m off its middle, turn by 3 (.2 - .02) N
// m.
BOOST_AUTO_TEST_CASE(forces_and_torques_at_a_quarter_of_the_load,
                     *utf::tolerance(1e-12)) {
  const CaseSettings pulled = case_of("traction", {"method=mss-cf"});
  const Mesh cube = build_mesh(pulled.body);
  Solution quarter = moved(cube, [](const Vector3&) { return Vector3(0, 0, 0); });
  const double whole = measure(pulled, cube, quarter).plate_force.value();
  quarter.load_fraction = 0.25;
  BOOST_TEST(*measure(pulled, cube, quarter).plate_force == whole / 4);

  const CaseSettings sheared = small_block("shearing");
  const Mesh mesh = build_mesh(sheared.body);
  Solution solution = moved(mesh, [](const Vector3&) { return Vector3(0, 0, 0); });
  solution.load_fraction = 0.25;
  for (const NodeIndex n : mesh.region("top").nodes)
    if (mesh.nodes()[n].x() == 0.4 && mesh.nodes()[n].y() == 0.2)
      solution.reactions[n] = Vector3(0, 0, 3);
  BOOST_TEST(measure(sheared, mesh, solution).torque->y() == -3 * (0.2 - 0.02));

  const CaseSettings affine = case_of("affine", {"method=mss-cf"});
  const Mesh body = build_mesh(affine.body);
  Solution following = moved(
      body, [&](const Vector3& x) { return Vector3(0.25 * (affine.gradient * x)); });
  following.load_fraction = 0.25;
  BOOST_TEST(*measure(affine, body, following).affine_deviation_relative == 0);
}

// Nothing is imposed: there is no length to divide by, and no theory. What still resists
// does so along what the load was.
BOOST_AUTO_TEST_CASE(measures_without_a_load_at_the_end) {
  const CaseSettings settings = small_block("compression");
  const Mesh mesh = build_mesh(settings.body);
  Solution solution =
      moved(mesh, [](const Vector3& x) { return Vector3(0, 0, -0.01 * x.z()); });
  solution.load_fraction = 0;
  solution.reactions[mesh.region("top").nodes.front()] = Vector3(0, 0, 2);
  Measures m = measure(settings, mesh, solution);
  BOOST_TEST(*m.plate_force == -2.);
  measure_deviation(m, settings, mesh, solution, solution);
  BOOST_TEST(*m.mean_deviation == 0.);
  BOOST_TEST(!m.deviation_l2_relative.has_value());

  // A path has a length that it went, and a direction that it came from.
  CaseSettings path = settings;
  path.solver = Solver::verlet;
  path.dynamics.load = {{.time = 1, .fraction = -0.5}, {.time = 2, .fraction = 0}};
  m = measure(path, mesh, solution);
  BOOST_TEST(*m.plate_force == 2.);
  const auto inside = static_cast<std::size_t>(2 + 5 * (2 + 5 * 4));
  Solution off = solution;
  off.displacements[inside].y() += 0.001;
  measure_deviation(m, path, mesh, off, solution);
  BOOST_TEST(std::abs(*m.deviation_max_relative - 0.001 / 0.04) < 1e-12);

  const CaseSettings bent = small_block("bending");
  const Mesh beam = build_mesh(bent.body);
  Solution after = moved(beam, [](const Vector3&) { return Vector3(-0.1, 0, 0); });
  after.load_fraction = 0;
  m = measure(bent, beam, after);
  BOOST_TEST(std::abs(*m.tip_deflection - 0.1) < 1e-15);
  BOOST_TEST(!m.tip_elastica.has_value());
  measure_deviation(m, bent, beam, after, after);
  BOOST_TEST(!m.deviation_l2_relative.has_value());
}

BOOST_AUTO_TEST_SUITE_END()
