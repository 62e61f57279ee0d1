#include "mss/networks/virtual_springs.hpp"

#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "tests/mss/blocks.hpp"
#include "tests/referee/figures.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(virtual_springs_test)

namespace {

constexpr VirtualSprings law{.shear_modulus = 0.7, .volume_moduli = {.kappa = 1.3}};

/// The axes of an icosahedron by another way: its vertices at latitude atan(1/2).
double energy_by_hand(const Matrix3& F) {
  double sum = std::pow(F.col(2).norm() - 1, 2);
  for (int i = 0; i < 5; ++i) {
    const double longitude = 2 * std::numbers::pi * i / 5;
    const Vector3 n(2 * std::cos(longitude), 2 * std::sin(longitude), 1);
    sum += std::pow((F * n).norm() / std::sqrt(5.) - 1, 2);
  }
  return 5 * law.shear_modulus / 4 * sum +
         law.volume_moduli.kappa / 2 * std::pow(F.determinant() - 1, 2);
}

/// Visits the laws in all measures, along all axes.
template <class Visit>
void for_each_law(const Visit& visit) {
  for (const StrainMeasure measure : all_measures)
    for (const Axes axes : all_axes)
      BOOST_TEST_CONTEXT("measure " << static_cast<int>(measure) << ", axes "
                                    << static_cast<int>(axes)) {
        VirtualSprings own = law;
        own.measure = measure;
        own.axes = axes;
        visit(own);
      }
}

}  // namespace

// Rotated at random, as its axes need not be ours.
BOOST_AUTO_TEST_CASE(energy_is_that_of_an_icosahedron_s_axes) {
  // Our axes to those of energy_by_hand: one on the pole, and one of its neighbours on
  // the meridian of longitude 0.
  const double phi = std::numbers::phi;
  const Vector3 pole = Vector3(phi, 1, 0).normalized(),
                near = Vector3(phi, -1, 0).normalized();
  Matrix3 frame;
  frame.col(2) = pole;
  frame.col(0) = (near - near.dot(pole) * pole).normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Matrix3 H = random_gradient(seed, 0.5);
    BOOST_TEST(law.energy(H) == energy_by_hand((Matrix3::Identity() + H) * frame),
               boost::test_tools::tolerance(1e-13));
  }
}

// The tangent is exact on paper, so that the tolerance is round-off.
BOOST_AUTO_TEST_CASE(tangent_at_rest_is_that_of_hooke) {
  for_each_law([](const VirtualSprings& own) {
    const Matrix9 A = own.tangent(Matrix3::Zero());
    const double mu = own.shear_modulus, lambda = mu + own.volume_moduli.kappa;
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Matrix3 H = random_gradient(seed, 1), strain = (H + H.transpose()) / 2;
      const Matrix3 hooke =
          lambda * strain.trace() * Matrix3::Identity() + 2 * mu * strain;
      BOOST_TEST((A * H.reshaped() - hooke.reshaped()).norm() < 1e-14);
    }
  });
}

// Central differences with a step of 1e-5: truncation of its square times the third
// derivative, which reaches some hundreds; round-off 1e-16/1e-5.
BOOST_AUTO_TEST_CASE(stress_and_tangent_are_slopes) {
  constexpr double step = 1e-5;
  for_each_law([&](const VirtualSprings& own) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Matrix3 H = random_gradient(seed, 0.3), P = own.stress(H);
      const Matrix9 A = own.tangent(H);
      for (Eigen::Index entry = 0; entry < 9; ++entry) {
        Matrix3 ahead = H, behind = H;
        ahead.reshaped()[entry] += step;
        behind.reshaped()[entry] -= step;
        BOOST_TEST(std::abs(P.reshaped()[entry] -
                            (own.energy(ahead) - own.energy(behind)) / (2 * step)) <
                   1e-8);
        const Matrix3 slope = (own.stress(ahead) - own.stress(behind)) / (2 * step);
        BOOST_TEST((A.col(entry) - slope.reshaped()).norm() < 5e-8);
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(direction_pressed_to_a_point_pulls_nowhere) {
  const Matrix3 H = -Matrix3::Identity();
  for_each_law([&](const VirtualSprings& own) {
    BOOST_TEST(own.stress(H).norm() == 0);
    BOOST_TEST(own.tangent(H).allFinite());
  });
}

// The energy is mu E:E + lambda/2 (tr E)^2 whatever the body's orientation: exact on
// paper, so that the tolerance is round-off alone. Strains reach 60 %.
BOOST_AUTO_TEST_CASE(squared_lengths_are_st_venant_kirchhoff_in_every_direction,
                     *boost::unit_test::tolerance(1e-13)) {
  const Matrix3 F = Matrix3::Identity() + random_gradient(1, 0.5);
  const Matrix3 E = (F.transpose() * F - Matrix3::Identity()) / 2;
  const double mu = law.shear_modulus, lambda = mu + law.volume_moduli.kappa,
               psi = mu * E.squaredNorm() + lambda / 2 * E.trace() * E.trace();
  for (const Axes axes : all_axes)
    for (unsigned seed = 0; seed < 100; ++seed) {
      VirtualSprings own = law;
      own.measure = StrainMeasure::green;
      own.axes = axes;
      BOOST_TEST(own.energy(F * random_turn(seed) - Matrix3::Identity()) == psi);
    }
}

// The mean of (n . a)^(2 p) over directions is 1/(2 p + 1). By degree 10 with twenty-
// five axes, 8 with sixteen, 4 with six; ln^2 of a stretch is none of these. Energies of
// the springs that follow a stretch along a unit vector a, |F n|^2 = 1 + c (n . a)^2, are
// by their series in c means of such powers; the quartic alone is green's: checked with
// the logarithms' terms up to c^4 and c^5.
BOOST_AUTO_TEST_CASE(axes_are_a_mean_over_directions_to_their_degree) {
  constexpr double c = 1e-2;
  // ln^2(1 + x)/4 = x^2/4 - x^3/4 + 11 x^4/48 - ..., x = c (n . a)^2.
  const double mean = c * c / 4 / 5 - c * c * c / 4 / 7 + 11 * c * c * c * c / 48 / 9;
  VirtualSprings own{.shear_modulus = 1,
                     .volume_moduli = {},
                     .measure = StrainMeasure::logarithmic,
                     .axes = Axes::sixteen};
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Vector3 a = random_turn(seed).col(0);
    const Matrix3 H = (std::sqrt(1 + c) - 1) * a * a.transpose();
    // c^5 is of degree 10, and left: its coefficient 5/24, and a mean of about 1/11.
    BOOST_TEST(std::abs(own.energy(H) - 15. / 2 * mean) <
               15. / 2 * c * c * c * c * c / 40);
    own.axes = Axes::six;
    BOOST_TEST(std::abs(own.energy(H) - 15. / 2 * mean) < 15. / 2 * c * c * c);
    own.axes = Axes::twenty_five;
    const double to_fifth = mean - 5. / 24 * c * c * c * c * c / 11;
    BOOST_TEST(std::abs(own.energy(H) - 15. / 2 * to_fifth) <
               15. / 2 * c * c * c * c * c * c / 40);
    own.axes = Axes::sixteen;
  }
}

// Simple shear of 20 % turned: off the unturned stress, turned back. With six axes 13 %
// by a turn of 90 degrees about z; sixteen stay below .2 %.
BOOST_AUTO_TEST_CASE(a_cell_sheared_another_way_has_the_same_stress_along_enough_axes) {
  const Matrix3 H = 0.2 * Vector3::UnitX() * Vector3::UnitZ().transpose();
  const auto off = [&](Axes axes, const Matrix3& turn) {
    VirtualSprings own = law;
    own.measure = StrainMeasure::engineering;
    own.axes = axes;
    const Matrix3 straight = own.stress(H);
    const Matrix3 turned = own.stress(turn * H * turn.transpose());
    return (turn.transpose() * turned * turn - straight).norm() / straight.norm();
  };
  Matrix3 quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  BOOST_TEST(off(Axes::six, quarter) == referee::figure("turns", "6 axes sheared by 0.2",
                                                        "change by a quarter of a turn"),
             boost::test_tools::tolerance(1e-9));
  for (unsigned seed = 0; seed < 100; ++seed) {
    BOOST_TEST(off(Axes::sixteen, random_turn(seed)) < .002);
    BOOST_TEST(off(Axes::twenty_five, random_turn(seed)) < 2e-4);
  }
}

BOOST_AUTO_TEST_SUITE_END()
