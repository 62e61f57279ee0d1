#include "mss/networks/network.hpp"
#include "meshing/generators/generate_block.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <set>

#include "mss/networks/uniform_stiffness.hpp"
#include "tests/mss/blocks.hpp"
#include "tests/mss/networks/axial_modulus.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(network_test)

namespace {

using Tensor4 = std::array<std::array<std::array<std::array<double, 3>, 3>, 3>, 3>;
constexpr std::array<std::size_t, 3> axes{0, 1, 2};

template <class Visit>
void for_each_entry(const Visit& visit) {
  for (const std::size_t i : axes)
    for (const std::size_t j : axes)
      for (const std::size_t k : axes)
        for (const std::size_t l : axes) visit(i, j, k, l);
}

/// Elasticity tensor of the infinite lattice, C = (1/V) sum k/l^2 r r r r over the
/// springs of one cell, plus the volume correction's kappa I I. There is one interior
/// node per cell, and half of each of its springs is its own: summed at the middle node
/// of 2^3 cells.
Tensor4 homogenised_tensor(const Material& material, const NetworkSettings& settings) {
  constexpr double h = 0.005;
  const Network network = build_network(cube(2, h), material, settings);
  constexpr NodeIndex middle = 13;
  Tensor4 C{};
  for (const Spring& spring : network.springs) {
    if (spring.a != middle && spring.b != middle) continue;
    const Vector3 r = network.rest_positions[spring.b] - network.rest_positions[spring.a];
    const auto component = [&](std::size_t i) { return r[static_cast<Eigen::Index>(i)]; };
    for_each_entry([&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      C[i][j][k][l] += spring.stiffness / (2 * h * h * h * r.squaredNorm()) *
                       component(i) * component(j) * component(k) * component(l);
    });
  }
  for (const std::size_t i : axes)
    for (const std::size_t k : axes) C[i][i][k][k] += network.volume_moduli.kappa;
  return C;
}

/// Four cubes in a row of two by two, less the last: edges of one, two and three cells.
Mesh notched_block(double h) {
  const Mesh whole = generate_block({.size = {2 * h, 2 * h, h}, .cells = {2, 2, 1}});
  std::vector<CellNodes> cells(whole.cells().begin(), whole.cells().end() - 1);
  std::vector<Vector3> nodes = whole.nodes();
  // The last cell's own corner: the last node of either layer of nine.
  nodes.erase(nodes.begin() + 17);
  nodes.erase(nodes.begin() + 8);
  for (CellNodes& cell : cells)
    for (NodeIndex& node : cell)
      if (node > 8) --node;
  return {"notched block", nodes, cells, {}};
}

/// Number of cells with both nodes.
int cells_at(const Network& network, const Spring& spring) {
  int count = 0;
  for (std::size_t c = 0; c < network.cells.size(); ++c) {
    const auto nodes = network.cells.nodes(c);
    if (std::ranges::count(nodes, spring.a) == 1 &&
        std::ranges::count(nodes, spring.b) == 1)
      ++count;
  }
  return count;
}

Mesh deformed_cube(const Eigen::Matrix3d& F) {
  const Mesh mesh = cube(1, 1);
  std::vector<Vector3> nodes = mesh.nodes();
  for (Vector3& x : nodes) x = F * x;
  return {"deformed cube", nodes, mesh.cells(), {}};
}

constexpr Material quarter{.young_modulus = 1e4, .poisson_ratio = 0.25, .density = 1000};

}  // namespace

// The tensor has 1.2, 0.4, 0.4 E: lambda = mu = 0.4 E at nu = 1/4, whatever the ratio of
// the diagonals. It is exact on paper, so that the tolerance is round-off.
BOOST_AUTO_TEST_CASE(lattice_has_the_isotropic_tensor_for_every_diagonal_ratio,
                     *boost::unit_test::tolerance(1e-13)) {
  for (const double A : {0., 0.01, 1., 100.}) {
    NetworkSettings settings = in_shear_modulus_form(SpringModel::fd);
    settings.diagonal_ratio = A;
    const Tensor4 C = homogenised_tensor(quarter, settings);
    BOOST_TEST(C[0][0][0][0] == 1.2 * 1e4);
    BOOST_TEST(C[0][0][1][1] == 0.4 * 1e4);
    BOOST_TEST(C[0][1][0][1] == 0.4 * 1e4);
  }
}

// All 81 entries are compared; the tolerance is round-off relative to lambda + 2 mu.
BOOST_AUTO_TEST_CASE(volume_correction_makes_the_tensor_right_for_every_poisson_ratio) {
  for (const SpringModel model : {SpringModel::nfd, SpringModel::cf})
    for (const double nu : {-0.5, 0., 0.1, 0.25, 0.4, 0.499}) {
      const Material material{.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000};
      const auto [lambda, mu] = lame_constants(material);
      const Tensor4 C = homogenised_tensor(material, in_shear_modulus_form(model));
      double squared_error = 0;
      for_each_entry([&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        const double exact =
            lambda * (i == j && k == l) + mu * ((i == k && j == l) + (i == l && j == k));
        squared_error += std::pow(C[i][j][k][l] - exact, 2);
      });
      BOOST_TEST(std::sqrt(squared_error) < 1e-13 * (lambda + 2 * mu), "nu = " << nu);
    }
}

// The tensor is computed by hand (see uniform_stiffness), for every Poisson ratio that is
// asked for. All 81 entries are compared; the tolerance is round-off.
BOOST_AUTO_TEST_CASE(one_stiffness_makes_a_cubic_tensor) {
  for (const double nu : {0., 0.25, 0.499}) {
    const Material material{.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000};
    const Tensor4 C = homogenised_tensor(material, {.model = SpringModel::uniform});
    const double k_over_h = 19e4 / 144;
    const double c11 = 28 * k_over_h / 3, c12 = 10 * k_over_h / 3;
    double largest_error = 0;
    for_each_entry([&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      const bool all_equal = i == j && j == k && k == l;
      const bool in_pairs =
          (i == j && k == l) || (i == k && j == l) || (i == l && j == k);
      const double exact = all_equal ? c11 : in_pairs ? c12 : 0;
      largest_error = std::max(largest_error, std::abs(C[i][j][k][l] - exact));
    });
    BOOST_TEST(largest_error < 1e-12 * c11, "nu = " << nu);
    BOOST_TEST(c11 - 2 * c12 * c12 / (c11 + c12) == 1e4,
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(axial_modulus({uniform_stiffness(1e4, 0.005), 0}, 0.005) == 1e4,
               boost::test_tools::tolerance(1e-12));
  }
}

// With kappa of nu = 0 but the stiffness of nu = 1/4 the material has E_eff = 2E/3 and
// nu_eff = -1/6: lambda = -0.1 E, mu = 0.4 E.
BOOST_AUTO_TEST_CASE(young_modulus_form_is_another_material_at_nu_0,
                     *boost::unit_test::tolerance(1e-13)) {
  const Material material{.young_modulus = 1e4, .poisson_ratio = 0, .density = 1000};
  NetworkSettings settings = in_shear_modulus_form(SpringModel::cf);
  settings.stiffness_form = StiffnessForm::young_modulus;
  const Tensor4 C = homogenised_tensor(material, settings);
  const auto [lambda, mu] = lame_constants(
      {.young_modulus = 2e4 / 3, .poisson_ratio = -1. / 6, .density = 1000});
  BOOST_TEST(C[0][0][1][1] == lambda);
  BOOST_TEST(C[0][1][0][1] == mu);
}

// By hand: C_1111 = (k_e + 2 k_f + 4/3 k_c)/h + kappa, C_1122 = (k_f + 4/3 k_c)/h +
// kappa, C_1212 = (k_f + 4/3 k_c)/h with h = 5 mm, whatever the material. The tolerance
// is round-off.
BOOST_AUTO_TEST_CASE(custom_lattice_has_the_tensor_of_its_own_constants,
                     *boost::unit_test::tolerance(1e-13)) {
  const Tensor4 C = homogenised_tensor(
      quarter, custom({.edge = 5, .face_diagonal = 2, .inner_diagonal = 3}, -300));
  BOOST_TEST(C[0][0][0][0] == 13 / 0.005 - 300);
  BOOST_TEST(C[0][0][1][1] == 6 / 0.005 - 300);
  BOOST_TEST(C[0][1][0][1] == 6 / 0.005);
}

BOOST_AUTO_TEST_CASE(custom_without_constants_is_named) {
  BOOST_CHECK_EXCEPTION(
      build_network(cube(1, 0.005), quarter, {.model = SpringModel::custom}),
      std::invalid_argument, [](const std::invalid_argument& error) {
        return std::string(error.what()).find("constants") != std::string::npos;
      });
}

// The ratio is that of the command line.
BOOST_AUTO_TEST_CASE(a_method_alone_has_a_diagonal_ratio_of_1) {
  BOOST_TEST(NetworkSettings{.model = SpringModel::cf}.diagonal_ratio == 1);
}

// Whatever material stands beside. Cells' volumes, hence mss-cf's h, differ by round-off.
BOOST_AUTO_TEST_CASE(custom_with_the_constants_of_cf_is_cf) {
  const Mesh mesh = notched_block(0.005);
  for (const double nu : {0., 0.25, 0.4}) {
    const Material material{.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000};
    const Network cf =
        build_network(mesh, material, in_shear_modulus_form(SpringModel::cf));
    const Network own =
        build_network(mesh, {.young_modulus = 7, .poisson_ratio = -0.9, .density = 1000},
                      custom(shear_modulus_form(lame_constants(material).mu, 0.005, 1),
                             volume_correction_modulus(material)));
    BOOST_TEST(own.volume_moduli.kappa == cf.volume_moduli.kappa);
    NetworkSettings hencky = in_shear_modulus_form(SpringModel::cf);
    NetworkSettings own_hencky =
        custom(shear_modulus_form(lame_constants(material).mu, 0.005, 1),
               volume_correction_modulus(material));
    hencky.strain_measure = own_hencky.strain_measure = StrainMeasure::hencky;
    BOOST_TEST(build_network(mesh, material, own_hencky).volume_moduli.cubic ==
                   build_network(mesh, material, hencky).volume_moduli.cubic,
               boost::test_tools::tolerance(1e-14));
    BOOST_TEST(own.masses == cf.masses, boost::test_tools::per_element());
    BOOST_TEST_REQUIRE(own.springs.size() == cf.springs.size());
    for (std::size_t s = 0; s < cf.springs.size(); ++s) {
      BOOST_TEST(own.springs[s].a == cf.springs[s].a);
      BOOST_TEST(own.springs[s].b == cf.springs[s].b);
      BOOST_TEST(own.springs[s].stiffness == cf.springs[s].stiffness,
                 boost::test_tools::tolerance(1e-14));
      BOOST_TEST(own.springs[s].rest_length == cf.springs[s].rest_length);
    }
  }
}

// Golec 2018, section 5.3: k_e n/4 at an edge of n cells, half of k_f on the boundary.
// The merged springs add up to four terms: round-off.
BOOST_AUTO_TEST_CASE(springs_get_the_share_of_the_cells_they_belong_to,
                     *boost::unit_test::tolerance(1e-14)) {
  constexpr double h = 0.005;
  const LatticeStiffness k = shear_modulus_form(lame_constants(quarter).mu, h, 1);
  std::set<int> edge_cells, face_cells;
  for (const Mesh& mesh : {notched_block(h), cube(2, h)}) {
    const Network network =
        build_network(mesh, quarter, in_shear_modulus_form(SpringModel::cf));
    for (const Spring& spring : network.springs) {
      const int n = cells_at(network, spring);
      const double lengths = spring.rest_length / h;
      BOOST_TEST(
          spring.rest_length ==
          (network.rest_positions[spring.b] - network.rest_positions[spring.a]).norm());
      if (lengths < 1.2) {
        BOOST_TEST(spring.stiffness == k.edge * n / 4);
        edge_cells.insert(n);
      } else if (lengths < 1.5) {
        BOOST_TEST(spring.stiffness == k.face_diagonal * n / 2);
        face_cells.insert(n);
      } else {
        BOOST_TEST(spring.stiffness == k.inner_diagonal);
        BOOST_TEST(n == 1);
      }
    }
  }
  BOOST_TEST((edge_cells == std::set<int>{1, 2, 3, 4}));
  BOOST_TEST((face_cells == std::set<int>{1, 2}));
}

// Counted by hand for the three cells: 10 + 10 horizontal and 8 vertical edges, 2 face
// diagonals on each of 16 faces, 4 inner diagonals in each cell.
BOOST_AUTO_TEST_CASE(springs_between_the_same_nodes_are_one) {
  struct Row {
    SpringModel model;
    std::size_t springs;
  };
  for (const Row& row :
       {Row{SpringModel::baudet, 28 + 12}, Row{SpringModel::nfd, 28 + 12},
        Row{SpringModel::fd, 28 + 32 + 12}, Row{SpringModel::cf, 28 + 32 + 12}}) {
    const Network network =
        build_network(notched_block(0.005), quarter, in_shear_modulus_form(row.model));
    BOOST_TEST(network.springs.size() == row.springs);
    std::set<std::pair<NodeIndex, NodeIndex>> pairs;
    for (const Spring& spring : network.springs) {
      BOOST_TEST(spring.a < spring.b);
      pairs.emplace(spring.a, spring.b);
    }
    BOOST_TEST(pairs.size() == row.springs);
  }
}

BOOST_AUTO_TEST_CASE(only_nfd_and_cf_correct_the_volume) {
  const Material material{.young_modulus = 1e4, .poisson_ratio = 0.4, .density = 1000};
  for (const auto& [name, model] : models) {
    const Network network =
        build_network(cube(1, 0.005), material, in_shear_modulus_form(model));
    const bool corrects = model == SpringModel::nfd || model == SpringModel::cf;
    BOOST_TEST(network.volume_moduli.kappa ==
                   (corrects ? volume_correction_modulus(material) : 0),
               name);
  }
}

// The tolerance is round-off of sums of 24 numbers.
BOOST_AUTO_TEST_CASE(masses_add_up_to_the_body_and_a_corner_gets_an_eighth_of_its_cell,
                     *boost::unit_test::tolerance(1e-14)) {
  const Mesh mesh = notched_block(0.005);
  const Network network =
      build_network(mesh, quarter, in_shear_modulus_form(SpringModel::cf));
  const double cell_mass = 1000 * std::pow(0.005, 3);
  BOOST_TEST(std::reduce(network.masses.begin(), network.masses.end()) == 3 * cell_mass);
  BOOST_TEST(network.masses[0] == cell_mass / 8);      // one cell
  BOOST_TEST(network.masses[1] == 2 * cell_mass / 8);  // two
  BOOST_TEST(network.masses[4] == 3 * cell_mass / 8);  // in the notch
}

BOOST_AUTO_TEST_CASE(cells_that_are_no_cubes_are_refused) {
  const Eigen::Matrix3d stretched = Vector3(1, 1, 1.00001).asDiagonal();
  // A rhombohedron leaning by a thousandth: its edges are equal and its volume is lower
  // by half a millionth only; the diagonals give it away.
  const double s = 1e-3;
  const Eigen::Matrix3d leaning =
      (Eigen::Matrix3d() << 1, 0, s, 0, 1, 0, 0, 0, std::sqrt(1 - s * s)).finished();
  const auto reason = [](const Eigen::Matrix3d& F, SpringModel model) {
    return reason_to_refuse(deformed_cube(F), quarter, model).value_or("");
  };
  for (const auto& [name, model] : models) {
    const bool takes_boxes = model == SpringModel::cf || model == SpringModel::fd;
    const std::string no_cube = "its springs need cubic cells, and hexahedron 1 is none",
                      no_box =
                          "its springs need box-shaped cells, and hexahedron 1 is none";
    BOOST_TEST(reason(stretched, model) == (takes_boxes ? "" : no_cube), name);
    BOOST_TEST(reason(leaning, model) == (takes_boxes ? no_box : no_cube), name);
    const Eigen::Matrix3d turned =
        Eigen::AngleAxisd(1, Vector3(1, 2, 2) / 3).toRotationMatrix();
    BOOST_TEST(reason(turned, model) == "", name);
  }
}

BOOST_AUTO_TEST_CASE(custom_covers_any_material_on_cubes_alone) {
  const Material auxetic{.young_modulus = 1e4, .poisson_ratio = -0.9, .density = 1000};
  BOOST_TEST(!reason_to_refuse(cube(1, 0.005), auxetic, SpringModel::custom));
  const Eigen::Matrix3d stretched = Vector3(1, 1, 1.1).asDiagonal();
  BOOST_TEST(reason_to_refuse(deformed_cube(stretched), auxetic, SpringModel::custom)
                 .has_value());
}

BOOST_AUTO_TEST_CASE(baudet_is_refused_where_its_edges_are_not_stiff) {
  const Mesh mesh = cube(1, 0.005);
  const auto reason = [&](SpringModel model, double nu) {
    return reason_to_refuse(
               mesh, {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000}, model)
        .value_or("");
  };
  BOOST_TEST(
      reason(SpringModel::baudet, -0.3) ==
      "mss-baudet covers nu in (-0.25, 0.5): its edge stiffness is not positive at "
      "nu = -0.3");
  BOOST_TEST(reason(SpringModel::baudet, -0.25) != "");
  BOOST_TEST(reason(SpringModel::baudet, -0.24) == "");
  BOOST_TEST(reason(SpringModel::cf, -0.3) == "");
}

BOOST_AUTO_TEST_SUITE_END()
