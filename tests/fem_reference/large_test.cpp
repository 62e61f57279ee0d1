#include <boost/test/unit_test.hpp>

#include "fem_reference/solve.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;
using statics::LinearSolver;

BOOST_AUTO_TEST_SUITE(large_test)

// 27,783 and 680,943 unknowns, nu = 1/4: multigrid's promise is a number of iterations
// that hardly depends on the grid; less than 1.5 times as many are allowed (12 and 15).
BOOST_AUTO_TEST_CASE(iterations_hardly_grow_up_to_sixty_cells_along_each_axis) {
  const auto iterations = [](int cells) {
    const Solution solution =
        solve(cube(cells), between_plates(of_poisson_ratio(0.25), {0, 0, -0.05 * edge}),
              {.law = Law::hooke, .element = Element::q1_sri},
              {.linear_solver = LinearSolver::multigrid});
    BOOST_TEST((solution.status == SolveStatus::ok));
    return solution.linear_iterations.value();
  };
  const int coarse = iterations(20), fine = iterations(60);
  BOOST_TEST_MESSAGE(coarse << " and " << fine);
  BOOST_TEST(fine < 1.5 * coarse);
}

BOOST_AUTO_TEST_SUITE_END()
