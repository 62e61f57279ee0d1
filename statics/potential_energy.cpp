#include "statics/potential_energy.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck::statics {
namespace {

using Eigen::VectorXd;

// A less accurate predictor, 1e-3, leaves so much volume change at 60^3 cells and nu =
// .499 that the load has to be cut in two.
constexpr double predictor_accuracy = 1e-4;
// The prediction of a linear body is the answer. On n cells across the right-hand side
// exceeds the reactions, by which the residual is measured, by a factor of about n.
constexpr double answer_accuracy = 1e-12;

}  // namespace

PotentialEnergy::PotentialEnergy(ElasticBody& body, const Loading& loading,
                                 LinearSolver linear_solver)
    : body_(body),
      loading_(loading),
      system_(
          body.nodes(), body.patches(), loading.is_free,
          linear_solver_taken(linear_solver, std::ranges::count(loading.is_free, true))) {
}

double PotentialEnergy::load_norm() const {
  return load_fraction_ * loading_.forces.norm();
}

PotentialEnergy::State PotentialEnergy::at(VectorXd u) {
  ++evaluations_;
  auto [strain_energy, forces] = body_.state(u);
  forces += load_fraction_ * loading_.forces;
  const double energy = strain_energy - load_fraction_ * loading_.forces.dot(u);
  return {.displacements = std::move(u),
          .energy = energy,
          .strain_energy = strain_energy,
          .forces = std::move(forces)};
}

VectorXd PotentialEnergy::reactions(const State& state) const {
  VectorXd forces = -state.forces;
  forces(unknowns().components()).setZero();
  return forces;
}

double PotentialEnergy::force_round_off(const VectorXd& u) const {
  return stiffness_ * body_.rounding(u);
}

double PotentialEnergy::energy_round_off(const VectorXd& u, double energy) const {
  // Errors of a sum add up like a random walk; 1e-13 is ample for 10^4 unknowns.
  const double terms = std::max(1., static_cast<double>(unknowns().count()) / 1e4);
  return 1e-13 * std::sqrt(terms) * std::abs(energy) +
         force_round_off(u) * std::sqrt(2 * std::abs(energy) / stiffness_);
}

VectorXd PotentialEnergy::moved(const VectorXd& u, const VectorXd& step) const {
  VectorXd there = u;
  there(unknowns().components()) += step;
  return there;
}

double PotentialEnergy::longest_move(const VectorXd& step) const {
  return unknowns()
      .spread(step)
      .reshaped(3, loading_.forces.size() / 3)
      .colwise()
      .norm()
      .maxCoeff();
}

void PotentialEnergy::linearise(const VectorXd& u) {
  if (body_.is_linear() && is_prepared_) return;
  is_prepared_ = true;
  is_clamped_ = false;
  body_.linearise(u);
  system_.matrix().assemble([&](std::size_t patch) { return body_.part(patch); });
  stiffness_ = std::max(stiffness_, diagonal(system_.matrix(), unknowns()).norm());
  system_.prepare();
}

void PotentialEnergy::clamp() {
  is_clamped_ = true;
  system_.matrix().assemble(
      [&](std::size_t patch) { return body_.positive_part(patch); });
  system_.prepare_semidefinite();
}

std::optional<bool> PotentialEnergy::is_definite(std::mt19937_64& random) {
  if (body_.is_linear()) return true;
  return system_.is_definite(random);
}

std::optional<VectorXd> PotentialEnergy::solve(const VectorXd& right, double accuracy) {
  return system_.solve(right, accuracy);
}

VectorXd PotentialEnergy::negative_curvature(const VectorXd& downhill,
                                             std::mt19937_64& random) {
  VectorXd v = system_.negative_curvature(random);
  if (downhill.dot(v) < 0) v = -v;
  return v;
}

double PotentialEnergy::curvature_along(const VectorXd& direction) const {
  VectorXd product;
  system_.matrix().multiply(unknowns().spread(direction), product);
  return direction.dot(unknowns().in(product));
}

VectorXd PotentialEnergy::predicted(const VectorXd& u, double to) {
  VectorXd increment = loading_.displacements(to) - u;
  increment(unknowns().components()).setZero();
  const auto answer = [&] {
    VectorXd push;
    system_.matrix().multiply(increment, push);
    push = (to - load_fraction_) * loading_.forces - push;
    return solve(unknowns().in(push),
                 body_.is_linear() ? answer_accuracy : predictor_accuracy);
  };
  std::optional<VectorXd> step = answer();
  if (!step) {
    clamp();
    step = answer();
  }
  return step ? moved(u + increment, *step) : u + increment;
}

double PotentialEnergy::path_gradient(const VectorXd& whole) {
  constexpr double little = 1. / 64, clearly = 1.01;
  const double chord = body_.mean_gradient(whole);
  const double path =
      body_.mean_gradient(predicted(VectorXd::Zero(whole.size()), little)) / little;
  return path > clearly * chord ? path : chord;
}

}  // namespace springcheck::statics
