#include "comparisons/measures/measures.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "comparisons/measures/measure_list.hpp"
#include "meshing/loads/traction.hpp"
#include "tests/comparisons/measures/solutions.hpp"

using namespace springcheck;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(measures_test)

// Homogeneous deformations have closed volumes; the tolerance is round-off.
BOOST_AUTO_TEST_CASE(volumes_of_a_homogeneous_stretch, *utf::tolerance(1e-12)) {
  const CaseSettings settings = small_block("compression");
  const Mesh mesh = build_mesh(settings.body);
  const Measures m = measure(settings, mesh, moved(mesh, [](const Vector3& x) {
                               return Vector3(0.05 * x.x(), 0, -0.1 * x.z());
                             }));
  BOOST_TEST(*m.volume_change == 1.05 * 0.9 - 1);
  BOOST_TEST(*m.volume_error == 1 - 1.05 * 0.9);
  BOOST_TEST(*m.cell_volume_ratio_min == 1.05 * 0.9);
  BOOST_TEST(*m.cell_volume_ratio_max == 1.05 * 0.9);
  BOOST_TEST(*m.corner_jacobian_ratio_min == 1.05 * 0.9);
  BOOST_TEST(!m.mean_deviation.has_value());
  BOOST_TEST(!m.tip_deflection.has_value());
}

BOOST_AUTO_TEST_CASE(a_measure_by_its_name) {
  Measures m;
  m.plate_force = -2;
  m.face_displacement = Vector3(3, 0, -4);
  BOOST_TEST((measure_of(m, "plate_force") == -2));
  BOOST_TEST((measure_of(m, "face_displacement") == 5));
  BOOST_TEST(!measure_of(m, "plate_torque").has_value());
  BOOST_TEST(!measure_of(m, "plate_farce").has_value());
}

// What answers a test's load is a measure.
BOOST_AUTO_TEST_CASE(tests_are_answered_by_measures) {
  for (const TestName& test : value_names<Test>) {
    const Measure* answer = find_measure(test.answer);
    BOOST_TEST((answer == nullptr) == test.answer.empty(), test.name);
    if (answer != nullptr) BOOST_TEST(answer->traits.is_of(test), test.name);
  }
}

// A force pair of 3 N acts at opposite edges' middles of the plate, +-y at x = centre +-
// .2, which makes a torque of 2 * 3 * .2 about z. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(torque_is_taken_about_the_plates_moved_centre,
                     *utf::tolerance(1e-12)) {
  CaseSettings settings = small_block("shearing");
  const Mesh mesh = build_mesh(settings.body);
  Solution solution =
      moved(mesh, [](const Vector3& x) { return Vector3(0.1 * x.z(), 0, 0); });
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    const Vector3& x = mesh.nodes()[n];
    if (std::abs(x.z() - 0.8) < 1e-9 && std::abs(x.y() - 0.2) < 1e-9) {
      if (x.x() == 0) solution.reactions[n] = Vector3(0, -3, 0);
      if (std::abs(x.x() - 0.4) < 1e-9) solution.reactions[n] = Vector3(2, 3, -1);
    }
  }
  Measures m = measure(settings, mesh, solution);
  BOOST_TEST(*m.plate_torque == 2 * 3 * 0.2);
  BOOST_TEST(m.torque->y() == -(0.2 * -1));
  BOOST_TEST(*m.plate_force == 2);  // sideways, along the motion
  BOOST_TEST(*m.plate_force_norm == std::sqrt(5.));
  BOOST_TEST(m.force->z() == -1);

  // Arms of the plate's own configuration: a motion of the plate changes nothing.
  solution.lever_arms = LeverArms::undeformed;
  m = measure(settings, mesh, solution);
  BOOST_TEST(*m.plate_torque == 2 * 3 * 0.2);
}

BOOST_AUTO_TEST_CASE(plate_force_is_positive_along_the_imposed_motion) {
  for (const auto& [scene, force] :
       {std::pair("compression", -2.), std::pair("tension", 2.)}) {
    const CaseSettings settings = small_block(scene);
    const Mesh mesh = build_mesh(settings.body);
    Solution solution = moved(mesh, [](const Vector3&) { return Vector3(0, 0, 0); });
    solution.reactions[mesh.region("top").nodes.front()] = Vector3(0, 0, force);
    BOOST_TEST(*measure(settings, mesh, solution).plate_force == 2.);
  }
  const CaseSettings torsion = small_block("torsion", "10deg");
  const Mesh mesh = build_mesh(torsion.body);
  const Measures m = measure(
      torsion, mesh, moved(mesh, [](const Vector3&) { return Vector3(0, 0, 0); }));
  BOOST_TEST(!m.plate_force.has_value());  // no direction to take it along
  BOOST_TEST(m.plate_torque.has_value());
}

// At rest the plate's reactions are made up: 2 N down. Both signs count as resistance.
BOOST_AUTO_TEST_CASE(plate_force_of_a_uniaxial_strain_is_positive_where_it_is_resisted) {
  for (const auto& [deformation, force] : {std::pair("-.1", -2.), std::pair(".1", 2.)}) {
    const CaseSettings settings = small_block("uniaxial", deformation);
    const Mesh mesh = build_mesh(settings.body);
    Solution solution = moved(mesh, [](const Vector3&) { return Vector3(0, 0, 0); });
    solution.reactions[mesh.region("top").nodes.front()] = Vector3(0, 0, force);
    BOOST_TEST(*measure(settings, mesh, solution).plate_force == 2.);
  }
}

// 30, -40 and 120 Pa on .4 x .4 m, and a face that rises, tilts and bulges: the mean of x
// y over the square of side a is a^2/4. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(a_traction_s_force_and_its_face_s_mean_displacement,
                     *utf::tolerance(1e-12)) {
  const CaseSettings settings =
      case_of("traction", {"size=.4,.4,.8", "cells=4,2,8", "plates=glued",
                           "traction=30,-40,120", "method=mss-cf"});
  const Mesh mesh = build_mesh(settings.body);
  const Solution solution = moved(mesh, [](const Vector3& x) {
    return Vector3(0.1 * x.x(), -0.05, 0.01 + x.x() * x.y() + (x.z() - 0.8));
  });
  Measures m = measure(settings, mesh, solution);
  BOOST_TEST(*m.plate_force == 0.16 * 130);
  BOOST_TEST(*m.plate_force_norm == 0.16 * 130);
  BOOST_TEST((*m.force - 0.16 * Vector3(30, -40, 120)).norm() < 1e-12);
  BOOST_TEST(m.face_displacement->x() == 0.1 * 0.2);
  BOOST_TEST(m.face_displacement->y() == -0.05);
  BOOST_TEST(m.face_displacement->z() == 0.01 + 0.04);
  BOOST_TEST(!m.plate_torque.has_value());
  BOOST_TEST(!m.mean_stress.has_value());

  // Deviations are divided by the reference's face displacement.
  const Solution reference =
      moved(mesh, [](const Vector3& x) { return Vector3(0, 0, 0.5 * x.z()); });
  Solution off = reference;
  off.displacements.back() += Vector3(0, 0.001, 0);
  measure_deviation(m, settings, mesh, off, reference);
  BOOST_TEST(*m.deviation_max_relative == 0.001 / (0.5 * 0.8));
}

// Reactions P N dA of a uniform stress give P back: with A the side's area, r = +-P N A
// shared alike by its nodes' areas. A stress that is not symmetric shows rows from
// columns. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(mean_stress_is_the_stress_that_the_boundary_carries,
                     *utf::tolerance(1e-12)) {
  const CaseSettings settings = case_of("affine", {"cells=3,4,2", "method=mss-cf"});
  const Mesh mesh = build_mesh(settings.body);
  Eigen::Matrix3d P;
  P << 1, 2, 3, -4, 5, 6, 7, -8, 9;
  Solution solution =
      moved(mesh, [&](const Vector3& x) { return Vector3(settings.gradient * x); });
  const std::pair<const char*, Vector3> sides[] = {
      {"x_min", {-1, 0, 0}}, {"x_max", {1, 0, 0}},   {"y_min", {0, -1, 0}},
      {"y_max", {0, 1, 0}},  {"bottom", {0, 0, -1}}, {"top", {0, 0, 1}}};
  for (const auto& [name, normal] : sides) {
    const std::vector<double> areas = nodal_areas(mesh, mesh.region(name));
    for (std::size_t n = 0; n < areas.size(); ++n)
      solution.reactions[n] += areas[n] * P * normal;
  }
  Measures m = measure(settings, mesh, solution);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) BOOST_TEST((*m.mean_stress)(i, j) == P(i, j));
  BOOST_TEST(*m.affine_deviation_relative == 0);
  BOOST_TEST(!m.plate_force.has_value());

  // One of 2 x 3 x 1 nodes inside is off by d. They are all of the same weight.
  const double d = 0.001;
  const auto inside = static_cast<std::size_t>(1 + 4 * (1 + 5 * 1));
  solution.displacements[inside] += Vector3(0, 0, d);
  m = measure(settings, mesh, solution);
  double imposed = 0;
  for (const Vector3& x : mesh.nodes())
    imposed = std::max(imposed, (settings.gradient * x).norm());
  BOOST_TEST(*m.affine_deviation_relative == d / std::sqrt(6.) / imposed);
}

BOOST_AUTO_TEST_CASE(loss_of_definiteness_is_reported_as_a_deformation,
                     *utf::tolerance(1e-15)) {
  const auto measured = [](const CaseSettings& settings) {
    const Mesh mesh = build_mesh(settings.body);
    Solution solution = moved(mesh, [](const Vector3&) { return Vector3(0, 0, 0); });
    const bool never = !measure(settings, mesh, solution).definite_up_to_deformation;
    BOOST_TEST(never);
    solution.definite_up_to = 0.3;
    return measure(settings, mesh, solution).definite_up_to_deformation;
  };
  BOOST_TEST(*measured(small_block("compression", ".2")) == 0.3 * 0.2);
  BOOST_TEST(*measured(small_block("uniaxial", "-.2")) == 0.3 * -0.2);
  BOOST_TEST(!measured(small_block("bending")).has_value());
}

// A solution whose field is not trilinear knows its volumes itself. The tolerance is
// round-off.
BOOST_AUTO_TEST_CASE(a_solution_s_own_cell_volumes_count, *utf::tolerance(1e-12)) {
  const CaseSettings settings = small_block("compression");
  const Mesh mesh = build_mesh(settings.body);
  const Solution trilinear = moved(mesh, [](const Vector3&) { return Vector3(0, 0, 0); });
  Solution solution = trilinear;
  solution.cell_volumes = mesh.cell_volumes();
  solution.cell_volumes.front() *= 0.5;
  solution.cell_volumes.back() *= 1.25;
  Measures m = measure(settings, mesh, solution);
  BOOST_TEST(*m.volume_change == -0.25 / 128);
  BOOST_TEST(*m.cell_volume_ratio_min == 0.5);
  BOOST_TEST(*m.cell_volume_ratio_max == 1.25);
  BOOST_TEST(*m.corner_jacobian_ratio_min == 1);
  measure_deviation(m, settings, mesh, solution, trilinear);
  BOOST_TEST(*m.cell_volume_ratio_rms_difference ==
             std::sqrt((0.5 * 0.5 + 0.25 * 0.25) / 128));
}

// A block bent exactly as a theory says lies on that theory's line. The tolerance is
// round-off.
BOOST_AUTO_TEST_CASE(the_centre_line_is_compared_with_each_theory) {
  const CaseSettings settings = case_of("bending", {"method=mss-cf"});
  const Mesh mesh = build_mesh(settings.body);
  // w/(24 E I) with w = 1600 N/m, E I = 2e6 * .4^4/12; gravity is along -x.
  const double c = 1600 / (24 * 2e6 * std::pow(0.4, 4) / 12), L = 2.4;
  const Measures m = measure(
      settings, mesh, moved(mesh, [&](const Vector3& x) {
        const double s = x.z();
        return Vector3(-c * (std::pow(s, 4) - 4 * L * std::pow(s, 3) + 6 * L * L * s * s),
                       0, 0);
      }));
  BOOST_TEST(std::abs(*m.tip_deflection - *m.tip_euler_bernoulli) < 1e-12);
  BOOST_TEST(*m.centre_line_euler_bernoulli < 1e-12);
  BOOST_TEST(std::abs(*m.centre_line_timoshenko -
                      (*m.tip_timoshenko - *m.tip_euler_bernoulli)) < 1e-12);
  BOOST_TEST(*m.centre_line_elastica > 0.3);

  // Gravity is along x: what goes along y counts, too.
  const Solution aside = moved(mesh, [&](const Vector3&) { return Vector3(0, 0.4, 0); });
  const Solution still = moved(mesh, [&](const Vector3&) { return Vector3(0, 0, 0); });
  BOOST_TEST(
      *measure(settings, mesh, aside).centre_line_euler_bernoulli ==
          std::hypot(0.4, *measure(settings, mesh, still).centre_line_euler_bernoulli),
      boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
