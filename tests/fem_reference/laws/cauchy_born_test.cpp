#include <fmt/format.h>

#include <array>
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "tests/fem_reference/laws.hpp"
#include "tests/referee/figures.hpp"

// The Cauchy-Born continua against the networks they stand for, with spring constants
// written here from the papers' formulas.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(cauchy_born_test)

namespace {

using Eigen::Vector3d;

struct Constants {
  double edge, face_diagonal, inner_diagonal;  // of one cell [N/m]
  double kappa;                                // [Pa]
};

/// Golec 2018, section 5.2, lattice values: k_c = 3 mu h/(3A + 4), k_f = A k_c,
/// k_e = k_f + 8/3 k_c; a cell owns a quarter of an edge and half of a face diagonal.
Constants mss_cf(double mu, double kappa, double A, double h) {
  const double inner = 3 * mu * h / (3 * A + 4), face = A * inner,
               edge = face + 8. / 3 * inner;
  return {.edge = edge / 4,
          .face_diagonal = face / 2,
          .inner_diagonal = inner,
          .kappa = kappa};
}

/// Per cell, as mss-baudet has them.
Constants mss_baudet(double nu, double h) {
  return {.edge = young * h * (4 * nu + 1) / (8 * (1 + nu)),
          .face_diagonal = 0,
          .inner_diagonal = 3 * young * h / (8 * (1 + nu)),
          .kappa = 0};
}

/// Energy per volume of one cubic cell of edge h: springs between all 28 pairs of its
/// corners, and the volume correction.
double cell_energy(const Constants& k, double h, const Matrix3& F) {
  double sum = 0;
  for (int a = 0; a < 8; ++a)
    for (int b = 0; b < a; ++b) {
      const auto corner = [](int n) { return Vector3d(n & 1, n >> 1 & 1, n >> 2); };
      const Vector3d r = h * (corner(b) - corner(a));
      const double steps = r.lpNorm<1>() / h;
      const double stiffness = steps < 1.5   ? k.edge
                               : steps < 2.5 ? k.face_diagonal
                                             : k.inner_diagonal;
      sum += stiffness / 2 * std::pow((F * r).norm() - r.norm(), 2);
    }
  const double V0 = h * h * h, V = F.determinant() * V0;
  return (sum + k.kappa / 2 * (V - V0) * (V - V0) / V0) / V0;
}

Constitution lattice(Springs springs, double nu, double A = 1,
                     LatticeDirection direction = LatticeDirection::d100,
                     SpringConstants constants = SpringConstants::from_shear_modulus) {
  return constitution(of_poisson_ratio(nu), {.law = Law::cauchy_born,
                                             .element = Element::q1,
                                             .lattice = {.springs = springs,
                                                         .diagonal_ratio = A,
                                                         .constants = constants,
                                                         .direction = direction}});
}

const Matrix3 I = Matrix3::Identity();

/// Deformations: general, a compressed bar's, simple shear, turned.
const std::vector<Matrix3> deformations{
    I + general_gradient(), Matrix3(Vector3d(1.06, 1.08, 0.8).asDiagonal()),
    I + 0.3 * Vector3d::UnitX() * Vector3d::UnitZ().transpose(),
    rotation(1, {1, 0, 2}) * (I - 0.5 * general_gradient())};

/// The bar of stretch `stretch` along z with free sides: P_xx = P_yy = 0 by Newton's
/// method on the two lateral stretches. Returns P_zz [Pa].
double bar_stress(const Constitution& law, double stretch) {
  Eigen::Vector2d lateral = Eigen::Vector2d::Zero();
  Matrix3 P;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const Matrix3 H = diagonal(lateral[0], lateral[1], stretch - 1);
    P = stress(law, H);
    const Matrix9 A = tangent(law, H);
    Eigen::Matrix2d slope;
    slope << A(0, 0), A(0, 4), A(4, 0), A(4, 4);
    lateral -= slope.inverse() * Eigen::Vector2d(P(0, 0), P(1, 1));
  }
  BOOST_TEST(largest(P - diagonal(0, 0, P(2, 2))) < 1e-12 * young);  // nothing else acts
  return P(2, 2);
}

}  // namespace

// Round-off; the cell's edge drops out.
BOOST_AUTO_TEST_CASE(energy_is_that_of_the_springs_of_one_cell,
                     *boost::unit_test::tolerance(1e-12)) {
  for (const double nu : poisson_ratios)
    for (const double h : {0.005, 1.})
      for (const Matrix3& F : deformations) {
        const auto [lambda, mu] = lame_constants(of_poisson_ratio(nu));
        const double kappa = young * (4 * nu - 1) / (2 * (1 + nu) * (1 - 2 * nu));
        const Matrix3 H = F - I;
        for (const double A : {0., 0.1, 1., 10.}) {
          BOOST_TEST(energy(lattice(Springs::cf, nu, A), H) ==
                     cell_energy(mss_cf(mu, kappa, A, h), h, F));
          BOOST_TEST(energy(lattice(Springs::fd, nu, A), H) ==
                     cell_energy(mss_cf(mu, 0, A, h), h, F));
        }
        BOOST_TEST(energy(lattice(Springs::nfd, nu, 7), H) ==
                   cell_energy(mss_cf(mu, kappa, 0, h), h, F));
        if (nu > -0.25)
          BOOST_TEST(energy(lattice(Springs::baudet, nu), H) ==
                     cell_energy(mss_baudet(nu, h), h, F));
      }
}

// psi = 5 mu/4 sum (|F n| - 1)^2 + kappa/2 (det F - 1)^2 over the icosahedron's six axes
// (phi, +-1, 0), cyclic. Round-off.
BOOST_AUTO_TEST_CASE(affine_springs_lie_on_the_axes_of_the_icosahedron,
                     *boost::unit_test::tolerance(1e-12)) {
  constexpr double phi = std::numbers::phi;
  const std::array<Vector3d, 6> axes{
      {{phi, 1, 0}, {phi, -1, 0}, {0, phi, 1}, {0, phi, -1}, {1, 0, phi}, {-1, 0, phi}}};
  for (const double nu : poisson_ratios)
    for (const Matrix3& F : deformations) {
      const auto [lambda, mu] = lame_constants(of_poisson_ratio(nu));
      double psi = (lambda - mu) / 2 * std::pow(F.determinant() - 1, 2);
      for (const Vector3d& axis : axes)
        psi += 5 * mu / 4 * std::pow((F * axis.normalized()).norm() - 1, 2);
      BOOST_TEST(energy(lattice(Springs::affine, nu), F - I) == psi);
    }
}

// A lattice whose direction d lies along the body's z axis answers a motion of the body
// as the straight lattice answers the motion seen in its own frame. Round-off.
BOOST_AUTO_TEST_CASE(turned_lattice_is_the_straight_one_in_its_own_frame,
                     *boost::unit_test::tolerance(1e-12)) {
  struct {
    LatticeDirection direction;
    Vector3d along_x, along_z;
  } const turns[]{{LatticeDirection::d110, {0, 0, 1}, {1, 1, 0}},
                  {LatticeDirection::d111, {1, -1, 0}, {1, 1, 1}}};
  for (const auto& [direction, along_x, along_z] : turns) {
    Matrix3 to_lattice;  // columns: the body's axes in the lattice's frame
    to_lattice.col(0) = along_x.normalized();
    to_lattice.col(2) = along_z.normalized();
    to_lattice.col(1) = to_lattice.col(2).cross(to_lattice.col(0));
    for (const Springs springs : {Springs::cf, Springs::nfd, Springs::affine})
      for (const Matrix3& F : deformations) {
        const Matrix3 seen = to_lattice * F * to_lattice.transpose();
        BOOST_TEST(energy(lattice(springs, 0.4, 1, direction), F - I) ==
                   energy(lattice(springs, 0.4), seen - I));
      }
  }
}

// Golec 2018 prints E-forms of the constants (Eq. 5.12), right at nu = 1/4 only. On paper
// at nu = 0 C = 1.2, .4, .4 E - mu and mu off the diagonal: a bar of 2/3 E and Poisson
// ratio -1/6.
BOOST_AUTO_TEST_CASE(young_modulus_form_is_another_material_at_nu_0,
                     *boost::unit_test::tolerance(1e-12)) {
  const Matrix9 A = tangent(lattice(Springs::cf, 0, 1, LatticeDirection::d100,
                                    SpringConstants::from_young_modulus),
                            Matrix3::Zero());
  const double C11 = A(0, 0), C12 = A(0, 4);
  BOOST_TEST(C12 / (C11 + C12) == -1. / 6);
  BOOST_TEST(C11 - 2 * C12 * C12 / (C11 + C12) == 2. / 3 * young);
}

BOOST_AUTO_TEST_CASE(young_modulus_form_is_the_other_at_a_quarter,
                     *boost::unit_test::tolerance(1e-12)) {
  for (const Springs springs : {Springs::nfd, Springs::fd, Springs::cf, Springs::affine})
    for (const Matrix3& F : deformations)
      BOOST_TEST(energy(lattice(springs, 0.25, 1, LatticeDirection::d100,
                                SpringConstants::from_young_modulus),
                        F - I) == energy(lattice(springs, 0.25), F - I));
}

// Identical on paper.
BOOST_AUTO_TEST_CASE(baudets_lattice_is_the_one_without_face_diagonals_at_a_quarter,
                     *boost::unit_test::tolerance(1e-12)) {
  for (const Matrix3& F : deformations)
    BOOST_TEST(energy(lattice(Springs::baudet, 0.25), F - I) ==
               energy(lattice(Springs::nfd, 0.25), F - I));
}

// Uniaxial stress over E times strain. Newton's method there ends at 1e-12 of the stress.
BOOST_AUTO_TEST_CASE(bar_of_mss_cf_depends_on_its_direction_at_finite_strain) {
  const auto ratio = [](double nu, LatticeDirection direction, double strain) {
    return bar_stress(lattice(Springs::cf, nu, 1, direction), 1 + strain) /
           (young * strain);
  };
  for (const char* nu : {"0.25", "0.499"})
    for (const auto& [line, direction] : {std::pair("100", LatticeDirection::d100),
                                          std::pair("110", LatticeDirection::d110),
                                          std::pair("111", LatticeDirection::d111)})
      for (const char* strain : {"-0.05", "-0.2"})
        BOOST_TEST(
            ratio(std::stod(nu), direction, std::stod(strain)) ==
                referee::figure("bars",
                                fmt::format("mss-cf nu {} along {} {}", nu, line, strain),
                                "stress"),
            boost::test_tools::tolerance(1e-8));

  for (const double nu : {0.25, 0.499}) {  // at -5 % within 1.5 %
    const double along_edges = ratio(nu, LatticeDirection::d100, -0.05);
    for (const LatticeDirection direction :
         {LatticeDirection::d110, LatticeDirection::d111})
      BOOST_TEST(std::abs(ratio(nu, direction, -0.05) / along_edges - 1) < 0.015);
  }
}

namespace {

Constitution in_strain(Springs springs, double nu, SpringStrain strain, int axes = 6,
                       LatticeDirection direction = LatticeDirection::d100) {
  return constitution(
      of_poisson_ratio(nu),
      {.law = Law::cauchy_born,
       .element = Element::q1,
       .lattice = {
           .springs = springs, .direction = direction, .strain = strain, .axes = axes}});
}

constexpr LatticeDirection all_directions[] = {
    LatticeDirection::d100, LatticeDirection::d110, LatticeDirection::d111};

}  // namespace

// Exact on paper: the springs' energy is linear in squared lengths, and those in Green's
// strain. 1e-13 of the largest modulus is round-off.
BOOST_AUTO_TEST_CASE(springs_in_squared_lengths_are_st_venant_kirchhoff) {
  for (const double nu : {0., 0.1, 0.25, 0.4, 0.499}) {
    const Constitution law = constitution(
        of_poisson_ratio(nu), {.law = Law::st_venant_kirchhoff, .element = Element::q1});
    const double scale = stiffness_scale(of_poisson_ratio(nu));
    for (const LatticeDirection direction : all_directions)
      for (const auto& [springs, axes] : {std::pair{Springs::cf, 6},
                                          {Springs::nfd, 6},
                                          {Springs::affine, 6},
                                          {Springs::affine, 16},
                                          {Springs::affine, 25}}) {
        const Constitution own =
            in_strain(springs, nu, SpringStrain::green, axes, direction);
        for (const Matrix3& F : deformations) {
          const Matrix3 H = F - I;
          BOOST_TEST(std::abs(energy(own, H) - energy(law, H)) < 1e-13 * scale);
          BOOST_TEST(largest(stress(own, H) - stress(law, H)) < 1e-13 * scale);
          BOOST_TEST(largest(tangent(own, H) - tangent(law, H)) < 1e-13 * scale);
        }
      }
  }
}

// The parts, which elements integrate by different rules, are the same too.
BOOST_AUTO_TEST_CASE(their_shape_part_is_that_of_the_deviator) {
  const Material material = of_poisson_ratio(0.4);
  const double scale = stiffness_scale(material);
  const CauchyBorn own =
      cauchy_born(material, {.springs = Springs::cf, .strain = SpringStrain::green});
  const StVenantKirchhoff law = st_venant_kirchhoff(lame_constants(material));
  for (const Matrix3& F : deformations) {
    const Matrix3 H = F - I;
    BOOST_TEST(std::abs(own.energy(H) - law.energy(H)) < 1e-13 * scale);
    BOOST_TEST(largest(own.stress(H) - law.stress(H)) < 1e-13 * scale);
    BOOST_TEST(largest(own.tangent(H) - law.tangent(H)) < 1e-13 * scale);
    BOOST_TEST(std::abs(own.volumetric_energy(0.3).value -
                        law.volumetric_energy(0.3).value) < 1e-13 * scale);
  }
}

// Written out from the formula: every spring's ln^2, and ln^2 J. Round-off.
BOOST_AUTO_TEST_CASE(logarithmic_springs_have_the_energy_of_their_logarithms,
                     *boost::unit_test::tolerance(1e-12)) {
  const double nu = 0.4;
  const auto [lambda, mu] = lame_constants(of_poisson_ratio(nu));
  for (const Matrix3& F : deformations) {
    double psi = (lambda - mu) / 2 * std::pow(std::log(F.determinant()), 2);
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {  // each axis twice; A = 1: weights of 11, 6, 9
          const int steps = std::abs(x) + std::abs(y) + std::abs(z);
          const double w = mu / 7 * (steps == 1 ? 11 : steps == 2 ? 6 : 9);
          if (steps > 0)
            psi += w / 4 *
                   std::pow(std::log((F * Vector3d(x, y, z).normalized()).norm()), 2);
        }
    BOOST_TEST(energy(in_strain(Springs::cf, nu, SpringStrain::logarithmic), F - I) ==
               psi);
  }
}

// The largest component's spread of the springs' stress over 300 turns of the body, over
// the largest: the referee has the same turns.
BOOST_AUTO_TEST_CASE(sixteen_axes_hardly_know_a_direction) {
  struct {
    int axes;
    double shear;
  } const rows[]{{6, 0.05}, {6, 0.2}, {16, 0.2}, {16, 0.5}};
  for (const auto& [axes, shear] : rows) {
    const Constitution law =
        in_strain(Springs::affine, 0.25, SpringStrain::engineering, axes);
    const Matrix3 F = I + shear * Vector3d::UnitX() * Vector3d::UnitZ().transpose();
    Matrix3 least = Matrix3::Constant(1e300), most = -least;
    for (int turn = 0; turn < 300; ++turn) {
      const Vector3d axis(std::sin(turn), std::sin(2 * turn + 1), std::cos(3 * turn));
      const Matrix3 Q = rotation(0.7 * turn, axis);
      const Matrix3 P = stress(law, F * Q - I) * Q.transpose();
      least = least.cwiseMin(P);
      most = most.cwiseMax(P);
    }
    const double spread =
        (most - least).maxCoeff() / std::max(largest(most), largest(least));
    BOOST_TEST(spread == referee::figure(
                             "turns", fmt::format("{} axes sheared by {}", axes, shear),
                             "spread"),
               boost::test_tools::tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_SUITE_END()
