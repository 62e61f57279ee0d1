#include "comparisons/tables/theory/integrator_regions.hpp"

#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "meshing/generators/generate_block.hpp"
#include "mss/forces/forces.hpp"
#include "mss/motion/dynamics.hpp"
#include "mss/motion/implicit_motion.hpp"

using namespace springcheck;
using dynamics::Integrator;
using Complex = std::complex<double>;

BOOST_AUTO_TEST_SUITE(integrator_regions_test)

namespace {

const Integrator symplectic[] = {Integrator::semi_implicit_euler, Integrator::verlet};

/// dt Gamma of the oscillator of omega dt = r.
Complex rate(double r, double zeta) {
  return r * Complex(-zeta, std::sqrt(1 - zeta * zeta));
}

/// What a step multiplies x by on the test equation x' = Gamma x, taken from the step
/// itself with dt = 1: a step of explicit Euler, and for implicit Euler, whose step it is
/// backwards, one over that by -dt. Not for the others, which step a pair of x and v.
/// rate: dt Gamma. Source: Golec 2018, Eq. 2.28, 2.32 and 2.34.
std::complex<double> amplification(Integrator integrator, std::complex<double> rate) {
  const bool is_implicit = integrator == Integrator::implicit_euler;
  std::complex<double> x = 1, v = rate;
  dynamics::step(Integrator::explicit_euler, x, v, rate * v, is_implicit ? -1. : 1.,
                 is_implicit ? -1. : 1.);
  return is_implicit ? 1. / x : x;
}

}  // namespace

// The factors are 1 + dt Gamma and 1/(1 - dt Gamma), Golec 2018, Eq. 2.33 and 2.35. The
// tolerance is round-off.
BOOST_AUTO_TEST_CASE(the_euler_pair_has_the_thesis_s_amplification) {
  for (const Complex z :
       {Complex(-1, 0), Complex(-2.5, 1), Complex(0, 0.5), Complex(1, 2)}) {
    BOOST_TEST(std::abs(amplification(Integrator::explicit_euler, z) - (1. + z)) < 1e-15);
    BOOST_TEST(std::abs(amplification(Integrator::implicit_euler, z) - 1. / (1. - z)) <
               1e-15);
  }
}

// The oscillator's eigenvalues are Gamma and its conjugate: a step of it amplifies as one
// of x' = Gamma x does.
BOOST_AUTO_TEST_CASE(oscillators_are_pairs_of_the_test_equation,
                     *boost::unit_test::tolerance(1e-13)) {
  for (const Integrator integrator :
       {Integrator::explicit_euler, Integrator::implicit_euler})
    for (const double zeta : {-0.9, -0.3, 0., 0.2, 0.8})
      for (const double r : {0.1, 1., 3.})
        BOOST_TEST(spectral_radius(integrator, r, zeta) ==
                   std::abs(amplification(integrator, rate(r, zeta))));
}

// Beyond zeta = 1 Gamma is two real rates, -zeta +- sqrt(zeta^2 - 1): the faster one
// limits explicit steps, the slower one is the last to decay in implicit ones.
BOOST_AUTO_TEST_CASE(overdamped_oscillators_have_two_rates,
                     *boost::unit_test::tolerance(1e-13)) {
  const double zeta = 1.25, slow = 0.5, fast = 2;  // zeta^2 - 1 = .75^2
  for (const double r : {0.3, 1.2}) {
    BOOST_TEST(spectral_radius(Integrator::explicit_euler, r, zeta) ==
               std::max(std::abs(1 - r * slow), std::abs(1 - r * fast)));
    BOOST_TEST(spectral_radius(Integrator::implicit_euler, r, zeta) ==
               1 / (1 + r * slow));
  }
}

// Eigenvalues of the symplectic step have the product 1 - 2 zeta r and the sum
// 2 - 2 zeta r - r^2, and of a conjugate pair the modulus is the product's root.
BOOST_AUTO_TEST_CASE(symplectic_steps_have_the_polynomial_s_roots,
                     *boost::unit_test::tolerance(1e-13)) {
  for (const Integrator integrator : symplectic)
    for (const double zeta : {-0.2, 0., 0.1, 0.4}) {
      const double r = 0.7;
      BOOST_TEST(spectral_radius(integrator, r, zeta) == std::sqrt(1 - 2 * zeta * r));
      const double half = 1 - zeta * 5 - 12.5;  // beyond the limit, r = 5
      BOOST_TEST(spectral_radius(integrator, 5, zeta) ==
                 std::abs(half) + std::sqrt(half * half - 1 + 10 * zeta));
    }
}

// Bisected to 1e-12, where the radius is within 1e-12 of 1 and, with zeta, grows by .1
// and more per unit of r: 1e-10.
BOOST_AUTO_TEST_CASE(borders_lie_on_the_circles_of_figures_2_2_and_2_3) {
  for (const double zeta : {0.1, 0.3, 0.6, 0.9, 1.}) {
    const Complex explicit_border =
                      rate(region_border(Integrator::explicit_euler, zeta), zeta),
                  implicit_border =
                      rate(region_border(Integrator::implicit_euler, -zeta), -zeta);
    BOOST_TEST(std::abs(std::abs(explicit_border + 1.) - 1) < 1e-10);
    BOOST_TEST(std::abs(std::abs(implicit_border - 1.) - 1) < 1e-10);
    for (const Integrator integrator : symplectic) {
      const Complex border = rate(region_border(integrator, zeta), zeta);
      BOOST_TEST(border.real() < 0);
      BOOST_TEST(std::abs(std::abs(border - 2.) - 2 * std::sqrt(2.)) < 1e-10);
    }
  }
}

// At zeta = 0 explicit Euler's radius leaves 1 with r^2/2 only, so that 1e-12 stands for
// 1.5e-6.
BOOST_AUTO_TEST_CASE(borders_are_those_on_paper) {
  for (const Integrator integrator : {Integrator::explicit_euler, symplectic[0],
                                      symplectic[1], Integrator::implicit_euler})
    for (const double zeta : {-1., -0.5, 0., 0.05, 0.5, 1., 1.5, 3.}) {
      const bool is_grazing = integrator == Integrator::explicit_euler && zeta == 0;
      BOOST_TEST(
          std::abs(region_border(integrator, zeta) - border_on_paper(integrator, zeta)) <
              (is_grazing ? 1.5e-6 : 1e-10),
          "integrator " << static_cast<int>(integrator) << ", zeta " << zeta);
    }
}

// The whole circle of figure 2.3 is not stable: to the right of the imaginary axis
// motions of negative damping grow, as they do in truth.
BOOST_AUTO_TEST_CASE(symplectic_steps_grow_right_of_the_imaginary_axis) {
  for (const Integrator integrator : symplectic)
    for (const double r : {0.01, 1., 2.})
      BOOST_TEST(spectral_radius(integrator, r, -0.1) > 1);
}

// Implicit Euler of the springs' dynamics, whose step is not dynamics::step: one free
// node among eight cells whose surface is held, its states of unit displacement and
// velocity. Springs are linear to the displacement over h, 1e-7, there; residuals are
// 1e-10.
BOOST_AUTO_TEST_CASE(the_springs_implicit_step_amplifies_like_the_inverse) {
  constexpr double h = 0.005, probe = 1e-7 * h;
  constexpr std::size_t node = 13;
  const Mesh mesh = generate_block({.size = {2 * h, 2 * h, 2 * h}, .cells = {2, 2, 2}});
  const Scene scene{
      .material = {.young_modulus = 1e4, .poisson_ratio = 0.25, .density = 1000},
      .plates = {},
      .boundary_gradient = Eigen::Matrix3d::Zero(),
      .gravity = Vector3::Zero()};
  const mss::Network network =
      mss::build_network(mesh, scene.material,
                         {.model = mss::SpringModel::cf,
                          .stiffness_form = mss::StiffnessForm::shear_modulus,
                          .diagonal_ratio = 1});
  for (const double given : {0., 0.2}) {
    const auto pull = [&](double u, double v) {
      std::vector<Vector3> x = network.rest_positions, forces(x.size()),
                           velocities(x.size(), Vector3::Zero());
      x[node].x() += u;
      velocities[node].x() = v;
      mss::nodal_forces(network, x, forces);
      mss::add_dashpot_forces(network, given, x, velocities, forces);
      return forces[node].x();
    };
    const double m = network.masses[node], omega = std::sqrt(-pull(probe, 0) / probe / m),
                 zeta = -pull(0, 1) / m / (2 * omega);
    for (const double phase : {0.3, 2., 20.}) {
      const double dt = phase / omega;
      Eigen::Matrix2d matrix;
      for (const int unit : {0, 1}) {
        const auto motion = mss::implicit_motion(mesh, scene, network, given);
        dynamics::State state = motion->state();
        (unit == 0 ? state.displacements : state.velocities)[node].x() =
            unit == 0 ? probe : probe * omega;
        motion->restore(state);
        const auto at = dynamics::support_motions(scene, 0);
        motion->advance({.dt = dt,
                         .kick = dt,
                         .load_fraction = 0,
                         .motions_before = at,
                         .motions = at});
        matrix.col(unit) << motion->state().displacements[node].x() / probe,
            motion->state().velocities[node].x() / (probe * omega);
      }
      BOOST_TEST(matrix.eigenvalues().cwiseAbs().maxCoeff() ==
                     spectral_radius(Integrator::implicit_euler, phase, zeta),
                 boost::test_tools::tolerance(1e-5));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
