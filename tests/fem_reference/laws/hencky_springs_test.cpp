#include "fem_reference/laws/hencky_springs.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <random>
#include <string>

#include "tests/fem_reference/laws.hpp"
#include "tests/referee/figures.hpp"

// The tests of all laws check that energies, stresses and tangents go together; these
// check how far the springs are from Hencky's law.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(hencky_springs_test)

namespace {

const Matrix3 I = Matrix3::Identity();

Matrix3 random_turn(std::mt19937& random) {
  std::normal_distribution<double> component;
  Eigen::Quaterniond q;
  for (double& value : q.coeffs()) value = component(random);
  return q.normalized().toRotationMatrix();
}

/// Root of the mean square of the stress's difference from Hencky's, over 1000 random
/// states of principal stretches of +-20 %; above nu = .45 the volume is kept to .2 %.
double error(const Lattice& lattice, double nu) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> component(-1, 1);
  const Material material = of_poisson_ratio(nu);
  const auto law = constitution(material, {.law = Law::hencky, .element = Element::q1}),
             own = constitution(
                 material,
                 {.law = Law::cauchy_born, .element = Element::q1, .lattice = lattice});
  double error = 0, size = 0;
  for (int state = 0; state < 1000; ++state) {
    Eigen::Vector3d s;
    for (double& stretch : s) stretch = 1 + 0.2 * component(random);
    if (nu > 0.45) s *= (1 + 0.002 * component(random)) / std::cbrt(s.prod());
    const Matrix3 H = random_turn(random) * s.asDiagonal() * random_turn(random) - I;
    const Matrix3 P = stress(law, H);
    error += (stress(own, H) - P).squaredNorm();
    size += P.squaredNorm();
  }
  return std::sqrt(error / size);
}

}  // namespace

// The referee's are of 20,000 other states: 1,000 may be off by a tenth.
BOOST_AUTO_TEST_CASE(stress_is_as_far_off_henckys_as_the_referee_s) {
  constexpr auto hencky = SpringStrain::hencky;
  const struct {
    const char* name;
    Lattice lattice;
  } rows[]{{"lattice engineering", {.springs = Springs::cf}},
           {"lattice logarithmic",
            {.springs = Springs::cf, .strain = SpringStrain::logarithmic}},
           {"lattice hencky A 1", {.springs = Springs::cf, .strain = hencky}},
           {"lattice hencky A 16/9",
            {.springs = Springs::cf, .diagonal_ratio = 16. / 9, .strain = hencky}},
           {"16 axes", {.springs = Springs::affine, .strain = hencky, .axes = 16}},
           {"25 axes", {.springs = Springs::affine, .strain = hencky, .axes = 25}}};
  for (const auto& [name, lattice] : rows)
    for (const double nu : {0., 0.25, 0.4, 0.499}) {
      const std::string of_case = fmt::format("{} nu {} stretches 0.2", name, nu);
      const double found = error(lattice, nu),
                   figure = referee::figure("off_hencky", of_case, "off");
      BOOST_TEST(std::abs(found / figure - 1) < 0.1,
                 of_case << ": " << found << " for " << figure);
    }
}

// Springs of the thesis's lattice along one edge are compressed to .8; the function's
// value there is computed by hand.
BOOST_AUTO_TEST_CASE(lattice_springs_have_the_fitted_function,
                     *boost::unit_test::tolerance(1e-13)) {
  const std::vector<SpringDirection> springs{{Eigen::Vector3d::UnitZ(), 2}};
  const Matrix3 P =
      HenckySprings{springs, SpringStretch::whole}.stress(diagonal(0, 0, -.2));
  BOOST_TEST(P(2, 2) == 2 * (.64 - 1) / (2 * .64 * (.7 + .3 * .64)) / .8);
}

// mu e:e + lambda/2 (tr e)^2 at strains of 1e-9, of which the cube is 1e-9.
BOOST_AUTO_TEST_CASE(small_energies_keep_their_digits,
                     *boost::unit_test::tolerance(1e-8)) {
  const Matrix3 H = 1e-9 * general_gradient(), e = (H + H.transpose()) / 2;
  const Material material = of_poisson_ratio(0.4);
  const auto [lambda, mu] = lame_constants(material);
  for (const Springs springs : {Springs::cf, Springs::nfd, Springs::affine})
    BOOST_TEST(
        energy(constitution(material, {.law = Law::cauchy_born,
                                       .element = Element::q1,
                                       .lattice = {.springs = springs,
                                                   .strain = SpringStrain::hencky}}),
               H) == mu * e.squaredNorm() + lambda / 2 * e.trace() * e.trace());
}

BOOST_AUTO_TEST_SUITE_END()
