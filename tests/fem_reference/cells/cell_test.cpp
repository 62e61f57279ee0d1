#include "fem_reference/cells/cell.hpp"

#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>

#include "meshing/cell_geometry.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/cells/one_cell.hpp"
#include "tests/fem_reference/laws.hpp"

// One cell: its energy's derivatives, and what each place of the dilatation makes of it.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(cell_test)

namespace {

const auto round_off = boost::test_tools::tolerance(1e-12);

/// A distorted cell of each type, and the triquadratic one.
void for_all_cells(const std::function<void(const Mesh&, const OneCell&)>& test) {
  for (const CellType type : all_cell_types) BOOST_TEST_CONTEXT(name_of(type)) {
      const Mesh mesh = distorted_cell(type);
      test(mesh, {mesh, Element::q1});
    }
  const Mesh mesh = distorted_cell(CellType::hexahedron);
  BOOST_TEST_CONTEXT("q2")
  test(mesh, {mesh, Element::q2});
}

Matrix3 rows(const CellVectors& a, const CellVectors& b) {
  return a * b.transpose();
}

}  // namespace

// The derivatives are taken along two random directions, at a random displacement. Errors
// are as in laws.hpp: 1e-12 of the moduli times derivatives by strains of up to 1; forces
// are compared with stiffness times displacement.
BOOST_AUTO_TEST_CASE(forces_and_tangent_are_derivatives_of_the_energy) {
  for_all_cells([](const Mesh&, const OneCell& cell) {
    const CellVectors u = cell.at_nodes(random_nodal(cell.body, 0.04 * edge));
    for (const Law law : laws)
      for (const DilatationTaken taken : places)
        for (const unsigned seed : {1U, 2U})
          BOOST_TEST_CONTEXT(words(law) << ", dilatation " << static_cast<int>(taken)) {
            const CellLaw psi = cell_law(law, taken);
            const CellVectors along = cell.at_nodes(random_nodal(cell.body, edge, seed));
            const auto energies = [&](double d) {
              return scalar(cell_state(psi, cell.shape(), u + d * along).energy);
            };
            const auto forces = [&](double d) -> Eigen::VectorXd {
              return cell_state(psi, cell.shape(), u + d * along).forces.reshaped();
            };
            const double slope =
                cell_state(psi, cell.shape(), u).forces.cwiseProduct(along).sum();
            BOOST_TEST(std::abs(derivative(energies)[0] - slope) < 1e-8 * young * volume);
            const CellMatrix K = cell_tangent(psi, cell.shape(), u);
            const Eigen::VectorXd change = K * along.reshaped();
            BOOST_TEST((derivative(forces) - change).norm() < 1e-8 * change.norm());
            BOOST_TEST(largest(K - K.transpose()) < 1e-13 * largest(K));
          }
  });
}

// In an affine field all places see the same dilatation. The tolerance is round-off: a
// pyramid's points have 14 digits.
BOOST_AUTO_TEST_CASE(homogeneous_cell_has_the_laws_energy_wherever_dilatation_is_taken) {
  const Matrix3 H = general_gradient();
  for_all_cells([&](const Mesh& mesh, const OneCell& cell) {
    const CellVectors X = cell.at_nodes([](const Vector3& x) { return x; });
    for (const Law law : laws)
      for (const DilatationTaken taken : places) {
        const CellLaw psi = cell_law(law, taken);
        const CellState state = cell_state(psi, cell.shape(), H * X);
        BOOST_TEST(state.energy == mesh.volume() * energy(psi.constitution, H),
                   round_off);
        BOOST_TEST(state.smallest_jacobian == (Matrix3::Identity() + H).determinant(),
                   round_off);
        BOOST_TEST(
            gradient_square(cell.shape(), H * X) == mesh.volume() * H.squaredNorm(),
            round_off);
        BOOST_TEST(deformed_volume(cell.shape(), H * X) ==
                       mesh.volume() * (Matrix3::Identity() + H).determinant(),
                   round_off);
        // sum f_a (x) X_a = int P dV
        const Matrix3 P = stress(psi.constitution, H);
        BOOST_TEST(largest(rows(state.forces, X) - mesh.volume() * P) <
                   1e-12 * young * volume);
      }
  });
}

// The cell's forces have no net force, and no torque about the deformed nodes (Hooke's:
// the undeformed). The tolerance is round-off.
BOOST_AUTO_TEST_CASE(cell_forces_balance) {
  for_all_cells([](const Mesh&, const OneCell& cell) {
    const CellVectors X = cell.at_nodes([](const Vector3& x) { return x; });
    const CellVectors u = cell.at_nodes(random_nodal(cell.body, 0.04 * edge));
    for (const Law law : laws)
      for (const DilatationTaken taken : places) {
        const CellVectors f = cell_state(cell_law(law, taken), cell.shape(), u).forces;
        const double band = 1e-14 * young * edge * edge;
        BOOST_TEST(largest(f.rowwise().sum()) < band);
        const Matrix3 moment = rows(f, law == Law::hooke ? X : CellVectors(X + u));
        BOOST_TEST(largest(moment - moment.transpose()) < band * edge);
      }
  });
}

// A rigidly turned cell is free of force, and turns its forces along. The tolerance is
// round-off.
BOOST_AUTO_TEST_CASE(cell_forces_turn_along_with_the_cell) {
  const Matrix3 Q = rotation(2.3, {1, 3, -2});
  for_all_cells([&](const Mesh&, const OneCell& cell) {
    const CellVectors X = cell.at_nodes([](const Vector3& x) { return x; });
    const CellVectors u = cell.at_nodes(random_nodal(cell.body, 0.04 * edge));
    for (const Law law : {Law::st_venant_kirchhoff, Law::hencky, Law::cauchy_born})
      for (const DilatationTaken taken : places) {
        const auto forces = [&](const CellVectors& at) {
          return cell_state(cell_law(law, taken), cell.shape(), at).forces;
        };
        const double band = 1e-13 * young * edge * edge;
        BOOST_TEST(largest(forces(Q * X - X)) < band);
        BOOST_TEST(largest(forces(Q * (X + u) - X) - Q * forces(u)) < band);
      }
  });
}

// At small strain the stiffness has no zero modes but these. The next eigenvalue is some
// 1e-2 of the largest, rounding 1e-15 of it. (A triquadratic cell with a mean dilatation,
// which no element is, would not resist the quadratic conformal maps.)
BOOST_AUTO_TEST_CASE(only_rigid_motions_are_free_of_force) {
  for_all_cells([](const Mesh&, const OneCell& cell) {
    const Eigen::Index count = cell.shape().nodes;
    for (const DilatationTaken taken : places) {
      if (count == 27 && taken != DilatationTaken::at_points) continue;
      const CellMatrix K = cell_tangent(cell_law(Law::hooke, taken), cell.shape(),
                                        CellVectors::Zero(3, count));
      const Eigen::VectorXd eigenvalues =
          Eigen::SelfAdjointEigenSolver<CellMatrix>(K, Eigen::EigenvaluesOnly)
              .eigenvalues();
      BOOST_TEST(largest(eigenvalues.head(6)) < 1e-12 * eigenvalues.maxCoeff());
      BOOST_TEST(eigenvalues[6] > 1e-4 * eigenvalues.maxCoeff());
    }
  });
}

// Which corner a cell begins with is nobody's choice: the energy is that of the nodes'
// positions. When the cell is turned about its axis, the names are again those of
// CellNodes. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(energy_does_not_depend_on_the_corner_that_is_named_first,
                     *boost::unit_test::tolerance(1e-12)) {
  const struct {
    CellType type;
    CellNodes turned;
  } turns[]{{CellType::tetrahedron, {1, 2, 0, 3}},
            {CellType::pyramid, {1, 2, 3, 0, 4}},
            {CellType::prism, {1, 2, 0, 4, 5, 3}},
            {CellType::hexahedron, {1, 2, 3, 0, 5, 6, 7, 4}}};
  for (const auto& [type, turned] : turns) {
    const OneCell cell(distorted_cell(type), Element::q1),
        other(mesh_of(corners_of_distorted(type), turned), Element::q1);
    const Eigen::VectorXd u = random_nodal(cell.body, 0.04 * edge);
    for (const Law law : laws)
      for (const DilatationTaken taken : places) {
        const CellLaw psi = cell_law(law, taken);
        BOOST_TEST(cell_state(psi, other.shape(), other.at_nodes(u)).energy ==
                   cell_state(psi, cell.shape(), cell.at_nodes(u)).energy);
      }
  }
}

// The gradient is one in all of it: q1_sri is q1. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(tetrahedron_sees_one_dilatation_wherever_it_is_taken) {
  const OneCell cell(distorted_cell(CellType::tetrahedron), Element::q1);
  const CellVectors u = cell.at_nodes(random_nodal(cell.body, 0.04 * edge));
  for (const Law law : laws) {
    const auto at = [&](DilatationTaken taken) {
      return cell_state(cell_law(law, taken), cell.shape(), u);
    };
    const CellState q1 = at(DilatationTaken::at_points);
    for (const DilatationTaken taken : places) {
      BOOST_TEST(at(taken).energy == q1.energy, round_off);
      BOOST_TEST(largest(at(taken).forces - q1.forces) < 1e-12 * largest(q1.forces));
    }
  }
}

BOOST_AUTO_TEST_CASE(cells_have_the_gauss_points_of_their_type) {
  const auto points = [](CellType type, Element element) {
    return OneCell(distorted_cell(type), element).shape().weights.size();
  };
  BOOST_TEST(points(CellType::tetrahedron, Element::q1) == 1);
  BOOST_TEST(points(CellType::pyramid, Element::q1) == 8);
  BOOST_TEST(points(CellType::prism, Element::q1) == 6);
  BOOST_TEST(points(CellType::hexahedron, Element::q1) == 8);
  BOOST_TEST(points(CellType::hexahedron, Element::q2) == 27);
}

// Hencky's energy of the cell's own volume: K/2 (ln V/V0)^2 V0, with the exact volume of
// the deformed cell. The rest does not depend on K. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(hencky_cell_knows_its_exact_volume,
                     *boost::unit_test::tolerance(1e-11)) {
  for (const CellType type : all_cell_types) {
    const Mesh mesh = distorted_cell(type);
    const OneCell cell(mesh, Element::q1_sri);
    const Eigen::VectorXd u = random_nodal(cell.body, 0.1 * edge);
    CornerPositions moved = corners(mesh.cells().front(), mesh.nodes());
    moved += u.reshaped(3, moved.cols());
    const double V = cell_volume(moved), V0 = mesh.volume();
    const auto state = [&](double bulk_modulus) {
      const Hencky law{.shear_modulus = 1, .bulk_modulus = bulk_modulus};
      return cell_state({.constitution = law, .dilatation = DilatationTaken::cell_mean},
                        cell.shape(), cell.at_nodes(u));
    };
    BOOST_TEST(deformed_volume(cell.shape(), cell.at_nodes(u)) == V);
    BOOST_TEST(state(1e4).energy - state(0).energy ==
               1e4 / 2 * std::pow(std::log(V / V0), 2) * V0);
  }
}

// Golec 2018, Eq. 5.19: V = X.(Y x Z) of the mean edge vectors is what the springs'
// volume correction kappa/2 (V - V0)^2/V0 sees of a cubic cell. The tolerance is
// round-off.
BOOST_AUTO_TEST_CASE(cauchy_born_cell_sees_the_volume_of_its_mean_edges,
                     *boost::unit_test::tolerance(1e-11)) {
  const Mesh mesh = cube(1);
  const OneCell cell(mesh, Element::q1_sri);
  const Eigen::VectorXd u = random_nodal(cell.body, 0.1 * edge);
  const auto x = [&](std::size_t corner) -> Vector3 {
    const NodeIndex node = mesh.cells().front()[corner];
    return mesh.nodes()[node] + u.segment<3>(3 * node);
  };
  const Vector3 X = (x(1) + x(2) + x(5) + x(6) - x(0) - x(3) - x(4) - x(7)) / 4,
                Y = (x(2) + x(3) + x(6) + x(7) - x(0) - x(1) - x(4) - x(5)) / 4,
                Z = (x(4) + x(5) + x(6) + x(7) - x(0) - x(1) - x(2) - x(3)) / 4;
  const double V = X.dot(Y.cross(Z));
  const auto energy_of = [&](double kappa) {
    const CauchyBorn law{.springs = {{Vector3::UnitX(), 1}}, .volume_modulus = kappa};
    const CellLaw psi{.constitution = law,
                      .dilatation = dilatation_taken(
                          {.law = Law::cauchy_born, .element = Element::q1_sri})};
    return cell_state(psi, cell.shape(), cell.at_nodes(u)).energy;
  };
  BOOST_TEST(energy_of(1e4) - energy_of(0) ==
             1e4 / 2 * (V - volume) * (V - volume) / volume);
}

BOOST_AUTO_TEST_CASE(each_element_takes_its_dilatation_where_it_says) {
  const auto taken = [](Law law, Element element) {
    return dilatation_taken({.law = law, .element = element});
  };
  for (const Law law : laws) {
    BOOST_TEST((taken(law, Element::q1) == DilatationTaken::at_points));
    BOOST_TEST((taken(law, Element::q2) == DilatationTaken::at_points));
  }
  for (const Law law : {Law::hooke, Law::st_venant_kirchhoff, Law::hencky})
    BOOST_TEST((taken(law, Element::q1_sri) == DilatationTaken::cell_mean));
}

BOOST_AUTO_TEST_SUITE_END()
