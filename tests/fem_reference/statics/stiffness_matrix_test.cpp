#include "fem_reference/statics/stiffness_matrix.hpp"

#include <boost/test/unit_test.hpp>

#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(stiffness_matrix_test)

namespace {

const CellLaw law{.constitution = hencky(lame_constants(of_poisson_ratio(0.3))),
                  .dilatation = DilatationTaken::cell_mean};

/// Every seventh dof and all of the first node's.
std::vector<bool> some_prescribed(const Discretisation& body) {
  std::vector<bool> prescribed(3 * body.nodes.size(), false);
  for (std::size_t dof = 0; dof < prescribed.size(); ++dof)
    prescribed[dof] = dof < 3 || dof % 7 == 0;
  return prescribed;
}

}  // namespace

// Round-off; the second assembly shows that nothing is left of the first.
BOOST_AUTO_TEST_CASE(cells_add_up_on_free_dofs_and_prescribed_ones_keep_a_diagonal) {
  for (const auto& [pattern, element] : {std::pair{CellPattern::hexahedron, Element::q2},
                                         {CellPattern::mixed, Element::q1}}) {
    const Discretisation body = discretise(warped_cube(2, pattern), element);
    const std::vector<bool> prescribed = some_prescribed(body);
    StiffnessMatrix stiffness(body, prescribed);
    for (const unsigned seed : {1U, 2U}) {
      const Eigen::VectorXd u = random_nodal(body, 0.02 * edge, seed);
      stiffness.clear();
      for (const Cell& cell : body.cells)
        stiffness.add(cell, cell_tangent(law, *cell.shape, of_cell(u, cell)));
      stiffness.finish();

      Eigen::MatrixXd expected = dense_tangent(body, law, u);
      const double diagonal = free_block(expected, prescribed).diagonal().maxCoeff();
      for (std::size_t dof = 0; dof < prescribed.size(); ++dof)
        if (prescribed[dof]) {
          const auto i = static_cast<Eigen::Index>(dof);
          expected.row(i).setZero();
          expected.col(i).setZero();
          expected(i, i) = diagonal;
        }
      BOOST_TEST(stiffness.largest_diagonal() == diagonal,
                 boost::test_tools::tolerance(1e-14));
      BOOST_TEST(largest(Eigen::MatrixXd(stiffness.matrix()) - expected) <
                 1e-14 * diagonal);
    }
  }
}

BOOST_AUTO_TEST_CASE(wholly_prescribed_body_has_the_unit_matrix) {
  const Discretisation body = discretise(cube(1), Element::q1);
  const std::vector<bool> all(3 * body.nodes.size(), true);
  StiffnessMatrix stiffness(body, all);
  stiffness.clear();
  stiffness.finish();
  BOOST_TEST((Eigen::MatrixXd(stiffness.matrix()) == Eigen::MatrixXd::Identity(24, 24)));
  BOOST_TEST(stiffness.largest_diagonal() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
