#include "mss/networks/box_lattice.hpp"
#include "meshing/generators/generate_block.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mss/statics/equilibrium.hpp"
#include "tests/mss/any_cells.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(box_lattice_test)

namespace {

constexpr Material quarter{.young_modulus = 1e4, .poisson_ratio = 0.25, .density = 1000};

Mesh box(const Vector3& size, const Matrix3& turn = Matrix3::Identity()) {
  const Mesh mesh = cube(1, 1);
  std::vector<Vector3> nodes = mesh.nodes();
  for (Vector3& x : nodes) x = turn * size.asDiagonal() * x;
  return {"box", nodes, mesh.cells(), {}};
}

/// C = (1/V) sum k/l^2 r r r r over the springs of the only cell, on gradients stacked
/// column by column.
Matrix9 homogenised_tensor(const Mesh& mesh, const Network& network) {
  Matrix9 C = Matrix9::Zero();
  for (const CellSpring& spring : network.cells.springs(0)) {
    const Matrix3 rr = spring.rest * spring.rest.transpose();
    C += spring.stiffness / (mesh.volume() * spring.rest.squaredNorm()) * rr.reshaped() *
         rr.reshaped().transpose();
  }
  return C;
}

/// lambda delta_ij delta_kl + mu (delta_ik delta_jl + delta_il delta_jk), lambda = mu.
Matrix9 isotropic_tensor(double mu) {
  Matrix9 C = Matrix9::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      C(3 * i + i, 3 * j + j) += mu;
      C(3 * j + i, 3 * j + i) += mu;
      C(3 * j + i, 3 * i + j) += mu;
    }
  return C;
}

double smallest(const BoxLattice& q) {
  return std::min({q.inner_diagonal, *std::ranges::min_element(q.edge),
                   *std::ranges::min_element(q.face_diagonal)});
}

/// k_f/k_c of the three faces.
std::array<double, 3> diagonal_ratios(const BoxLattice& q,
                                      const std::array<double, 3>& edges) {
  std::array<double, 3> ratios{};
  const double diagonal = std::hypot(edges[0], edges[1], edges[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const double across = std::hypot(edges[(i + 1) % 3], edges[(i + 2) % 3]);
    ratios[i] = 2 * q.face_diagonal[i] * across * across /
                (q.inner_diagonal * diagonal * diagonal);
  }
  return ratios;
}

}  // namespace

// Exact on paper for every box in every orientation: round-off of 28 springs, whose edges
// cancel diagonals by up to a factor of 10.
BOOST_AUTO_TEST_CASE(random_boxes_are_isotropic_with_lambda_equal_to_mu) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> edge(0.8, 1.3), angle(0, 3);
  int boxes = 0;
  while (boxes < 50) {
    const Vector3 size(edge(random), edge(random), edge(random));
    const Matrix3 turn =
        Eigen::AngleAxisd(angle(random), Vector3(1, 2, 2) / 3).toRotationMatrix();
    const Mesh mesh = box(size, turn);
    if (reason_to_refuse(mesh, quarter, SpringModel::cf)) continue;
    ++boxes;
    for (const auto& [form, mu] : {std::pair(StiffnessForm::shear_modulus, 4e3),
                                   std::pair(StiffnessForm::young_modulus, 0.4 * 1e4)}) {
      NetworkSettings settings = in_shear_modulus_form(SpringModel::cf);
      settings.stiffness_form = form;
      const Network network = build_network(mesh, quarter, settings);
      BOOST_TEST((homogenised_tensor(mesh, network) - isotropic_tensor(mu)).norm() <
                 1e-12 * mu);
      for (const CellSpring& spring : network.cells.springs(0))
        BOOST_TEST(spring.stiffness > 0);
    }
  }
}

// Away from nu = 1/4 the two forms differ: mu is 0.5 E at nu = 0.
BOOST_AUTO_TEST_CASE(young_modulus_form_of_a_box_has_two_fifths_of_e) {
  Material material = quarter;
  material.poisson_ratio = 0;
  const Mesh mesh = box({1, 1.1, 1.2});
  NetworkSettings settings = in_shear_modulus_form(SpringModel::cf);
  for (const double mu : {5e3, 4e3}) {
    const Matrix9 C = homogenised_tensor(mesh, build_network(mesh, material, settings));
    BOOST_TEST((C - isotropic_tensor(mu)).norm() < 1e-12 * mu);
    settings.stiffness_form = StiffnessForm::young_modulus;
  }
}

// By hand, with mu = 8. On a cube q_a = 2 + q_d, q_bc = 2 - q_d, and the smallest of all
// is largest at q_d = 1. On 1 x 1 x sqrt(2) mu V/4 is 2 sqrt(2); the smallest would be
// largest at q_d = 3/4 sqrt(2), but the upright faces keep k_f >= k_c up to 3/5 sqrt(2)
// alone.
BOOST_AUTO_TEST_CASE(box_lattice_has_the_values_computed_by_hand,
                     *boost::unit_test::tolerance(1e-14)) {
  const BoxLattice q = box_lattice(8, {1, 1, 1}).value();
  for (std::size_t i = 0; i < 3; ++i) {
    BOOST_TEST(q.edge[i] == 3);
    BOOST_TEST(q.face_diagonal[i] == 1);
    BOOST_TEST(diagonal_ratios(q, {1, 1, 1})[i] == 4. / 3);
  }
  BOOST_TEST(q.inner_diagonal == 1);
  const double root = std::numbers::sqrt2;
  const BoxLattice r = box_lattice(8, {1, 1, root}).value();
  BOOST_TEST(r.inner_diagonal == 0.6 * root);
  BOOST_TEST(r.edge[0] == 3.6 * root);
  BOOST_TEST(r.edge[2] == 0.1 * root);
  BOOST_TEST(r.face_diagonal[0] == 0.4 * root);
  BOOST_TEST(r.face_diagonal[2] == 1.4 * root);
  BOOST_TEST(diagonal_ratios(r, {1, 1, root})[0] == 1);
}

// The constants are compared with a search through q_d in steps of a thousandth of its
// range. A ratio between 1 and 10 is what keeps a lattice from wrinkling early; the upper
// end is never met.
BOOST_AUTO_TEST_CASE(
    smallest_constant_is_the_largest_there_is_at_a_ratio_of_one_or_more) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> edge(0.7, 1.4);
  int bound = 0;
  for (int i = 0; i < 200; ++i) {
    const std::array<double, 3> edges{edge(random), edge(random), edge(random)};
    const auto chosen = box_lattice(1, edges);
    if (!chosen) continue;
    const auto within = [&](const BoxLattice& q) {
      return std::ranges::all_of(diagonal_ratios(q, edges), [](double ratio) {
        return ratio > 1 - 1e-9 && ratio < 10 + 1e-9;
      });
    };
    const double whole = edges[0] * edges[1] * edges[2];
    double best = -1, best_within = -1;
    for (int step = 1; step < 1000; ++step) {
      BoxLattice q = *chosen;
      const double more = step * whole / 1000 - q.inner_diagonal;
      q.inner_diagonal += more;
      for (double& e : q.edge) e += more;
      for (double& f : q.face_diagonal) f -= more;
      best = std::max(best, smallest(q));
      if (smallest(q) >= 0 && within(q)) best_within = std::max(best_within, smallest(q));
    }
    if (best_within >= 0) BOOST_TEST(within(*chosen));
    BOOST_TEST(smallest(*chosen) >= (within(*chosen) ? best_within : best) - 1e-3);
    bound += best_within >= 0 && best_within < best - 2e-3 ? 1 : 0;
  }
  BOOST_TEST(bound > 0);  // the ratios do decide some of them
}

// A hair to either side of 1/sqrt(3) and sqrt(3), where an edge's constant vanishes.
BOOST_AUTO_TEST_CASE(square_boxes_are_covered_up_to_the_root_of_three) {
  const double root = std::sqrt(3.);
  for (const double c : {1 / root, root}) {
    const double inside = c > 1 ? c - 1e-4 : c + 1e-4,
                 outside = c > 1 ? c + 1e-4 : c - 1e-4;
    for (const SpringModel model : {SpringModel::cf, SpringModel::fd}) {
      BOOST_TEST(!reason_to_refuse(box({1, 1, inside}), quarter, model));
      BOOST_TEST(reason_to_refuse(box({1, 1, outside}), quarter, model).has_value());
    }
  }
  BOOST_TEST(
      reason_to_refuse(box({2, 2, 4}), quarter, SpringModel::cf).value_or("") ==
      "no springs without a negative stiffness make hexahedron 1, a box of 1 : 1 : "
      "2, isotropic");
}

BOOST_AUTO_TEST_CASE(leaning_box_is_none) {
  Matrix3 leaning = Matrix3::Identity();
  leaning(0, 2) = 1e-3;
  BOOST_TEST(reason_to_refuse(box({1, 1.2, 1.1}, leaning), quarter, SpringModel::cf)
                 .value_or("") ==
             "its springs need box-shaped cells, and hexahedron 1 is none");
}

// What E and nu mean, on 3 x 2 x 2 boxes 1 : 1.2 : .9 between sliding plates. The
// strain's square enters by about 1e-6.
BOOST_AUTO_TEST_CASE(block_of_boxes_in_uniaxial_stress_has_e_and_nu) {
  constexpr double strain = 1e-6, E = 1e4;
  const Vector3 size(0.03, 0.024, 0.018);
  const Mesh mesh =
      generate_block({.size = {size.x(), size.y(), size.z()}, .cells = {3, 2, 2}});
  constexpr Held only_z{false, false, true};
  for (const double nu : {-0.3, 0., 0.25, 0.4, 0.49}) {
    const Scene scene{
        .material = {.young_modulus = E, .poisson_ratio = nu, .density = 1000},
        .plates = {{"bottom", translation({0, 0, 0}), only_z},
                   {"top", translation({0, 0, strain * size.z()}), only_z}},
        .pins = {{.point = {0, 0, 0}, .held = {true, true, false}},
                 {.point = {size.x(), 0, 0}, .held = {false, true, false}}},
        .gravity = Vector3::Zero()};
    const Solution solution = find_equilibrium(
        mesh, scene,
        build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::cf)));
    BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
    double force = 0;
    for (const NodeIndex n : mesh.region("top").nodes) force += solution.reactions[n].z();
    BOOST_TEST(force / (size.x() * size.y() * strain) == E,
               boost::test_tools::tolerance(1e-5));
    const Vector3& u = solution.displacements.back();
    BOOST_TEST(std::abs(-u.x() / (size.x() * strain) - nu) < 1e-5);
    BOOST_TEST(std::abs(-u.y() / (size.y() * strain) - nu) < 1e-5);
  }
}

BOOST_AUTO_TEST_SUITE_END()
