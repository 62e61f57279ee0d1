#include "fem_reference/statics/multigrid.hpp"

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_minres.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/vector.h>
#include <ml_MultiLevelPreconditioner.h>
#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <random>

#include "meshing/random_numbers.hpp"

namespace springcheck::fem_reference {
namespace {

constexpr int iteration_limit = 5000;

void start_mpi() {
  int started = 0;
  MPI_Initialized(&started);
  if (started != 0) return;
  // One process needs no daemon beside it (Open MPI; others ignore the variable).
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  std::atexit([] { MPI_Finalize(); });
}

/// The three translations and three rotations of the nodes, 0 at prescribed dofs, one
/// after the other.
std::vector<double> rigid_motions(std::span<const Vector3> nodes,
                                  const std::vector<bool>& prescribed) {
  Vector3 centre = Vector3::Zero();
  for (const Vector3& x : nodes) centre += x / static_cast<double>(nodes.size());
  double size = 0;
  for (const Vector3& x : nodes) size = std::max(size, (x - centre).norm());
  const std::size_t dofs = 3 * nodes.size();
  std::vector<double> modes(6 * dofs, 0.0);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Vector3 arm = (nodes[n] - centre) / size;
    for (std::size_t i = 0; i < 3; ++i) {
      Vector3 axis = Vector3::Zero();
      axis[static_cast<Eigen::Index>(i)] = 1;
      const Vector3 turn = axis.cross(arm);
      if (!prescribed[3 * n + i]) modes[i * dofs + 3 * n + i] = 1;
      for (std::size_t k = 0; k < 3; ++k)
        if (!prescribed[3 * n + k])
          modes[(3 + i) * dofs + 3 * n + k] = turn[static_cast<Eigen::Index>(k)];
    }
  }
  return modes;
}

std::unique_ptr<Epetra_CrsMatrix> epetra_copy(const SparseMatrix& matrix) {
  const int size = static_cast<int>(matrix.rows());
  const Epetra_Map map(size, 0, Epetra_MpiComm(MPI_COMM_SELF));
  std::vector<int> entries(static_cast<std::size_t>(size));
  const int* start = matrix.outerIndexPtr();
  for (int row = 0; row < size; ++row)
    entries[static_cast<std::size_t>(row)] = start[row + 1] - start[row];
  auto copy = std::make_unique<Epetra_CrsMatrix>(Copy, map, entries.data(), true);
  for (int row = 0; row < size; ++row)  // by symmetry a column is a row
    copy->InsertGlobalValues(row, start[row + 1] - start[row],
                             matrix.valuePtr() + start[row],
                             matrix.innerIndexPtr() + start[row]);
  copy->FillComplete();
  return copy;
}

using Vector = dealii::Vector<double>;
using Map = Eigen::Map<Eigen::VectorXd>;
using ConstMap = Eigen::Map<const Eigen::VectorXd>;

/// The matrix as deal.II's solvers see it.
struct Product {
  const SparseMatrix& matrix;
  void vmult(Vector& result, const Vector& x) const {
    Map(result.begin(), matrix.rows()).noalias() =
        matrix.transpose() * ConstMap(x.begin(), matrix.rows());
  }
};

struct NegativeCurvature {};

Vector copied(const Eigen::VectorXd& values) {
  Vector copy(static_cast<unsigned int>(values.size()));
  std::ranges::copy(values, copy.begin());
  return copy;
}

}  // namespace

struct Multigrid::Implementation {
  std::vector<double> modes;
  std::unique_ptr<Epetra_CrsMatrix> matrix;
  std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> hierarchy;  // needs MPI

  void vmult(Vector& result, const Vector& x) const {
    const std::lock_guard lock(random_numbers());  // every Epetra vector draws its seed
    hierarchy->vmult(result, x);
  }
};

Multigrid::Multigrid(std::span<const Vector3> nodes, const std::vector<bool>& prescribed)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->modes = rigid_motions(nodes, prescribed);
}

Multigrid::~Multigrid() {
  const std::lock_guard lock(random_numbers());
  implementation_.reset();
}

void Multigrid::precondition(const SparseMatrix& matrix) {
  const std::lock_guard lock(random_numbers());
  start_mpi();
  Implementation& self = *implementation_;
  self.hierarchy = std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>();
  self.matrix = epetra_copy(matrix);
  Teuchos::ParameterList settings;
  ML_Epetra::SetDefaults("SA", settings);
  settings.set("ML output", 0);
  settings.set("PDE equations", 3);
  settings.set("aggregation: type", "Uncoupled");
  settings.set("aggregation: threshold", 0.0);
  settings.set("smoother: type", "Chebyshev");
  settings.set("smoother: sweeps", 3);
  // A bound on the largest eigenvalue of D^-1 A instead of estimates that start at
  // random; it is about 1.9 times too high, so that 2.5 of it is 4/3 of the eigenvalue.
  settings.set("eigen-analysis: type", "Anorm");
  settings.set("aggregation: damping factor", 2.5);
  settings.set("coarse: type", "Amesos-KLU");
  settings.set("coarse: max size", 2000);
  settings.set("null space: type", "pre-computed");
  settings.set("null space: dimension", 6);
  settings.set("null space: vectors", self.modes.data());
  settings.set("null space: add default vectors", false);
  self.hierarchy->initialize(*self.matrix, settings);
}

bool Multigrid::has_preconditioner() const {
  return implementation_->matrix != nullptr;
}

namespace {

/// Conjugate gradients that count directions of negative curvature (stopping there or
/// not).
Multigrid::Answer conjugate_gradients(const Product& product, const auto& preconditioner,
                                      const Eigen::VectorXd& right, double tolerance,
                                      bool stop_at_negative_curvature) {
  dealii::SolverControl control(iteration_limit, tolerance * right.norm());
  dealii::SolverCG<Vector> solver(control);
  int negative = 0;
  solver.connect_coefficients_slot([&](double alpha, double) {
    if (alpha > 0) return;
    ++negative;
    if (stop_at_negative_curvature) throw NegativeCurvature();
  });
  Vector x(static_cast<unsigned int>(right.size()));
  bool converged = true;
  try {
    solver.solve(product, x, copied(right), preconditioner);
  } catch (const dealii::SolverControl::NoConvergence&) {
    converged = false;
  } catch (const NegativeCurvature&) {
    converged = false;
  }
  return {.solution = ConstMap(x.begin(), right.size()),
          .iterations = static_cast<int>(control.last_step()),
          .converged = converged,
          .negative_curvatures = negative};
}

}  // namespace

Multigrid::Answer Multigrid::solve_definite(const SparseMatrix& matrix,
                                            const Eigen::VectorXd& right,
                                            double tolerance) const {
  return conjugate_gradients(Product{matrix}, *implementation_, right, tolerance, true);
}

Multigrid::Answer Multigrid::solve_indefinite(const SparseMatrix& matrix,
                                              const Eigen::VectorXd& right,
                                              double tolerance) const {
  const Vector b = copied(right);
  Vector x(b.size());
  // MINRES judges the residual in the norm of the preconditioner.
  implementation_->vmult(x, b);
  dealii::SolverControl control(iteration_limit, tolerance * std::sqrt(x * b));
  x = 0;
  dealii::SolverMinRes<Vector> solver(control);
  bool converged = true;
  try {
    solver.solve(Product{matrix}, x, b, *implementation_);
  } catch (const dealii::SolverControl::NoConvergence&) {
    converged = false;
  }
  return {.solution = ConstMap(x.begin(), right.size()),
          .iterations = static_cast<int>(control.last_step()),
          .converged = converged,
          .negative_curvatures = 0};
}

Multigrid::Answer Multigrid::probe(const SparseMatrix& matrix) const {
  constexpr double resolved = 1e-4;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd right(matrix.rows());
  for (double& value : right) value = uniform(random);
  return conjugate_gradients(Product{matrix}, *implementation_, right, resolved, false);
}

}  // namespace springcheck::fem_reference
