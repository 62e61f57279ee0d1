#include "mss/stability/infinite_lattice.hpp"

#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>
#include <numbers>
#include <numeric>

#include "mss/forces/tangent.hpp"
#include "tests/mss/blocks.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(infinite_lattice_test)

namespace {

using std::numbers::pi;

constexpr double h = 0.5;  // [m], so that no volume and no cell edge is 1

Material soft(double nu) {
  return {.young_modulus = 1, .poisson_ratio = nu, .density = 1};
}

Network cell_of(const NetworkSettings& settings, double nu) {
  return build_network(cube(1, h), soft(nu), settings);
}

Matrix3 some_gradient(unsigned seed) {
  const auto columns = random_field(3, 0.2, seed);
  Matrix3 F = Matrix3::Identity();
  for (int i = 0; i < 3; ++i) F.col(i) += columns[static_cast<std::size_t>(i)];
  return F;
}

Vector3 some_phases(unsigned seed) {
  return random_field(1, pi, seed).front();
}

}  // namespace

// With edges alone each node hangs on three chains of springs k. Along one, 4 k
// sin^2(t/2) is the dispersion relation of the chain; across, its tension k (l - 1)/l
// takes the place of k. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(edges_alone_have_the_dispersion_relation_of_a_chain) {
  constexpr double k = 3;
  const Network cell = cell_of(custom({k, 0, 0}, 0), 0.25);
  const Vector3 stretch(1, 0.8, 1.25);
  const Couplings lattice = couplings(cell, stretch.asDiagonal());
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Vector3 t = some_phases(seed);
    const Vector3 swing = 4 * k * (t / 2).array().sin().square();
    const Vector3 across = swing.cwiseProduct(Vector3(0, 1 - 1 / 0.8, 1 - 1 / 1.25));
    const Vector3 expected = swing + Vector3::Constant(across.sum()) - across;
    BOOST_TEST((dynamical_matrix(lattice, t) - Matrix3c(expected.asDiagonal())).norm() <
               1e-13 * k);
  }
}

// sum over a lattice's springs of 2 (1 - cos t.n) k [(1 - L/|d|)(I - e e^T) + e e^T],
// each once: whole constants, no cell. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(springs_add_up_one_by_one) {
  const LatticeStiffness k{.edge = 5, .face_diagonal = 2, .inner_diagonal = 1};
  const Network cell = cell_of(custom(k, 0), 0.25);
  const Matrix3 F = some_gradient(4);
  const Couplings lattice = couplings(cell, F);
  for (const unsigned seed : {5U, 6U}) {
    const Vector3 t = some_phases(seed);
    Matrix3 expected = Matrix3::Zero();
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          const Vector3 n(x, y, z), d = F * n;
          if (n.isZero()) continue;
          const double stiffness =
              std::array{k.edge, k.face_diagonal,
                         k.inner_diagonal}[static_cast<std::size_t>(n.squaredNorm()) - 1];
          const Matrix3 along = d.normalized() * d.normalized().transpose();
          // Each spring is met once for n and once for -n: half of 2 (1 - cos t.n) is
          // added.
          expected += (1 - std::cos(t.dot(n))) * stiffness *
                      ((1 - n.norm() / d.norm()) * (Matrix3::Identity() - along) + along);
        }
    BOOST_TEST(
        (dynamical_matrix(lattice, t) - expected.cast<std::complex<double>>()).norm() <
        1e-13 * expected.norm());
  }
}

// The network of a block, whose springs and cells are assembled for themselves, answers a
// plane wave at its middle node as the infinite lattice does. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(a_block_s_middle_node_feels_the_infinite_lattice) {
  const Mesh mesh = cube(4, h);
  const std::size_t middle = 62;
  BOOST_TEST_REQUIRE((mesh.nodes()[middle] - Vector3(2 * h, 2 * h, 2 * h)).norm() == 0);
  const Matrix3 F = some_gradient(7);
  const Vector3 t = some_phases(8), p(0.3, -1, 0.7);
  for (const auto& [name, model] : models)
    for (const double nu : {0., 0.25, 0.45}) {
      const Network block = build_network(mesh, soft(nu), in_shear_modulus_form(model));
      std::vector<Vector3> positions, wave;
      for (const Vector3& X : mesh.nodes()) {
        positions.push_back(F * X);
        wave.push_back(std::cos(t.dot(X - mesh.nodes()[middle]) / h) * p);
      }
      const Vector3 found = product(tangent_at(block, positions), wave)[middle];
      const Couplings lattice = couplings(cell_of(in_shear_modulus_form(model), nu), F);
      const Vector3 expected = dynamical_matrix(lattice, t).real() * p;
      BOOST_TEST((found - expected).norm() < 1e-12 * largest_modulus(lattice) * h,
                 name << ", nu = " << nu);
    }
}

BOOST_AUTO_TEST_CASE(waves_and_their_mirror_images_are_conjugate_and_periodic) {
  for (const auto& [name, model] : models) {
    const Couplings lattice =
        couplings(cell_of(in_shear_modulus_form(model), 0.4), some_gradient(9));
    const double tiny = 1e-13 * largest_modulus(lattice) * h;
    const Vector3 t = some_phases(10);
    const Matrix3c D = dynamical_matrix(lattice, t);
    BOOST_TEST((D - D.adjoint()).norm() < tiny, name);
    BOOST_TEST((dynamical_matrix(lattice, -t) - D.conjugate()).norm() < tiny, name);
    const Vector3 same = t + 2 * pi * Vector3(1, -1, 2);
    BOOST_TEST((dynamical_matrix(lattice, same) - D).norm() < 10 * tiny, name);
    BOOST_TEST(dynamical_matrix(lattice, Vector3::Zero()).norm() < tiny, name);
  }
}

// Springs in squared lengths are St-Venant and Kirchhoff's law whatever their ratio A: of
// its second derivatives,
//     Q = (m . S m) I + mu F F^T + (lambda + mu) F m (x) F m,  S the stress to E,
// and no ratio is left. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(in_squared_lengths_long_waves_are_those_of_st_venant_and_kirchhoff) {
  const Matrix3 F = some_gradient(13), I = Matrix3::Identity();
  const Matrix3 strain = (F.transpose() * F - I) / 2;
  for (const double A : {0., 1., 10.})
    for (const double nu : {0., 0.25, 0.45}) {
      NetworkSettings settings =
          in_shear_modulus_form(A == 0 ? SpringModel::nfd : SpringModel::cf);
      settings.diagonal_ratio = A;
      settings.strain_measure = StrainMeasure::green;
      const Couplings lattice = couplings(cell_of(settings, nu), F);
      const auto [lambda, mu] = lame_constants(soft(nu));
      const Matrix3 stress = lambda * strain.trace() * I + 2 * mu * strain;
      for (const unsigned seed : {14U, 15U}) {
        const Vector3 m = some_phases(seed).normalized(), along = F * m;
        const Matrix3 Q = m.dot(stress * m) * I + mu * F * F.transpose() +
                          (lambda + mu) * along * along.transpose();
        BOOST_TEST(
            (acoustic_tensor(lattice, m) - Q).norm() < 1e-13 * largest_modulus(lattice),
            "A " << A << ", nu " << nu);
      }
    }
}

// D(R F) = R D(F) R^T: springs and volumes know nothing of a rotation. The tolerance is
// round-off.
BOOST_AUTO_TEST_CASE(a_rotation_of_the_body_turns_polarisations_alone) {
  const Network cell = cell_of(in_shear_modulus_form(SpringModel::cf), 0.45);
  const Matrix3 F = some_gradient(11),
                R = Eigen::AngleAxisd(1.1, Vector3(1, 2, -1).normalized())
                        .toRotationMatrix();
  const Couplings before = couplings(cell, F), after = couplings(cell, R * F);
  const Vector3 t = some_phases(12);
  const Matrix3c turned = R * dynamical_matrix(before, t) * R.transpose();
  BOOST_TEST((dynamical_matrix(after, t) - turned).norm() <
             1e-13 * largest_modulus(before) * h);
  BOOST_TEST(wave_modulus(after, t) == wave_modulus(before, t),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(softest_wave(after).modulus == softest_wave(before).modulus,
             boost::test_tools::tolerance(1e-8));
}

// At rest the lattice with its correction is Hooke's solid: Q = mu I + (lambda + mu) m
// m^T, and the slowest wave is transverse. The tolerance is round-off of kappa, 30 mu.
BOOST_AUTO_TEST_CASE(long_waves_at_rest_are_those_of_hooke_s_law) {
  for (const double nu : {0., 0.25, 0.4, 0.49})
    for (const auto model : {SpringModel::nfd, SpringModel::cf}) {
      const Couplings lattice =
          couplings(cell_of(in_shear_modulus_form(model), nu), Matrix3::Identity());
      const auto [lambda, mu] = lame_constants(soft(nu));
      const Vector3 m = Vector3(1, -2, 0.5).normalized();
      const Matrix3 hooke = mu * Matrix3::Identity() + (lambda + mu) * m * m.transpose();
      BOOST_TEST((acoustic_tensor(lattice, m) - hooke).norm() < 1e-12 * (lambda + mu));
      BOOST_TEST(wave_modulus(lattice, long_wave / 3 * m) == mu,
                 boost::test_tools::tolerance(1e-11));
    }
}

// D(t)/(h t^2) and Q differ by what t^2 adds, 1e-6 here; D has 1e-10 of round-off.
BOOST_AUTO_TEST_CASE(the_modulus_goes_over_into_that_of_long_waves) {
  const Couplings lattice =
      couplings(cell_of(in_shear_modulus_form(SpringModel::cf), 0.4), some_gradient(13));
  for (const unsigned seed : {14U, 15U, 16U}) {
    const Vector3 m = some_phases(seed).normalized();
    BOOST_TEST(wave_modulus(lattice, 1.001 * long_wave * m) ==
                   wave_modulus(lattice, 0.999 * long_wave * m),
               boost::test_tools::tolerance(1e-5));
  }
}

// A grid six times as fine, which holds the coarser, finds nothing lower, and nothing
// much higher: near a minimum the modulus grows with the square of the distance, of pi/72
// at most. At z = .5 the softest wave, (.22, .22, 1) pi, is between the coarser's points.
BOOST_AUTO_TEST_CASE(the_softest_wave_is_that_of_a_fine_grid) {
  for (const double z : {0.5, 0.8, 1.2}) {
    const Couplings lattice =
        couplings(cell_of(in_shear_modulus_form(SpringModel::cf), 0.4),
                  Vector3(1.3, 1.3, z).asDiagonal());
    constexpr int n = 36;  // its mirror planes make an eighth of the zone enough
    double lowest = largest_modulus(lattice);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        for (int l = 0; l <= n; ++l)
          if (i + j + l > 0)
            lowest = std::min(lowest, wave_modulus(lattice, pi / n * Vector3(i, j, l)));
    const double found = softest_wave(lattice).modulus;
    BOOST_TEST(found < lowest + 1e-9 * largest_modulus(lattice), "z = " << z);
    BOOST_TEST(found > lowest - 2e-3 * largest_modulus(lattice), "z = " << z);
  }
}

// Springs without face diagonals let cells fold: their hourglasses have no energy at
// rest, and face diagonals give them some.
BOOST_AUTO_TEST_CASE(only_face_diagonals_hold_hourglasses_at_rest) {
  const auto softest = [](SpringModel model) {
    const Couplings lattice =
        couplings(cell_of(in_shear_modulus_form(model), 0.25), Matrix3::Identity());
    return softest_wave(lattice).modulus / largest_modulus(lattice);
  };
  BOOST_TEST(std::abs(softest(SpringModel::nfd)) < 1e-12);
  BOOST_TEST(std::abs(softest(SpringModel::baudet)) < 1e-12);
  BOOST_TEST(softest(SpringModel::cf) > 0.01);
}

// Softest at rest is the zigzag (pi, 0, pi) along y, held by four face diagonals a cell
// alone: D_yy = 8 k_f, over 8 h, is 3 mu/7 at A = 1, for every nu. q = 0, where D
// vanishes, is no wave. The descent ends within 1e-5 of the minimum, 1e-10 above it.
BOOST_AUTO_TEST_CASE(at_rest_every_wave_meets_a_modulus) {
  for (const double nu : {-0.4, 0., 0.25, 0.45, 0.499}) {
    const Couplings lattice = couplings(
        cell_of(in_shear_modulus_form(SpringModel::cf), nu), Matrix3::Identity());
    BOOST_TEST(softest_wave(lattice).modulus == 3. / 7 * lame_constants(soft(nu)).mu,
               boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(wavelengths_count_cells) {
  BOOST_TEST(wavelength({.phases = {pi, 0, 0}, .modulus = 1}) == 2);
  BOOST_TEST(wavelength({.phases = {0, pi / 8, 0}, .modulus = 1}) == 16);
  BOOST_TEST(std::isinf(wavelength({.phases = {0, 1e-4, 0}, .modulus = 1})));
}

BOOST_AUTO_TEST_SUITE_END()
