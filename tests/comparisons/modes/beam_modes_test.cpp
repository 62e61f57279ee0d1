#include <boost/test/unit_test.hpp>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "comparisons/modes/beam_frequencies.hpp"
#include "comparisons/modes/beam_motion.hpp"
#include "fem_reference/statics/modes.hpp"
#include "meshing/generators/generate_block.hpp"

using namespace springcheck;
using std::numbers::pi;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(beam_modes_test)

namespace {

SquareCantilever beam(double edge) {
  return {.length = 2.4,
          .edge = edge,
          .material = {.young_modulus = 2e6, .poisson_ratio = 0.25, .density = 1000}};
}

/// Timoshenko's frequencies [Hz] by Ritz: w and the section's turn in powers of x/L from
/// the first on, which integrals of monomials make exact.
Eigen::VectorXd ritz(const SquareCantilever& b) {
  constexpr int n = 9;
  const double L = b.length, A = b.edge * b.edge, I = A * A / 12,
               E = b.material.young_modulus, rho = b.material.density,
               kGA = 5. / 6 * lame_constants(b.material).mu * A;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(2 * n, 2 * n), M = K;
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= n; ++j) {
      const int w = i - 1, v = j - 1, t = n + i - 1, s = n + j - 1;
      const double values = L / (i + j + 1), slopes = i * j / (L * (i + j - 1));
      M(w, v) = rho * A * values;
      M(t, s) = rho * I * values;
      K(w, v) = kGA * slopes;
      K(t, s) = E * I * slopes + kGA * values;
      K(w, s) = K(s, w) = -kGA * i / (i + j);
    }
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(K, M)
             .eigenvalues()
             .cwiseSqrt() /
         (2 * pi);
}

}  // namespace

// The values b of the first three modes are the tabulated 1.87510407, 4.69409113,
// 7.85475744 squared (Blevins 1979, table 8-1), to the digits printed.
BOOST_AUTO_TEST_CASE(euler_bernoulli_s_numbers_are_blevins_s, *utf::tolerance(1e-8)) {
  const double unit = std::sqrt(2e6 / 1000) * 0.4 / std::sqrt(12) / (2 * pi * 2.4 * 2.4);
  const double roots[] = {1.87510407, 4.69409113, 7.85475744};
  for (int n = 1; n <= 3; ++n)
    BOOST_TEST(euler_bernoulli_frequency(beam(0.4), n) ==
               roots[n - 1] * roots[n - 1] * unit);
}

// The frequencies are compared with Ritz's with powers up to the ninth, which are 1e-5
// above for the third mode. A thin beam is Euler and Bernoulli's, to the order of (n
// a/L)^2.
BOOST_AUTO_TEST_CASE(timoshenko_s_frequencies_are_ritz_s) {
  const Eigen::VectorXd expected = ritz(beam(0.4));
  for (int n = 1; n <= 3; ++n)
    BOOST_TEST(timoshenko_frequency(beam(0.4), n) == expected[n - 1],
               boost::test_tools::tolerance(2e-5));
  BOOST_TEST(
      timoshenko_frequency(beam(0.004), 1) == euler_bernoulli_frequency(beam(0.004), 1),
      boost::test_tools::tolerance(1e-4));
  BOOST_CHECK_THROW(timoshenko_frequency(beam(1.2), 20), std::domain_error);
}

// Finite elements on a beam twelve times as long as thick at nu = 0, where the clamp
// hinders no contraction, each mode known by its motion. The band is discretisation:
// trilinear cells, 8 across and twice as long, are up to 1.6 % too stiff in bending;
// without shear Euler and Bernoulli would be off by 2.2 % in the second bending.
BOOST_AUTO_TEST_CASE(finite_elements_swing_as_beams_do, *utf::tolerance(0.02)) {
  SquareCantilever thin = beam(0.2);
  thin.material.poisson_ratio = 0;
  const Mesh mesh =
      generate_block({.size = {thin.edge, thin.edge, thin.length}, .cells = {8, 8, 48}});
  const Scene scene{.material = thin.material,
                    .plates = {{.region = "bottom",
                                .motion = {.translation = Vector3::Zero(),
                                           .axis = Vector3::UnitZ(),
                                           .centre = Vector3::Zero(),
                                           .angle = 0},
                                .held = all_components}},
                    .gravity = Vector3::Zero()};
  const auto modes =
      fem_reference::rest_modes(
          mesh, scene,
          {.law = fem_reference::Law::hooke, .element = fem_reference::Element::q1_sri},
          fem_reference::MassMatrix::consistent, 8)
          .value();
  const auto expect = [&](int mode, BeamMotion motion, double frequency) {
    BOOST_TEST(name_of(beam_motion(mesh, modes.shapes.col(mode))) == name_of(motion));
    BOOST_TEST(modes.frequencies[mode] == frequency);
  };
  expect(0, BeamMotion::bending, timoshenko_frequency(thin, 1));
  expect(1, BeamMotion::bending, timoshenko_frequency(thin, 1));
  expect(2, BeamMotion::bending, timoshenko_frequency(thin, 2));
  expect(4, BeamMotion::torsion, torsion_frequency(thin, 1));
  expect(5, BeamMotion::bending, timoshenko_frequency(thin, 3));
  expect(7, BeamMotion::stretching, stretching_frequency(thin, 1));
}

BOOST_AUTO_TEST_SUITE_END()
