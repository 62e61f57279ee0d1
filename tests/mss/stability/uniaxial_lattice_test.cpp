#include "mss/stability/uniaxial_lattice.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "tests/mss/blocks.hpp"
#include "tests/referee/figures.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(uniaxial_lattice_test)

namespace {

using std::numbers::pi;

constexpr double h = 0.005;  // [m]
constexpr double E = 1e4;    // [Pa]

NetworkSettings ratio(double A) {
  NetworkSettings settings =
      in_shear_modulus_form(A == 0 ? SpringModel::nfd : SpringModel::cf);
  settings.diagonal_ratio = A;
  return settings;
}

Network cell_of(double A, double nu, StrainMeasure measure = StrainMeasure::engineering) {
  NetworkSettings settings = ratio(A);
  settings.strain_measure = measure;
  return build_network(
      cube(1, h), {.young_modulus = E, .poisson_ratio = nu, .density = 1000}, settings);
}

/// The lattice stretched by l, l, z on paper, whole springs; forces over k_c h.
struct Paper {
  double A, nu;

  [[nodiscard]] double edge() const { return A + 8. / 3; }
  [[nodiscard]] double kappa() const {  // over k_c/h = 3 mu/(3 A + 4)
    return (4 * nu - 1) / (1 - 2 * nu) * (3 * A + 4) / 3;
  }

  /// dpsi/dl, see homogeneous_test: edges, face diagonals, inner diagonals, volume.
  [[nodiscard]] double lateral(double l, double z) const {
    const double d = std::sqrt(l * l + z * z), c = std::sqrt(2 * l * l + z * z);
    return edge() * 2 * (l - 1) + A * (4 * (l - 1) + 4 * (1 - std::sqrt(2.) / d) * l) +
           8 * (1 - std::sqrt(3.) / c) * l + kappa() * (l * l * z - 1) * 2 * l * z;
  }

  /// The lateral stretch, by bisection between two that hold it.
  [[nodiscard]] double free_sides(double z) const {
    double narrow = 0.9, wide = 1.5;
    for (int i = 0; i < 100; ++i) {
      const double middle = (narrow + wide) / 2;
      (lateral(middle, z) < 0 ? narrow : wide) = middle;
    }
    return narrow;
  }

  /// D_yy/4 of the wave t = (pi, 0, pi): edges along x and z, and the diagonals of faces
  /// across z and x, have ends in opposite phase, all else moves along; the mean of a
  /// cell's edges does not change, so the correction is not felt.
  [[nodiscard]] double zigzag(double z) const {
    const double l = free_sides(z), d = std::sqrt(l * l + z * z), y = l / d;
    return edge() * (2 - 1 / l - 1 / z) + 2 * A * (1 - 1 / (2 * l)) +
           2 * A * ((1 - std::sqrt(2.) / d) * (1 - y * y) + y * y);
  }
};

}  // namespace

// Newton's method ends at a step of 1e-10.
BOOST_AUTO_TEST_CASE(free_sides_are_those_computed_on_paper,
                     *boost::unit_test::tolerance(1e-10)) {
  for (const double A : {0.1, 1., 10.})
    for (const double nu : {0., 0.25, 0.4, 0.499})
      for (const double z : {0.7, 0.95, 1.1}) {
        const double paper = Paper(A, nu).free_sides(z);
        const auto l = free_lateral_stretch(cell_of(A, nu), z, paper + 0.02);
        BOOST_TEST_REQUIRE(l.has_value());
        BOOST_TEST(*l == paper, "A " << A << ", nu " << nu);
      }
}

// On paper the zigzag's energy goes through zero where the lattice is said to lose it:
// strains agree to the bisection's 1e-7 and the 1e-10 below which a modulus counts as
// lost, 1e-6 together.
BOOST_AUTO_TEST_CASE(few_face_diagonals_fold_into_the_zigzag_at_the_strain_on_paper) {
  for (const double A : {0.01, 0.1})
    for (const double nu : {0., 0.25, 0.4, 0.499}) {
      const LatticeLimit limit =
          uniaxial_limit(cell_of(A, nu), UniaxialLoad::compression, 0.5);
      BOOST_TEST_CONTEXT("A " << A << ", nu " << nu << ", strain " << limit.strain) {
        BOOST_TEST((limit.loss == LatticeLoss::wave));
        BOOST_TEST((limit.wave.value().phases - Vector3(pi, 0, pi)).norm() < 1e-3);
        BOOST_TEST(wavelength(*limit.wave) == std::sqrt(2.),
                   boost::test_tools::tolerance(1e-3));
        BOOST_TEST(Paper(A, nu).zigzag(1 - limit.strain + 1e-6) > 0);
        BOOST_TEST(Paper(A, nu).zigzag(1 - limit.strain - 1e-6) < 0);
      }
    }
}

// The referee looks for the least modulus on a grid of the zone and from there, and for
// the strain by bisection to 1e-6.
BOOST_AUTO_TEST_CASE(the_first_wave_in_compression_is_lost_where_the_referee_s_is) {
  for (const double A : {0.01, 0.1, 1., 10.})
    for (const double nu : {0., 0.25, 0.499})
      BOOST_TEST(
          std::abs(uniaxial_limit(cell_of(A, nu), UniaxialLoad::compression, 0.9).strain -
                   referee::figure("waves", fmt::format("A {} nu {}", A, nu), "strain")) <
              5e-6,
          "A " << A << ", nu " << nu);
}

// At A = 10 and nu = 0 the first to go is a long wave, at 40.7 %. A grid of the zone sees
// none of the long waves: on one of 16 points along each axis the first loss is between
// 42 and 43 %.
BOOST_AUTO_TEST_CASE(many_face_diagonals_lose_long_waves_first) {
  const Network cell = cell_of(10, 0);
  const LatticeLimit limit = uniaxial_limit(cell, UniaxialLoad::compression, 0.9);
  BOOST_TEST((limit.loss == LatticeLoss::wave));
  BOOST_TEST(std::isinf(wavelength(limit.wave.value())));
  const auto lowest_on_grid = [&](double strain) {
    const double z = 1 - strain, l = Paper(10, 0).free_sides(z);
    const Couplings lattice = couplings(cell, Vector3(l, l, z).asDiagonal());
    double lowest = largest_modulus(lattice);
    for (int x = 0; x <= 8; ++x)
      for (int y = 0; y <= 8; ++y)
        for (int k = 0; k <= 8; ++k)
          if (x + y + k > 0)
            lowest = std::min(lowest, wave_modulus(lattice, pi / 8 * Vector3(x, y, k)));
    return lowest;
  };
  BOOST_TEST(lowest_on_grid(0.42) > 0);
  BOOST_TEST(lowest_on_grid(0.43) < 0);
}

// At nu = 0 St-Venant and Kirchhoff's law loses its first long wave at a stretch of 2 -
// sqrt(2), and none in tension up to 100 %. So does the lattice in squared lengths, for A
// from 1 to 10. The tolerance is twice the bisection's 1e-7.
BOOST_AUTO_TEST_CASE(in_squared_lengths_the_lattice_holds_as_far_as_its_law) {
  for (const double A : {1., 10.}) {
    const Network cell = cell_of(A, 0, StrainMeasure::green);
    const LatticeLimit limit = uniaxial_limit(cell, UniaxialLoad::compression, 0.9);
    BOOST_TEST(std::isinf(wavelength(limit.wave.value())), "A " << A);
    BOOST_TEST(std::abs(limit.strain - (std::numbers::sqrt2 - 1)) < 2e-7, "A " << A);
    BOOST_TEST((uniaxial_limit(cell, UniaxialLoad::tension, 1).loss == LatticeLoss::none),
               "A " << A);
  }
  // Few diagonals fold first.
  const LatticeLimit folded = uniaxial_limit(cell_of(0.1, 0, StrainMeasure::green),
                                             UniaxialLoad::compression, 0.9);
  BOOST_TEST((folded.wave.value().phases - Vector3(pi, 0, pi)).norm() < 1e-3);
  BOOST_TEST(folded.strain < 0.08);
}

// Waves of no energy at rest turn negative with the first compression.
BOOST_AUTO_TEST_CASE(without_face_diagonals_nothing_holds_from_the_start) {
  for (const double nu : {0., 0.25, 0.499}) {
    const LatticeLimit limit =
        uniaxial_limit(cell_of(0, nu), UniaxialLoad::compression, 0.5);
    BOOST_TEST((limit.loss == LatticeLoss::wave));
    BOOST_TEST(limit.strain < 1e-6);
  }
}

// kappa < 0 pushes the sides out, springs pull them in; on paper dpsi/dl still rises
// above zero just before the strain that is said to be the last, and no more behind it.
BOOST_AUTO_TEST_CASE(in_tension_a_small_poisson_ratio_loses_the_lateral_minimum) {
  struct Row {
    double nu, strain;
  };
  for (const auto& [nu, strain] : {Row{0, 0.1945}, Row{0.1, 0.3643}}) {
    const LatticeLimit limit = uniaxial_limit(cell_of(1, nu), UniaxialLoad::tension, 1);
    BOOST_TEST((limit.loss == LatticeLoss::lateral_minimum));
    BOOST_TEST(!limit.wave);
    BOOST_TEST(std::abs(limit.strain - strain) < 1e-4);
    const auto springs_hold = [nu = nu](double z) {
      double most = -1;
      for (double l = 1; l < 1.3; l += 1e-4)
        most = std::max(most, Paper(1, nu).lateral(l, z));
      return most > 0;
    };
    BOOST_TEST(springs_hold(1 + limit.strain - 1e-4));
    BOOST_TEST(!springs_hold(1 + limit.strain + 1e-4));
  }
  // Of the two stretches at which the sides are free there, the wider is a maximum.
  const double z = 1.15, rest = Paper(1, 0).free_sides(z);
  double maximum = rest + 0.01;
  while (Paper(1, 0).lateral(maximum, z) > 0) maximum += 1e-4;
  BOOST_TEST(free_lateral_stretch(cell_of(1, 0), z, rest + 0.01).value() == rest,
             boost::test_tools::tolerance(1e-10));
  BOOST_TEST(!free_lateral_stretch(cell_of(1, 0), z, maximum));
  const LatticeLimit none = uniaxial_limit(cell_of(1, 0.25), UniaxialLoad::tension, 1);
  BOOST_TEST((none.loss == LatticeLoss::none));
  BOOST_TEST(none.strain == 1);
}

BOOST_AUTO_TEST_SUITE_END()
