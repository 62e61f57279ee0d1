#include "statics/systems/sparse_cholesky.hpp"

#include <SuiteSparse_config.h>

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <new>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(sparse_cholesky_test)

namespace {

/// The matrix of the five-point Laplacian on a square, less so many times the identity.
SparseCholesky::Matrix laplacian(int side, double shift = 0) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < side * side; ++i) {
    entries.emplace_back(i, i, 4 - shift);
    if (i % side > 0) entries.emplace_back(i, i - 1, -1);
    if (i >= side) entries.emplace_back(i, i - side, -1);
  }
  SparseCholesky::Matrix matrix(side * side, side * side);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

int allocations_left = 0;

void* malloc_while_allowed(std::size_t bytes) {
  return allocations_left-- > 0 ? std::malloc(bytes) : nullptr;
}
void* calloc_while_allowed(std::size_t count, std::size_t bytes) {
  return allocations_left-- > 0 ? std::calloc(count, bytes) : nullptr;
}
void* realloc_while_allowed(void* old, std::size_t bytes) {
  return allocations_left-- > 0 ? std::realloc(old, bytes) : nullptr;
}

/// So many allocations of SuiteSparse succeed while this lives.
class Allocations {
 public:
  explicit Allocations(int allowed) {
    allocations_left = allowed;
    SuiteSparse_config.malloc_func = malloc_while_allowed;
    SuiteSparse_config.calloc_func = calloc_while_allowed;
    SuiteSparse_config.realloc_func = realloc_while_allowed;
  }
  ~Allocations() {
    SuiteSparse_config.malloc_func = std::malloc;
    SuiteSparse_config.calloc_func = std::calloc;
    SuiteSparse_config.realloc_func = std::realloc;
  }
  Allocations(const Allocations&) = delete;
  Allocations& operator=(const Allocations&) = delete;
};

const Eigen::VectorXd ones = Eigen::VectorXd::Ones(400);

}  // namespace

BOOST_AUTO_TEST_CASE(a_factor_solves_and_there_is_none_of_an_indefinite_matrix) {
  SparseCholesky cholesky;
  const SparseCholesky::Matrix matrix = laplacian(20);
  BOOST_TEST_REQUIRE(cholesky.factor(matrix));
  const Eigen::VectorXd x = cholesky.solve(ones);
  BOOST_TEST((matrix.selfadjointView<Eigen::Lower>() * x - ones).norm() < 1e-10);
  // The lowest eigenvalue is 8 sin^2(pi/42) = .0447.
  BOOST_TEST(cholesky.factor(laplacian(20, .044)));
  BOOST_TEST(!cholesky.factor(laplacian(20, .045)));
  BOOST_TEST(cholesky.factor(matrix));
  BOOST_TEST((cholesky.solve(ones) == x));
}

// Wherever the memory ends, that is what is said: neither is the matrix called definite
// or indefinite, nor are unset numbers handed out as the solution.
BOOST_AUTO_TEST_CASE(memory_that_ends_is_no_answer) {
  const SparseCholesky::Matrix matrix = laplacian(20);
  const Eigen::VectorXd expected = [&] {
    SparseCholesky cholesky;
    cholesky.factor(matrix);
    return cholesky.solve(ones);
  }();
  int refused = 0, answered = 0;
  for (int allowed = 0; answered == 0 && allowed < 1000; ++allowed) {
    SparseCholesky cholesky;
    try {
      const Allocations limit(allowed);
      const bool is_definite = cholesky.factor(matrix);
      const Eigen::VectorXd x = cholesky.solve(ones);
      BOOST_TEST(is_definite);
      BOOST_TEST((x == expected));
      ++answered;
    } catch (const std::bad_alloc&) {
      ++refused;
    }
    // The failure leaves no trace.
    BOOST_TEST_REQUIRE(cholesky.factor(matrix));
    BOOST_TEST((cholesky.solve(ones) == expected));
  }
  BOOST_TEST(answered == 1);
  BOOST_TEST(refused > 20);  // of ordering, factor and solution
}

BOOST_AUTO_TEST_SUITE_END()
