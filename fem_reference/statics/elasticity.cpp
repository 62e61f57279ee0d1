#include "fem_reference/statics/elasticity.hpp"

#include <spdlog/spdlog.h>
#include <tbb/parallel_for.h>

#include <deal.II/lac/solver_minres.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem_reference/statics/linear_solver_taken.hpp"

namespace springcheck::fem_reference {
namespace {

/// Of the right-hand side, which on n cells across exceeds the reactions that Newton's
/// method measures by (a factor of about n): one solve must reach its 1e-10 of them.
constexpr double linear_tolerance = 1e-12;

/// Computes something for every cell in parallel and hands it over in the order of the
/// cells, so that sums do not depend on the number of threads.
template <class Compute, class Use>
void for_each_cell(const std::vector<Cell>& cells, const Compute& compute,
                   const Use& use) {
  constexpr std::size_t at_once = 512;
  std::vector<decltype(compute(cells.front()))> results(std::min(at_once, cells.size()));
  for (std::size_t first = 0; first < cells.size(); first += at_once) {
    const std::size_t count = std::min(at_once, cells.size() - first);
    tbb::parallel_for(std::size_t{0}, count,
                      [&](std::size_t i) { results[i] = compute(cells[first + i]); });
    for (std::size_t i = 0; i < count; ++i) use(cells[first + i], results[i]);
  }
}

std::vector<bool> negated(std::vector<bool> flags) {
  flags.flip();
  return flags;
}

}  // namespace

Elasticity::Elasticity(const Discretisation& body, const Material& material,
                       const Settings& settings, const std::vector<bool>& prescribed)
    : body_(body),
      law_{.constitution = constitution(material, settings),
           .dilatation = dilatation_taken(settings)},
      solver_(linear_solver_taken(settings, material.poisson_ratio, prescribed.size())),
      system_(body.nodes, patches(body), negated(prescribed), solver_) {}

bool Elasticity::is_linear() const {
  return std::holds_alternative<Hooke>(law_.constitution);
}

Elasticity::Internal Elasticity::internal(const Eigen::VectorXd& displacements) const {
  Internal sum{.energy = 0,
               .forces = Eigen::VectorXd::Zero(displacements.size()),
               .smallest_jacobian = std::numeric_limits<double>::infinity(),
               .mean_gradient = 0};
  double volume = 0;
  const auto state_of = [&](const Cell& cell) {
    return cell_state(law_, *cell.shape, of_cell(displacements, cell));
  };
  for_each_cell(body_.cells, state_of, [&](const Cell& cell, const CellState& state) {
    sum.energy += state.energy;
    for (std::size_t a = 0; a < cell.nodes.size(); ++a)
      sum.forces.segment<3>(3 * cell.nodes[a]) +=
          state.forces.col(static_cast<Eigen::Index>(a));
    sum.smallest_jacobian = std::min(sum.smallest_jacobian, state.smallest_jacobian);
    sum.mean_gradient += state.gradient_square;
    volume += cell.shape->volume;
  });
  sum.mean_gradient = std::sqrt(sum.mean_gradient / volume);
  return sum;
}

std::vector<double> Elasticity::cell_volumes(const Eigen::VectorXd& displacements) const {
  std::vector<double> volumes;
  for (const Cell& cell : body_.cells)
    volumes.push_back(
        cell_state(law_, *cell.shape, of_cell(displacements, cell)).deformed_volume);
  return volumes;
}

bool Elasticity::linearise(const Eigen::VectorXd& displacements) {
  if (is_linear() && largest_diagonal_ > 0) return true;  // the tangent is constant
  system_.matrix().assemble([&](std::size_t c) {
    const Cell& cell = body_.cells[c];
    return cell_tangent(law_, *cell.shape, of_cell(displacements, cell));
  });
  system_.prepare();
  if (system_.unknowns().count() > 0)
    largest_diagonal_ = diagonal(system_.matrix(), system_.unknowns()).maxCoeff();
  definiteness_ = Definiteness::unknown;
  if (solver_ == statics::LinearSolver::direct) return is_definite();
  if (is_linear()) definiteness_ = Definiteness::definite;
  return true;
}

bool Elasticity::is_definite() {
  if (definiteness_ == Definiteness::unknown) {
    std::mt19937_64 random(1);
    definiteness_ = system_.is_definite(random).value_or(false)
                        ? Definiteness::definite
                        : Definiteness::indefinite;
  }
  return definiteness_ == Definiteness::definite;
}

bool Elasticity::accept_indefinite() {
  negative_eigenvalues_.reset();
  if (solver_ == statics::LinearSolver::direct) {
    const bool is_first = !triangle_;
    if (is_first) triangle_.emplace(system_.matrix(), system_.unknowns());
    const Eigen::SparseMatrix<double>& matrix = triangle_->copy_of(system_.matrix());
    if (is_first) indefinite_.analyzePattern(matrix);
    indefinite_.factorize(matrix);
    ++indefinite_effort_;
    if (indefinite_.info() != Eigen::Success) return false;
    negative_eigenvalues_ = static_cast<int>((indefinite_.vectorD().array() < 0).count());
  }
  definiteness_ = Definiteness::indefinite_accepted;
  return true;
}

std::optional<Eigen::VectorXd> Elasticity::solved(const Eigen::VectorXd& right) {
  if (definiteness_ == Definiteness::indefinite_accepted) return solved_indefinite(right);
  const int truncated = system_.truncated();
  std::optional<Eigen::VectorXd> answer = system_.solve(right, linear_tolerance);
  if (!answer) definiteness_ = Definiteness::indefinite;
  if (system_.truncated() > truncated) return std::nullopt;
  return answer;
}

std::optional<Eigen::VectorXd> Elasticity::solved_indefinite(
    const Eigen::VectorXd& right) {
  if (solver_ == statics::LinearSolver::direct) return indefinite_.solve(right);
  using Vector = dealii::Vector<double>;
  using ConstMap = Eigen::Map<const Eigen::VectorXd>;
  const statics::Unknowns& unknowns = system_.unknowns();
  const Eigen::VectorXd spread = unknowns.spread(right);
  const auto assign = [](Vector& to, const Eigen::VectorXd& values) {
    std::ranges::copy(values, to.begin());
  };
  struct Operator {
    std::function<void(Vector&, const Vector&)> vmult;
  };
  const Operator product{[&](Vector& result, const Vector& x) {
    Eigen::VectorXd image;
    system_.matrix().multiply(ConstMap(x.begin(), spread.size()), image);
    unknowns.clear_prescribed(image);
    assign(result, image);
  }};
  const Operator preconditioner{[&](Vector& result, const Vector& x) {
    assign(result, system_.preconditioned(ConstMap(x.begin(), spread.size())));
  }};
  Vector b(static_cast<unsigned int>(spread.size())), x(b.size());
  assign(b, spread);
  // MINRES judges the residual in the norm of the preconditioner.
  preconditioner.vmult(x, b);
  constexpr int iteration_limit = 5000;
  dealii::SolverControl control(iteration_limit, linear_tolerance * std::sqrt(x * b));
  x = 0;
  dealii::SolverMinRes<Vector> solver(control);
  try {
    solver.solve(product, x, b, preconditioner);
  } catch (const dealii::SolverControl::NoConvergence&) {
    return std::nullopt;
  }
  indefinite_effort_ += static_cast<int>(control.last_step());
  return unknowns.in(ConstMap(x.begin(), spread.size()));
}

std::optional<Eigen::VectorXd> Elasticity::step(const Eigen::VectorXd& unbalanced,
                                                const Eigen::VectorXd& increment) {
  const Eigen::VectorXd moved = increment - free_part(increment);
  Eigen::VectorXd forces_of_moved;
  system_.matrix().multiply(moved, forces_of_moved);
  const Eigen::VectorXd right = system_.unknowns().in(unbalanced - forces_of_moved);
  if (right.isZero(0)) return moved;
  const std::optional<Eigen::VectorXd> answer = solved(right);
  if (!answer) return std::nullopt;
  return system_.unknowns().spread(*answer) + moved;
}

Eigen::VectorXd Elasticity::free_part(Eigen::VectorXd nodal) const {
  system_.unknowns().clear_prescribed(nodal);
  return nodal;
}

double Elasticity::round_off(const Eigen::VectorXd& displacements) const {
  return 10 * std::numeric_limits<double>::epsilon() * largest_diagonal_ *
         displacements.norm();
}

std::optional<int> Elasticity::linear_iterations() const {
  const auto definite = system_.iterations();
  if (!definite) return std::nullopt;
  return *definite + indefinite_effort_;
}

std::optional<int> Elasticity::factorisations() const {
  const auto definite = system_.factorisations();
  if (!definite) return std::nullopt;
  return *definite + indefinite_effort_;
}

}  // namespace springcheck::fem_reference
