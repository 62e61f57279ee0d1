#include "statics/systems/system.hpp"

#include <spdlog/spdlog.h>

#include "statics/systems/block_jacobi.hpp"
#include "statics/systems/multigrid.hpp"

namespace springcheck::statics {
namespace {

using Solver = std::variant<DirectSolver, IterativeSolver>;

Solver made(LinearSolver kind, const BlockMatrix& matrix, const Unknowns& unknowns,
            std::span<const Vector3> nodes, int iteration_limit) {
  if (kind == LinearSolver::direct)
    return Solver(std::in_place_type<DirectSolver>, matrix, unknowns);
  std::unique_ptr<Preconditioner> preconditioner;
  if (kind == LinearSolver::multigrid)
    preconditioner = std::make_unique<Multigrid>(nodes, unknowns);
  else
    preconditioner = std::make_unique<BlockJacobi>(unknowns);
  return Solver(std::in_place_type<IterativeSolver>, matrix, unknowns,
                std::move(preconditioner), iteration_limit);
}

}  // namespace

System::System(std::span<const Vector3> nodes, Patches patches,
               const std::vector<bool>& is_free, LinearSolver solver, int iteration_limit)
    : unknowns_(is_free),
      matrix_(std::move(patches), nodes.size()),
      solver_(made(solver, matrix_, unknowns_, nodes, iteration_limit)) {}

void System::prepare() {
  std::visit([](auto& solver) { solver.prepare(); }, solver_);
}

void System::prepare_semidefinite() {
  std::visit([](auto& solver) { solver.prepare_semidefinite(); }, solver_);
}

std::optional<bool> System::is_definite(std::mt19937_64& random) {
  if (auto* iterative = std::get_if<IterativeSolver>(&solver_))
    return iterative->is_definite(random);
  return std::get<DirectSolver>(solver_).is_definite();
}

std::optional<Eigen::VectorXd> System::solve(const Eigen::VectorXd& right,
                                             double accuracy) {
  auto* iterative = std::get_if<IterativeSolver>(&solver_);
  if (iterative == nullptr) return std::get<DirectSolver>(solver_).solve(right);
  auto answer = iterative->solve(right, accuracy);
  if (!answer) return std::nullopt;
  if (!answer->converged) {
    ++truncated_;
    spdlog::debug("    conjugate gradients: not yet accurate to {:.1e}", accuracy);
  }
  return std::move(answer->solution);
}

Eigen::VectorXd System::negative_curvature(std::mt19937_64& random) {
  return std::visit([&](auto& solver) { return solver.negative_curvature(random); },
                    solver_);
}

std::optional<int> System::iterations() const {
  if (const auto* iterative = std::get_if<IterativeSolver>(&solver_))
    return iterative->iterations();
  return std::nullopt;
}

std::optional<int> System::factorisations() const {
  if (const auto* direct = std::get_if<DirectSolver>(&solver_))
    return direct->factorisations();
  return std::nullopt;
}

bool prepare_shifted(System& system) {
  system.prepare();
  std::mt19937_64 unused;
  const bool is_definite = system.is_definite(unused).value();
  if (!is_definite) system.prepare_semidefinite();
  return is_definite;
}

}  // namespace springcheck::statics
