#include "tests/fem_reference/figures.hpp"
#include "meshing/generators/generate_block.hpp"

#include <array>
#include <boost/test/unit_test.hpp>

// Figures that an independent program, or CalculiX where it says so, gave for the same
// meshes. Forces and torques are in N and N m. Unless a comment says otherwise the band
// is one unit of the last printed digit: the figures are stored as printed, rounded or
// cut.

using namespace springcheck;
using namespace springcheck::fem_reference;
using statics::LinearSolver;

BOOST_AUTO_TEST_SUITE(figures_test)

namespace {

constexpr Settings hooke_full{.law = Law::hooke, .element = Element::q1};
constexpr Settings hooke_sri{.law = Law::hooke, .element = Element::q1_sri};
constexpr Settings hooke_q2{.law = Law::hooke, .element = Element::q2};
constexpr Settings st_venant_full{.law = Law::st_venant_kirchhoff,
                                  .element = Element::q1};
constexpr Settings st_venant_sri{.law = Law::st_venant_kirchhoff,
                                 .element = Element::q1_sri};
constexpr Settings hencky_mean{.law = Law::hencky, .element = Element::q1_sri};
constexpr Settings mss_cf{.law = Law::cauchy_born, .element = Element::q1};

const Block thin_beam{.size = {0.004, 0.004, 0.024}, .cells = {4, 4, 24}};

Measured compressed(double strain, double nu, const Settings& settings) {
  return measured(cube_of(10), nu, settings, {0, 0, -strain}, 0);
}
Measured stretched(double strain, double nu, const Settings& settings) {
  return measured(thin_beam, nu, settings, {0, 0, strain}, 0);
}
Measured sheared(double strain, const Settings& settings) {
  return measured(cube_of(10), 0.25, settings, {strain, 0, 0}, 0);
}
Measured twisted(double angle, const Settings& settings) {
  return measured(cube_of(10), 0.25, settings, Vector3::Zero(), angle);
}

/// Drop of the end face's centre node of a clamped beam, E = 2 MPa, g = 10 m/s^2 [m].
double tip_drop(const std::array<double, 3>& size, int cells_across,
                const Settings& settings) {
  const Mesh mesh = generate_block(
      {.size = size, .cells = {cells_across, cells_across, 6 * cells_across}});
  const Solution solution =
      solve(mesh,
            {.material = {.young_modulus = 2e6, .poisson_ratio = 0.25, .density = 1000},
             .plates = {fixed("bottom")},
             .gravity = Vector3(-10, 0, 0)},
            settings);
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
  const Vector3 centre(size[0] / 2, size[1] / 2, size[2]);
  for (const NodeIndex node : mesh.region("top").nodes)
    if ((mesh.nodes()[node] - centre).norm() < 1e-9)
      return -solution.displacements[node].x();
  BOOST_FAIL("no node at the centre of the end face");
  return 0;
}

}  // namespace

// CalculiX 2.20, C3D8: seven printed digits, hence 1e-6 of the force.
BOOST_AUTO_TEST_CASE(full_integration_agrees_with_calculix) {
  const Measured m = compressed(0.05, 0.25, hooke_full);
  check(-m.force.z(), 1.308545, 1e-6 * 1.308545);
  check(m.volume_error, 3.16868, 1e-5);
}

// CalculiX 2.20, C3D8, NLGEOM with *ELASTIC, which is St-Venant-Kirchhoff; seven digits.
BOOST_AUTO_TEST_CASE(st_venant_at_full_integration_agrees_with_calculix) {
  check(-compressed(0.20, 0.25, st_venant_full).force.z(), 3.672755, 1e-6 * 3.672755);
}

BOOST_AUTO_TEST_CASE(volume_errors_in_compression_are_the_stored_figures) {
  check(compressed(0.05, 0, hooke_sri).volume_error, 5.000, 0.001);
  check(compressed(0.05, 0.25, hooke_sri).volume_error, 3.147, 0.001);
  check(compressed(0.05, 0.499, hooke_sri).volume_error, 0.203, 0.001);
  check(compressed(0.20, 0, hooke_sri).volume_error, 20.00, 0.01);
  check(compressed(0.20, 0.25, hooke_sri).volume_error, 13.617, 0.001);
  check(compressed(0.20, 0.499, hooke_sri).volume_error, 3.196, 0.001);

  check(compressed(0.05, 0, hooke_full).volume_error, 5.000, 0.001);
  check(compressed(0.05, 0.25, hooke_full).volume_error, 3.169, 0.001);
  check(compressed(0.05, 0.499, hooke_full).volume_error, 0.289, 0.001);
  check(compressed(0.20, 0.25, hooke_full).volume_error, 13.697, 0.001);
  check(compressed(0.20, 0.499, hooke_full).volume_error, 4.004, 0.001);

  check(compressed(0.05, 0, st_venant_sri).volume_error, 5.000, 0.001);
  check(compressed(0.05, 0.25, st_venant_sri).volume_error, 3.160, 0.001);
  check(compressed(0.05, 0.499, st_venant_sri).volume_error, 0.462, 0.001);
  check(compressed(0.20, 0, st_venant_sri).volume_error, 20.00, 0.01);
  check(compressed(0.20, 0.25, st_venant_sri).volume_error, 13.822, 0.001);
  check(compressed(0.20, 0.499, st_venant_sri).volume_error, 6.397, 0.001);
}

// The law itself changes the plate force at 20 % by a factor of 1.4. St-Venant's figure
// is known as 3.66 to 3.67 N.
BOOST_AUTO_TEST_CASE(compression_forces_depend_on_the_law) {
  check(-compressed(0.20, 0.25, st_venant_sri).force.z(), 3.665, 0.005);
  check(-compressed(0.20, 0.25, hooke_sri).force.z(), 5.22, 0.01);
}

// Hencky's law with mean dilatation. Volumes and torques as printed; forces were printed
// with four or five digits.
BOOST_AUTO_TEST_CASE(hencky_reproduces_its_stored_table) {
  check(compressed(0.05, 0, hencky_mean).volume_error, 5.000, 0.0005);
  check(compressed(0.05, 0.25, hencky_mean).volume_error, 3.094, 0.0005);
  check(compressed(0.05, 0.499, hencky_mean).volume_error, 0.018, 0.0005);
  check(compressed(0.20, 0, hencky_mean).volume_error, 20.00, 0.005);
  check(compressed(0.20, 0.25, hencky_mean).volume_error, 12.706, 0.0005);
  check(compressed(0.20, 0.499, hencky_mean).volume_error, 0.076, 0.0005);

  check(stretched(0.05, 0, hencky_mean).volume_error, 5.000, 0.0005);
  check(stretched(0.05, 0.25, hencky_mean).volume_error, 2.567, 0.0005);
  check(stretched(0.05, 0.499, hencky_mean).volume_error, 0.011, 0.0005);
  check(stretched(0.20, 0, hencky_mean).volume_error, 20.00, 0.005);
  check(stretched(0.20, 0.25, hencky_mean).volume_error, 9.928, 0.0005);
  check(stretched(0.20, 0.499, hencky_mean).volume_error, 0.040, 0.0005);

  check(sheared(0.05, hencky_mean).force.norm(), 0.3329, 0.00005);
  check(sheared(0.20, hencky_mean).force.norm(), 1.3157, 0.00005);
  check(twisted(1 * degree, hencky_mean).torque, 1279.3e-6, 0.05e-6);
  check(twisted(45 * degree, hencky_mean).torque, 56426e-6, 0.5e-6);
}

// The continuum of mss-cf. No other program has it on these grids: these are our own
// figures, kept against unintended change, at the time when extrapolation of them agreed
// with an independent program's converged ones (converged_test.cpp).
BOOST_AUTO_TEST_CASE(cauchy_born_keeps_its_figures) {
  check(compressed(0.05, 0, mss_cf).volume_error, 4.83765, 1e-5);
  check(compressed(0.05, 0.25, mss_cf).volume_error, 3.15211, 1e-5);
  check(compressed(0.20, 0.25, mss_cf).volume_error, 13.47863, 1e-5);
  check(-compressed(0.20, 0.25, mss_cf).force.z(), 4.64906, 1e-5);
  check(stretched(0.20, 0.25, mss_cf).volume_error, 8.71082, 1e-5);
  check(sheared(0.20, mss_cf).force.norm(), 1.45387, 1e-5);
  check(sheared(0.20, mss_cf).force.x(), 1.40367, 1e-5);
  check(twisted(45 * degree, mss_cf).torque, 0.0589914, 1e-7);
  // Near incompressibility the volume correction is taken at the mean, like the springs'.
  constexpr Settings as_springs_do{.law = Law::cauchy_born, .element = Element::q1_sri};
  check(compressed(0.05, 0.499, as_springs_do).volume_error, 0.01870, 1e-5);
  check(-compressed(0.05, 0.499, as_springs_do).force.z(), 1.63182, 1e-5);
}

// Volumetric locking: at nu = .499 and .4999 full integration pushes 2.4 and 14 times as
// hard as selective, while q2 stays within 2 % of that. The volume error hardly shows it.
BOOST_AUTO_TEST_CASE(selective_integration_and_q2_free_the_locked_body) {
  struct {
    double nu, ratio, band;
  } const figures[]{{0.49, 1.17, 0.01}, {0.499, 2.4, 0.05}, {0.4999, 14, 0.5}};
  for (const auto& [nu, ratio, band] : figures) {
    const double free = compressed(0.05, nu, hooke_sri).force.z();
    check(compressed(0.05, nu, hooke_full).force.z() / free, ratio, band);
    check(compressed(0.05, nu, hooke_q2).force.z() / free, 1.01, 0.01);
  }
}

// St-Venant's cube loses definiteness near 30 to 32 % of compression; the direct solver
// gave 31.6 % here, and so does multigrid. Load steps of 1/1024 find it to .03 %.
BOOST_AUTO_TEST_CASE(st_venant_loses_definiteness_at_the_stored_strain) {
  for (const LinearSolver solver : {LinearSolver::direct, LinearSolver::multigrid}) {
    Settings settings = st_venant_sri;
    settings.linear_solver = solver;
    const Solution solution = solve(
        cube(10),
        between_plates({.young_modulus = 1e4, .poisson_ratio = 0.25, .density = 1000},
                       {0, 0, -0.32 * edge}),
        settings);
    BOOST_TEST((solution.status == SolveStatus::no_equilibrium), solution.reason);
    BOOST_TEST_REQUIRE(solution.definite_up_to.has_value());
    check(0.32 * *solution.definite_up_to, 0.316, 0.0005);
  }
}

BOOST_AUTO_TEST_CASE(volume_errors_in_tension_are_the_stored_figures) {
  check(stretched(0.05, 0, hooke_sri).volume_error, 5.000, 0.001);
  check(stretched(0.05, 0.25, hooke_sri).volume_error, 2.493, 0.001);
  check(stretched(0.05, 0.499, hooke_sri).volume_error, 0.174, 0.001);
  check(stretched(0.20, 0, hooke_sri).volume_error, 20.00, 0.01);
  check(stretched(0.20, 0.25, hooke_sri).volume_error, 8.756, 0.001);
  check(stretched(0.20, 0.499, hooke_sri).volume_error, 2.761, 0.001);

  check(stretched(0.05, 0.25, hooke_full).volume_error, 2.507, 0.001);
  check(stretched(0.05, 0.499, hooke_full).volume_error, 0.183, 0.001);
  check(stretched(0.20, 0.25, hooke_full).volume_error, 8.817, 0.001);
  check(stretched(0.20, 0.499, hooke_full).volume_error, 3.006, 0.001);

  check(stretched(0.05, 0.25, st_venant_sri).volume_error, 2.422, 0.001);
  check(stretched(0.20, 0.25, st_venant_sri).volume_error, 7.458, 0.001);
}

BOOST_AUTO_TEST_CASE(sideways_forces_in_shear_are_the_stored_figures) {
  check(sheared(0.05, hooke_sri).force.x(), 0.33314, 1e-5);
  check(sheared(0.05, hooke_full).force.x(), 0.33484, 1e-5);
  check(sheared(0.20, hooke_sri).force.x(), 1.3325, 1e-4);
  check(sheared(0.05, st_venant_sri).force.x(), 0.33499, 1e-5);
  check(sheared(0.20, st_venant_sri).force.x(), 1.4504, 1e-4);
}

// Arms in the undeformed state for Hooke's law, deformed for St-Venant's.
BOOST_AUTO_TEST_CASE(torques_are_the_stored_figures) {
  check(twisted(1 * degree, hooke_sri).torque, 1279.25e-6, 0.01e-6);
  check(twisted(1 * degree, hooke_full).torque, 1282.03e-6, 0.01e-6);
  check(twisted(1 * degree, st_venant_sri).torque, 1279.3e-6, 0.1e-6);
  check(twisted(45 * degree, st_venant_sri).torque, 60333e-6, 1e-6);
}

// 4 x 4 x 24 and 8 x 8 x 48 cells. Euler and Bernoulli have 155.52 um.
BOOST_AUTO_TEST_CASE(centimetre_beam_drops_by_the_stored_figures) {
  const std::array<double, 3> size{0.004, 0.004, 0.024};
  check(tip_drop(size, 4, hooke_sri), 156.96e-6, 0.01e-6);
  check(tip_drop(size, 8, hooke_sri), 157.81e-6, 0.01e-6);
  check(tip_drop(size, 4, hooke_full), 152.74e-6, 0.01e-6);
  check(tip_drop(size, 8, hooke_full), 156.71e-6, 0.01e-6);
  check(tip_drop(size, 4, st_venant_sri), 156.96e-6, 0.01e-6);
}

// The metre beam bends by half its length. The inextensible elastica, without shear,
// drops by 1.218 m; shear adds about 1 % (small-strain Timoshenko against Euler-Bernoulli
// at L/H = 6), extension and the finite strain of St-Venant's law the like: 5 % allowed.
BOOST_AUTO_TEST_CASE(metre_beam_follows_the_elastica) {
  check(tip_drop({0.4, 0.4, 2.4}, 4, st_venant_sri), 1.218, 0.05 * 1.218);
}

BOOST_AUTO_TEST_SUITE_END()
