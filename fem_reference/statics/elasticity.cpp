#include "fem_reference/statics/elasticity.hpp"

#include <spdlog/spdlog.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem_reference/statics/takes_multigrid.hpp"

namespace springcheck::fem_reference {
namespace {

/// Of the right-hand side, which on n cells across exceeds the reactions that Newton's
/// method measures by (a factor of about n): one solve must reach its 1e-10 of them.
constexpr double linear_tolerance = 1e-12;

/// An old hierarchy is replaced when it needs this many times a fresh one's iterations.
constexpr double stale = 1.5;

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

}  // namespace

Elasticity::Elasticity(const Discretisation& body, const Material& material,
                       const Settings& settings, const std::vector<bool>& prescribed)
    : body_(body),
      prescribed_(prescribed),
      law_{.constitution = constitution(material, settings),
           .dilatation = dilatation_taken(settings)},
      stiffness_(body, prescribed) {
  if (takes_multigrid(settings, material.poisson_ratio, prescribed.size()))
    multigrid_.emplace(body.nodes, prescribed);
}

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
  if (is_linear() && linearised_at_.size() > 0) return true;  // the tangent is constant
  linearised_at_ = displacements;
  stiffness_.clear();
  const auto tangent_of = [&](const Cell& cell) {
    return cell_tangent(law_, *cell.shape, of_cell(displacements, cell));
  };
  for_each_cell(body_.cells, tangent_of,
                [&](const Cell& cell, const CellMatrix& tangent) {
                  stiffness_.add(cell, tangent);
                });
  stiffness_.finish();
  definiteness_ = Definiteness::unknown;
  if (multigrid_) {
    if (is_linear()) definiteness_ = Definiteness::definite;
    if (!multigrid_->has_preconditioner()) {
      multigrid_->precondition(stiffness_.matrix());
      preconditioner_is_fresh_ = true;
    }
    return true;
  }
  definiteness_ = direct_.factor_definite(stiffness_.matrix()) ? Definiteness::definite
                                                               : Definiteness::indefinite;
  return definiteness_ == Definiteness::definite;
}

bool Elasticity::is_definite() {
  if (definiteness_ == Definiteness::unknown) {
    const Multigrid::Answer probed = multigrid_->probe(stiffness_.matrix());
    iterations_ += probed.iterations;
    negative_eigenvalues_ = probed.negative_curvatures;
    definiteness_ = probed.converged && probed.negative_curvatures == 0
                        ? Definiteness::definite
                        : Definiteness::indefinite;
  }
  return definiteness_ == Definiteness::definite;
}

bool Elasticity::accept_indefinite() {
  if (!multigrid_) {
    if (!direct_.factor_indefinite(stiffness_.matrix())) return false;
    negative_eigenvalues_ = direct_.negative_pivots();
  }
  definiteness_ = Definiteness::indefinite_accepted;
  return true;
}

std::optional<Eigen::VectorXd> Elasticity::solved(const Eigen::VectorXd& right) {
  if (!multigrid_) return direct_.solve(right);
  if (definiteness_ == Definiteness::indefinite_accepted) {
    Multigrid::Answer answer =
        multigrid_->solve_indefinite(stiffness_.matrix(), right, linear_tolerance);
    iterations_ += answer.iterations;
    if (!answer.converged) return std::nullopt;
    return std::move(answer.solution);
  }
  Multigrid::Answer answer =
      multigrid_->solve_definite(stiffness_.matrix(), right, linear_tolerance);
  iterations_ += answer.iterations;
  spdlog::debug("    conjugate gradients: {} iterations{}", answer.iterations,
                answer.negative_curvatures > 0 ? ", negative curvature" : "");
  if (!answer.converged) {
    if (answer.negative_curvatures > 0) definiteness_ = Definiteness::indefinite;
    return std::nullopt;
  }
  if (preconditioner_is_fresh_) {
    iterations_when_fresh_ = answer.iterations;
    preconditioner_is_fresh_ = false;
  } else if (answer.iterations > stale * iterations_when_fresh_ && is_definite()) {
    multigrid_->precondition(stiffness_.matrix());
    preconditioner_is_fresh_ = true;
  }
  return std::move(answer.solution);
}

Eigen::VectorXd Elasticity::forces_of(const Eigen::VectorXd& increment) const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(increment.size());
  for (const Cell& cell : body_.cells) {
    const CellVectors moved = of_cell(increment, cell);
    if (moved.isZero(0)) continue;
    const Eigen::VectorXd pushed =
        cell_tangent(law_, *cell.shape, of_cell(linearised_at_, cell)) * moved.reshaped();
    for (std::size_t a = 0; a < cell.nodes.size(); ++a)
      forces.segment<3>(3 * cell.nodes[a]) +=
          pushed.segment<3>(static_cast<Eigen::Index>(3 * a));
  }
  return forces;
}

std::optional<Eigen::VectorXd> Elasticity::step(const Eigen::VectorXd& unbalanced,
                                                const Eigen::VectorXd& increment) {
  const Eigen::VectorXd moved = increment - free_part(increment);
  const Eigen::VectorXd right = free_part(unbalanced - forces_of(moved));
  if (right.isZero(0)) return moved;
  std::optional<Eigen::VectorXd> answer = solved(right);
  if (answer) *answer = free_part(std::move(*answer)) + moved;
  return answer;
}

Eigen::VectorXd Elasticity::free_part(Eigen::VectorXd nodal) const {
  for (std::size_t dof = 0; dof < prescribed_.size(); ++dof)
    if (prescribed_[dof]) nodal[static_cast<Eigen::Index>(dof)] = 0;
  return nodal;
}

double Elasticity::round_off(const Eigen::VectorXd& displacements) const {
  return 10 * std::numeric_limits<double>::epsilon() * stiffness_.largest_diagonal() *
         displacements.norm();
}

std::optional<int> Elasticity::linear_iterations() const {
  if (!multigrid_) return std::nullopt;
  return iterations_;
}

std::optional<int> Elasticity::factorisations() const {
  if (multigrid_) return std::nullopt;
  return direct_.factorisations();
}

}  // namespace springcheck::fem_reference
