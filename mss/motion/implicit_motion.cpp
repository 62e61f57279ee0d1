#include "mss/motion/implicit_motion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "dynamics/supports.hpp"
#include "meshing/basics/breakdown.hpp"
#include "meshing/loads/traction.hpp"
#include "mss/forces/forces.hpp"
#include "mss/forces/tangent.hpp"
#include "statics/systems/free_triangle.hpp"
#include "statics/systems/sparse_cholesky.hpp"

namespace springcheck::mss {
namespace {

using dynamics::State;
using dynamics::StepTo;
using Field = Eigen::VectorXd;  // an entry per free component

constexpr double relative_residual = 1e-10;
constexpr int most_iterations = 50;
constexpr double shortest_factor = 1. / 1024;  // of a Newton step

class ImplicitMotion final : public dynamics::Motion {
 public:
  ImplicitMotion(const Mesh& mesh, const Scene& scene, const Network& network,
                 double damping_ratio)
      : network_(network),
        damping_ratio_(damping_ratio),
        load_(load_forces(mesh, scene, network.masses)),
        supports_(dynamics::supports(scene, prescribed_components(mesh, scene))),
        unknowns_(free_components(mesh, prescribed_components(mesh, scene))),
        matrix_(patches(network), network.masses.size()),
        triangle_(matrix_, unknowns_),
        state_{.displacements = std::vector<Vector3>(load_.size(), Vector3::Zero()),
               .velocities = std::vector<Vector3>(load_.size(), Vector3::Zero())},
        positions_(load_.size()),
        forces_(load_.size()) {}

  void advance(const StepTo& step) override {
    const State before = state_;
    for (const auto& [node, component, motion] : supports_) {
      const Vector3& point = network_.rest_positions[node];
      const double now = step.motions[motion].component(point, component);
      state_.velocities[node][component] =
          (now - step.motions_before[motion].component(point, component)) / step.dt;
      state_.displacements[node][component] = now;
    }
    move(before, step.dt, Field::Zero(unknowns_.count()));
    double scale = 0;
    Field residual = residual_of(before, step, scale);
    // What is not a number is not converged.
    for (int i = 0; !(residual.norm() <= relative_residual * scale); ++i) {
      const double norm = residual.norm();
      if (!std::isfinite(norm)) fail(step, "its forces are no numbers");
      const Field change = newton_step(step, residual);
      const State here = state_;
      for (double factor = 1;; factor /= 2) {
        move(before, step.dt, factor * change);
        residual = residual_of(before, step, scale);
        if (residual.norm() < norm && i < most_iterations) break;
        state_ = here;  // what did not bring it nearer is undone
        // The rounding of positions, of which forces keep a part, ends all progress.
        const double round_off = 1e-15 * stiffness_ * step.dt * network_reach();
        if (norm < round_off) return;
        if (factor < shortest_factor || i >= most_iterations)
          fail(step, fmt::format("it did not converge: relative residual {:.2g}",
                                 norm / scale));
      }
    }
  }

  [[nodiscard]] State state() const override { return state_; }
  void restore(const State& state) override { state_ = state; }

  [[nodiscard]] std::vector<Vector3> forces_at(const State& state) override {
    state_ = state;
    update_forces();
    return forces_;
  }

 private:
  [[noreturn]] static void fail(const StepTo& step, const std::string& why) {
    throw Breakdown(
        fmt::format("implicit Euler's step of {:.4g} s to load fraction {:.4g}: {}",
                    step.dt, step.load_fraction, why));
  }

  template <class Visit>
  void for_each_free(const Visit& visit) const {
    for (NodeIndex n = 0; n < load_.size(); ++n)
      for (int i = 0; i < 3; ++i)
        if (const Eigen::Index unknown = unknowns_.of(n, i); unknown >= 0)
          visit(n, i, unknown);
  }

  /// Adds to the free velocities; displacements follow.
  void move(const State& before, double dt, const Field& change) {
    for_each_free([&](NodeIndex n, int i, Eigen::Index unknown) {
      double& v = state_.velocities[n][i];
      v += change[unknown];
      state_.displacements[n][i] = before.displacements[n][i] + dt * v;
    });
  }

  void update_forces() {
    for (std::size_t n = 0; n < positions_.size(); ++n)
      positions_[n] = network_.rest_positions[n] + state_.displacements[n];
    nodal_forces(network_, positions_, cell_states_, forces_);
    if (damping_ratio_ > 0)
      add_dashpot_forces(network_, damping_ratio_, positions_, state_.velocities,
                         forces_);
  }

  /// dt (f + load) - M (v - v0); scale: norm of the two parts.
  Field residual_of(const State& before, const StepTo& step, double& scale) {
    update_forces();
    Field pushes(unknowns_.count()), momenta(unknowns_.count());
    for_each_free([&](NodeIndex n, int i, Eigen::Index unknown) {
      pushes[unknown] = step.dt * (forces_[n][i] + step.load_fraction * load_[n][i]);
      momenta[unknown] =
          network_.masses[n] * (state_.velocities[n][i] - before.velocities[n][i]);
    });
    // The forces on supports are what the free ones balance where nothing moves.
    double square = pushes.squaredNorm() + momenta.squaredNorm();
    for (const auto& [node, component, motion] : supports_)
      square += std::pow(step.dt * forces_[node][component], 2);
    scale = std::sqrt(square);
    return pushes - momenta;
  }

  /// (M + dt C + dt^2 K)^-1 residual.
  Field newton_step(const StepTo& step, const Field& residual) {
    const double dt = step.dt;
    const Tangent tangent = tangent_at(network_, positions_);
    if (!factor(part, tangent, dt) && !factor(positive_part, tangent, dt))
      fail(step, "its matrix is not positive definite");
    return cholesky_.solve(residual);
  }

  using PartOf = Eigen::MatrixXd(const Tangent&, std::size_t patch);
  bool factor(PartOf* part_of, const Tangent& tangent, double dt) {
    matrix_.assemble([&](std::size_t patch) { return part_of(tangent, patch); });
    stiffness_ = diagonal(matrix_, unknowns_).norm();
    matrix_.scale(dt * dt);
    for (NodeIndex n = 0; n < network_.masses.size(); ++n)
      matrix_.block(n, n).diagonal().array() += network_.masses[n];
    if (damping_ratio_ > 0) add_dashpots(dt);
    return cholesky_.factor(triangle_.copy_of(matrix_));
  }

  void add_dashpots(double dt) {
    for_each_dashpot(network_, [&](const Spring& spring) {
      const Vector3 d = positions_[spring.b] - positions_[spring.a];
      if (d.squaredNorm() == 0) return;
      const double c = dashpot_constant(network_, spring, damping_ratio_);
      const Matrix3 block = dt * c / d.squaredNorm() * d * d.transpose();
      for (const NodeIndex p : {spring.a, spring.b})
        for (const NodeIndex q : {spring.a, spring.b})
          matrix_.block(p, q) += (p == q ? 1 : -1) * block;
    });
  }

  [[nodiscard]] double network_reach() const {
    double reach = 0;
    for (const Vector3& x : positions_) reach = std::max(reach, x.cwiseAbs().maxCoeff());
    return reach;
  }

  const Network& network_;
  double damping_ratio_;
  std::vector<Vector3> load_;
  std::vector<dynamics::Support> supports_;
  statics::Unknowns unknowns_;
  statics::BlockMatrix matrix_;
  statics::FreeTriangle triangle_;
  State state_;
  std::vector<Vector3> positions_, forces_;
  CellStates cell_states_;
  double stiffness_ = 0;  // norm of the tangent's diagonal [N/m]
  SparseCholesky cholesky_;
};

}  // namespace

std::unique_ptr<dynamics::Motion> implicit_motion(const Mesh& mesh, const Scene& scene,
                                                  const Network& network,
                                                  double damping_ratio) {
  return std::make_unique<ImplicitMotion>(mesh, scene, network, damping_ratio);
}

}  // namespace springcheck::mss
