#include "tests/fem_reference/laws.hpp"

#include <boost/test/unit_test.hpp>

// What every law owes, whatever its formula: consistent derivatives, indifference to
// rotations, Hooke's tensor at small strain.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(laws_test)

namespace {

const Matrix3 turn = rotation(2.1, {1, -2, 0.5});

/// Displacement gradients at which derivatives are checked: general, strongly sheared
/// and turned, almost at rest, and with two equal stretches (no derivative exists of the
/// single eigenvalues there, but of the law).
const std::vector<Matrix3> gradients{
    general_gradient(), turned(rotation(1.2, {1, 1, -1}), 0.8 * general_gradient()),
    1e-4 * general_gradient(), diagonal(-0.2, 0.15, 0.15), Matrix3::Zero()};

}  // namespace

// Errors of the differences (laws.hpp): 1e-12 of the moduli times the fifth derivatives,
// which grow to some 1e2 where a stretch is .7: 1e-9.
BOOST_AUTO_TEST_CASE(stress_and_tangent_are_derivatives_of_the_energy) {
  for (const auto& [name, material, settings, law] : all_laws())
    for (const Matrix3& H : gradients) BOOST_TEST_CONTEXT(name << ", H\n" << H) {
        const double band = 1e-9 * stiffness_scale(material);
        std::visit(
            [&](const auto& part) {
              const auto energies = [&](const Matrix3& G) {
                return scalar(part.energy(G));
              };
              const auto stresses = [&](const Matrix3& G) -> Eigen::VectorXd {
                return part.stress(G).reshaped();
              };
              BOOST_TEST(largest(gradient(energies, H).transpose() -
                                 part.stress(H).reshaped()) < band);
              BOOST_TEST(largest(gradient(stresses, H) - part.tangent(H)) < band);
              BOOST_TEST(largest(part.tangent(H) - part.tangent(H).transpose()) <
                         1e-14 * stiffness_scale(material));
            },
            law);
        const auto energies = [&](const Matrix3& G) { return scalar(energy(law, G)); };
        BOOST_TEST(largest(gradient(energies, H).transpose() -
                           stress(law, H).reshaped()) < band);
      }
}

// The measures are polynomials of at most third degree, exact but for rounding over d.
BOOST_AUTO_TEST_CASE(dilatations_have_their_derivatives) {
  for (const auto& [name, material, settings, law] : laws_at(0.25))
    for (const Matrix3& H : gradients) BOOST_TEST_CONTEXT(name << ", H\n" << H)
  std::visit(
      [&](const auto& part) {
        const Dilatation t = part.dilatation(H);
        const auto values = [&](const Matrix3& G) {
          return scalar(part.dilatation(G).value);
        };
        const auto firsts = [&](const Matrix3& G) -> Eigen::VectorXd {
          return part.dilatation(G).first.reshaped();
        };
        BOOST_TEST(largest(gradient(values, H).transpose() - t.first.reshaped()) < 1e-11);
        BOOST_TEST(largest(gradient(firsts, H) - t.second) < 1e-11);
      },
      law);
}

BOOST_AUTO_TEST_CASE(dilatations_are_the_traces_and_the_jacobian,
                     *boost::unit_test::tolerance(1e-14)) {
  const Matrix3 H = general_gradient(), F = Matrix3::Identity() + H;
  BOOST_TEST(small_strain_trace(H).value == H.trace());
  BOOST_TEST(green_strain_trace(H).value == ((F.transpose() * F).trace() - 3) / 2);
  BOOST_TEST(volume_change(H).value == F.determinant() - 1);
}

// The errors are as for the stresses; log(1 + t) has derivatives of n!/(1 + t)^n.
BOOST_AUTO_TEST_CASE(volumetric_energies_have_their_derivatives) {
  for (const auto& [name, material, settings, law] : all_laws())
    for (const double t : {-0.3, -1e-3, 0., 0.4}) BOOST_TEST_CONTEXT(name << ", t " << t)
  std::visit(
      [&](const auto& part) {
        const VolumetricEnergy U = part.volumetric_energy(t);
        const Eigen::VectorXd slopes = derivative([&](double d) -> Eigen::VectorXd {
          const VolumetricEnergy near = part.volumetric_energy(t + d);
          return Eigen::Vector2d(near.value, near.first);
        });
        const double band = 1e-9 * stiffness_scale(material);
        BOOST_TEST(std::abs(slopes[0] - U.first) < band);
        BOOST_TEST(std::abs(slopes[1] - U.second) < band);
      },
      law);
}

// The tolerance is round-off, of energies and stresses that are about a tenth of the
// moduli.
BOOST_AUTO_TEST_CASE(energy_ignores_a_rotation_and_stress_turns_along) {
  for (const auto& [name, material, settings, law] : all_laws()) {
    if (settings.law == Law::hooke) continue;
    for (const Matrix3& H : gradients) BOOST_TEST_CONTEXT(name << ", H\n" << H) {
        const double band = 1e-13 * stiffness_scale(material);
        BOOST_TEST(std::abs(energy(law, turned(turn, H)) - energy(law, H)) < band);
        BOOST_TEST(largest(stress(law, turned(turn, H)) - turn * stress(law, H)) < band);
      }
  }
}

BOOST_AUTO_TEST_CASE(rotated_body_carries_no_stress) {
  const Matrix3 H = turned(turn, Matrix3::Zero());
  for (const auto& [name, material, settings, law] : all_laws()) {
    const double mu = lame_constants(material).mu;
    BOOST_TEST_CONTEXT(name) {
      if (settings.law == Law::hooke)
        BOOST_TEST(largest(stress(law, H)) > 0.1 * mu);  // valid at small rotations only
      else
        BOOST_TEST(largest(stress(law, H)) < 1e-10 * mu);
    }
  }
}

// Reflections and rotations of the undeformed isotropic body change nothing.
BOOST_AUTO_TEST_CASE(isotropic_laws_have_no_preferred_direction) {
  const Matrix3 H = general_gradient(), I = Matrix3::Identity();
  for (const double nu : poisson_ratios)
    for (const Law law : {Law::hooke, Law::st_venant_kirchhoff, Law::hencky}) {
      const Constitution psi =
          constitution(of_poisson_ratio(nu), {.law = law, .element = Element::q1});
      const double band = 1e-13 * stiffness_scale(of_poisson_ratio(nu));
      for (const Matrix3& Q : {turn, Matrix3(-turn)}) {
        const Matrix3 seen = Q * (I + H) * Q.transpose() - I;
        BOOST_TEST(std::abs(energy(psi, seen) - energy(psi, H)) < band);
        BOOST_TEST(largest(stress(psi, seen) - Q * stress(psi, H) * Q.transpose()) <
                   band);
      }
    }
}

// lambda delta delta + mu (delta delta + delta delta), to round-off. A lattice without
// volume correction has one modulus only and is Hooke's body at nu = 1/4.
BOOST_AUTO_TEST_CASE(tangent_at_rest_is_hookes_tensor) {
  const auto d = [](int a, int b) { return a == b ? 1. : 0.; };
  for (const auto& [name, material, settings, law] : all_laws()) {
    const Springs springs = settings.lattice.springs;
    if (settings.law == Law::cauchy_born && material.poisson_ratio != 0.25 &&
        (springs == Springs::baudet || springs == Springs::fd))
      continue;
    const auto [lambda, mu] = lame_constants(material);
    Matrix9 hookes;
    for (int i = 0; i < 3; ++i)
      for (int J = 0; J < 3; ++J)
        for (int k = 0; k < 3; ++k)
          for (int L = 0; L < 3; ++L)
            hookes(i + 3 * J, k + 3 * L) =
                lambda * d(i, J) * d(k, L) + mu * (d(i, k) * d(J, L) + d(i, L) * d(J, k));
    BOOST_TEST_CONTEXT(name)
    BOOST_TEST(largest(tangent(law, Matrix3::Zero()) - hookes) <
               1e-14 * stiffness_scale(material));
  }
}

// F = I + H would keep six digits of it. What the laws differ by is of the relative size
// of the strain, 1e-10; a lattice's rotation-free part is second order likewise.
BOOST_AUTO_TEST_CASE(stress_of_a_tiny_strain_keeps_its_digits) {
  const Matrix3 H = 1e-10 * general_gradient();
  for (const auto& [name, material, settings, law] : all_laws()) {
    const Matrix3 linear = (tangent(law, Matrix3::Zero()) * H.reshaped()).reshaped(3, 3);
    BOOST_TEST_CONTEXT(name) {
      BOOST_TEST(largest(stress(law, H) - linear) < 2e-9 * largest(linear));
      BOOST_TEST(energy(law, H) == linear.cwiseProduct(H).sum() / 2,
                 boost::test_tools::tolerance(2e-9));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
