#include <boost/test/unit_test.hpp>

#include "tests/fem_reference/laws.hpp"

// Hencky's law against closed forms, and where its principal stretches meet.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(hencky_test)

namespace {

Hencky hencky_at(double nu) {
  return hencky(lame_constants(of_poisson_ratio(nu)));
}

/// The gradient whose stretches these are, along turned axes, followed by a rotation.
Matrix3 stretched(double x, double y, double z) {
  const Matrix3 N = rotation(0.7, {1, 2, 3});
  return turned(rotation(-1.1, {2, 0, 1}), N * diagonal(x, y, z) * N.transpose());
}

/// Largest difference between the tangent and the derivative of the stress [Pa].
double tangent_error(const Hencky& law, const Matrix3& H) {
  const auto stresses = [&](const Matrix3& G) -> Eigen::VectorXd {
    return law.stress(G).reshaped();
  };
  return largest(gradient(stresses, H) - law.tangent(H));
}

}  // namespace

// A free bar of stretch l contracts by l^-nu; its Kirchhoff stress is E ln l, so P = E ln
// l / l and psi = E/2 (ln l)^2: Hooke's law in logarithmic strain. The tolerance is
// round-off, of the moduli.
BOOST_AUTO_TEST_CASE(bar_pulls_with_youngs_modulus_times_logarithmic_strain) {
  for (const double nu : poisson_ratios)
    for (const double l : {0.6, 0.8, 1.2, 1.7}) {
      const Constitution law = hencky_at(nu);
      const double lateral = std::pow(l, -nu) - 1;
      const Matrix3 H = diagonal(lateral, lateral, l - 1);
      const double band = 1e-14 * stiffness_scale(of_poisson_ratio(nu));
      BOOST_TEST(largest(stress(law, H) - diagonal(0, 0, young * std::log(l) / l)) <
                 band);
      BOOST_TEST(std::abs(energy(law, H) - young / 2 * std::pow(std::log(l), 2)) < band);
    }
}

// Kirchhoff stress 2 mu dev ln V + K ln J I, along the turned axes. The tolerance is
// round-off.
BOOST_AUTO_TEST_CASE(kirchhoff_stress_is_linear_in_logarithmic_strain) {
  const Constitution law = hencky_at(0.3);
  const auto [lambda, mu] = lame_constants(of_poisson_ratio(0.3));
  const Matrix3 N = rotation(1.9, {-1, 0.3, 2}), R = rotation(2.5, {1, 1, 0.2});
  const Eigen::Array3d l(0.7, 1.1, 1.4), e = l.log();
  const Matrix3 F = N * l.matrix().asDiagonal() * N.transpose() * R;
  const Matrix3 kirchhoff =
      N * (lambda * e.sum() + 2 * mu * e).matrix().asDiagonal() * N.transpose();
  const Matrix3 P = stress(law, F - Matrix3::Identity());
  BOOST_TEST(largest(P * F.transpose() - kirchhoff) < 1e-14 * young);
}

// F = l I: dev ln V = 0 and P = 3 K ln l / l I. Moduli of a further small strain in the
// spatial frame: 2 mu on deviators.
BOOST_AUTO_TEST_CASE(equal_stretches_need_no_case_of_their_own) {
  const Hencky law = hencky_at(0.3);
  for (const double l : {0.7, 1., 1.5}) {
    const Matrix3 H = diagonal(l - 1, l - 1, l - 1);
    BOOST_TEST(largest(law.stress(H)) < 1e-13 * young);
    BOOST_TEST(largest(stress(law, H) - 3 * law.bulk_modulus * std::log(l) / l *
                                            Matrix3::Identity()) < 1e-13 * young);
    const Matrix9 hookes = hooke(lame_constants(of_poisson_ratio(0.3))).tangent(H);
    BOOST_TEST(largest(law.tangent(H) - hookes / (l * l)) < 1e-13 * young);
  }
}

// Where two stretches, or all three, differ by 1e-9, a plain quotient of differences
// keeps seven digits. Here the tangent matches differences of the stress as everywhere
// else (laws.hpp: 1e-9 of the moduli at stretches of .7), and is that of equal stretches
// to the 1e-9 by which the strain differs, times derivatives of the moduli of about 10.
BOOST_AUTO_TEST_CASE(nearly_equal_stretches_lose_no_digits) {
  const Hencky law = hencky_at(0.3);
  for (const double gap : {0., 1e-14, 1e-11, 1e-9, 1e-7, 1e-4}) {
    BOOST_TEST_CONTEXT("gap " << gap) {
      BOOST_TEST(tangent_error(law, stretched(0.2, 0.2 + gap, -0.1)) < 1e-9 * young);
      BOOST_TEST(tangent_error(law, stretched(-0.3, -0.3 + gap, -0.3 - gap)) <
                 1e-9 * young);
      BOOST_TEST(tangent_error(law, stretched(0, gap, -2 * gap)) < 1e-9 * young);
    }
  }
  for (const Matrix3& near :
       {stretched(0.2, 0.2 + 1e-9, -0.1), stretched(0.2, 0.2, -0.1 + 1e-9)})
    BOOST_TEST(largest(law.tangent(near) - law.tangent(stretched(0.2, 0.2, -0.1))) <
               1e-8 * young);
}

// F = diag(1, 1, 1 + e): P_zz = (lambda + 2 mu) ln(1 + e)/(1 + e), P_xx = lambda ln(1+e).
// A strain of 1e-9 formed from F would keep seven digits. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(tiny_strains_keep_their_relative_accuracy,
                     *boost::unit_test::tolerance(1e-14)) {
  const Constitution law = hencky_at(0.3);
  const auto [lambda, mu] = lame_constants(of_poisson_ratio(0.3));
  for (const double e : {1e-15, 1e-12, 1e-9, 1e-6}) {
    const Matrix3 P = stress(law, diagonal(0, 0, e));
    BOOST_TEST(P(2, 2) == (lambda + 2 * mu) * std::log1p(e) / (1 + e));
    BOOST_TEST(P(0, 0) == lambda * std::log1p(e));
    BOOST_TEST(energy(law, diagonal(0, 0, e)) ==
               (lambda + 2 * mu) / 2 * std::pow(std::log1p(e), 2));
  }
}

// U = K/2 (ln J)^2 and its derivatives, dU/dt = K ln J/J.
BOOST_AUTO_TEST_CASE(volumetric_energy_is_quadratic_in_the_logarithm_of_the_volume,
                     *boost::unit_test::tolerance(1e-14)) {
  const Hencky law = hencky_at(0.3);
  const double J = 0.6, K = young / (3 * (1 - 2 * 0.3));
  const VolumetricEnergy U = law.volumetric_energy(J - 1);
  BOOST_TEST(U.value == K / 2 * std::log(J) * std::log(J));
  BOOST_TEST(U.first == K * std::log(J) / J);
}

BOOST_AUTO_TEST_SUITE_END()
