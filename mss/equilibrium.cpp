#include "mss/equilibrium.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <Eigen/CholmodSupport>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "mss/cell.hpp"
#include "mss/forces.hpp"
#include "mss/tangent.hpp"

namespace springcheck::mss {
namespace {

constexpr double relative_residual = 1e-10;
constexpr int newton_limit = 150;
constexpr int inverse_iterations = 12;
constexpr double smallest_load_step = 1. / 1024;
constexpr double gradient_per_step = 0.06;  // see Landscape::gradient
constexpr double largest_move = 0.5;        // of a node in one iteration, in cell edges
constexpr double runaway_volume_ratio = 4;  // a cell this large has no way back
constexpr double near_saddle = 1e-3;        // relative residual
constexpr double first_escape = 1e-3;       // along negative curvature, in cell edges

using Positions = std::vector<Vector3>;

/// The energy landscape over the free nodes and its Cholesky factor.
class Landscape {
 public:
  Landscape(const Mesh& mesh, const Scene& scene, const Network& network)
      : scene_(scene),
        network_(network),
        prescribed_(prescribed_nodes(mesh, scene)),
        assembly_(network, free_nodes(mesh, prescribed_)),
        cell_edge_(
            std::cbrt(mesh.volume() / static_cast<double>(mesh.hexahedra().size()))),
        forces_(mesh.nodes().size()) {
    stiffness_ = assembly_.assemble(cell_tangents(network, network.rest_positions))
                     .diagonal()
                     .norm();
  }

  [[nodiscard]] double cell_edge() const { return cell_edge_; }
  [[nodiscard]] int evaluations() const { return evaluations_; }
  [[nodiscard]] const std::vector<PrescribedNode>& prescribed() const {
    return prescribed_;
  }
  [[nodiscard]] bool is_free(NodeIndex node) const {
    return assembly_.unknown(node) >= 0;
  }

  void set_load(double load_fraction) { load_fraction_ = load_fraction; }

  /// Total energy: strain energy minus the work of gravity.
  [[nodiscard]] double energy(const Positions& x) const {
    double total = strain_energy(network_, x);
    for (std::size_t n = 0; n < x.size(); ++n)
      total -= load_fraction_ * network_.masses[n] *
               scene_.gravity.dot(x[n] - network_.rest_positions[n]);
    return total;
  }

  /// Forces of springs, correction and gravity on every node.
  const std::vector<Vector3>& forces(const Positions& x) {
    nodal_forces(network_, x, forces_);
    ++evaluations_;
    for (std::size_t n = 0; n < x.size(); ++n)
      forces_[n] += load_fraction_ * network_.masses[n] * scene_.gravity;
    return forces_;
  }

  /// What the rounding of the positions x does to the forces' norm [N] and, at the given
  /// energy, to the energy [J]. A body that is hardly strained has little else.
  [[nodiscard]] double force_round_off(const Positions& x) const {
    double reach = 0;
    for (const Vector3& place : x) reach = std::max(reach, place.cwiseAbs().maxCoeff());
    return std::numeric_limits<double>::epsilon() * stiffness_ * reach;
  }
  [[nodiscard]] double energy_round_off(const Positions& x, double energy) const {
    return 1e-13 * std::abs(energy) +
           force_round_off(x) * std::sqrt(2 * std::abs(energy) / stiffness_);
  }

  [[nodiscard]] Eigen::VectorXd on_free(const std::vector<Vector3>& all) const {
    Eigen::VectorXd values(assembly_.size());
    for (NodeIndex n = 0; n < all.size(); ++n)
      if (is_free(n)) values.segment<3>(assembly_.unknown(n)) = all[n];
    return values;
  }

  [[nodiscard]] Positions moved(const Positions& x, const Eigen::VectorXd& by,
                                double factor) const {
    Positions y = x;
    for (NodeIndex n = 0; n < x.size(); ++n)
      if (is_free(n)) y[n] += factor * by.segment<3>(assembly_.unknown(n));
    return y;
  }

  /// Factors the true tangent at x; false when it is not positive definite.
  bool factor(const Positions& x) {
    tangents_ = cell_tangents(network_, x);
    return factor_matrix(assembly_.assemble(tangents_));
  }

  /// Factors the clamped tangent of the last factor(); shifted when that is singular.
  void factor_clamped() {
    clamp_to_positive(tangents_);
    factor_shifted(assembly_.assemble(tangents_));
  }

  /// Unit vector of the most negative curvature of the last factor()'s tangent, which
  /// must not be positive definite: inverse iteration on the tangent shifted just far
  /// enough. Points downhill.
  [[nodiscard]] Eigen::VectorXd negative_curvature(const Eigen::VectorXd& downhill,
                                                   std::mt19937_64& random) {
    factor_shifted(assembly_.assemble(tangents_));
    Eigen::VectorXd v(assembly_.size());
    for (double& component : v)
      component = 2 * static_cast<double>(random() >> 11U) * 0x1p-53 - 1;
    for (int i = 0; i < inverse_iterations; ++i) v = solve(v).normalized();
    return downhill.dot(v) < 0 ? Eigen::VectorXd(-v) : v;
  }

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) {
    return cholesky_.solve(right);
  }

  /// Prescribed increments from x to load fraction `to`, and the free nodes' first-order
  /// answer to them through the tangent factored last (which must be the true one).
  Positions predicted(const Positions& x, double to) {
    std::vector<Vector3> increment(x.size(), Vector3::Zero());
    for (const auto& [node, plate] : prescribed_) {
      const Vector3& rest = network_.rest_positions[node];
      increment[node] =
          rest + displacement(scene_.plates[plate].motion, rest, to) - x[node];
    }
    std::vector<Vector3> push(x.size(), Vector3::Zero());
    for (std::size_t c = 0; c < network_.cells.size(); ++c) {
      const Hexahedron& nodes = network_.cells[c].nodes;
      Eigen::Matrix<double, 24, 1> cell_increment;
      for (std::size_t i = 0; i < 8; ++i)
        cell_increment.segment<3>(static_cast<Eigen::Index>(3 * i)) = increment[nodes[i]];
      if (cell_increment.isZero(0)) continue;
      const Eigen::Matrix<double, 24, 1> answer = tangents_[c] * cell_increment;
      for (std::size_t i = 0; i < 8; ++i)
        push[nodes[i]] -= answer.segment<3>(static_cast<Eigen::Index>(3 * i));
    }
    for (NodeIndex n = 0; n < x.size(); ++n)
      push[n] += (to - load_fraction_) * network_.masses[n] * scene_.gravity;
    Positions y = moved(x, solve(on_free(push)), 1);
    for (const auto& [node, plate] : prescribed_) y[node] = x[node] + increment[node];
    return y;
  }

  /// Root mean square over the springs of |change of d|/L: about the displacement
  /// gradient between two states.
  [[nodiscard]] double gradient(const Positions& from, const Positions& to) const {
    double sum = 0;
    for (const Spring& spring : network_.springs) {
      const Vector3 change =
          to[spring.b] - to[spring.a] - (from[spring.b] - from[spring.a]);
      sum += change.squaredNorm() / (spring.rest_length * spring.rest_length);
    }
    return std::sqrt(sum / static_cast<double>(network_.springs.size()));
  }

  [[nodiscard]] bool runs_away(const Positions& x) const {
    return std::ranges::any_of(network_.cells, [&](const Cell& cell) {
      return mean_edge_volume(corners(cell.nodes, x)) >
             runaway_volume_ratio * cell.rest_volume;
    });
  }

 private:
  static std::vector<bool> free_nodes(const Mesh& mesh,
                                      const std::vector<PrescribedNode>& prescribed) {
    std::vector<bool> is_free(mesh.nodes().size(), true);
    for (const auto& [node, plate] : prescribed) is_free[node] = false;
    return is_free;
  }

  bool factor_matrix(const Eigen::SparseMatrix<double>& matrix) {
    if (!analysed_) {
      cholesky_.cholmod().print =
          0;  // a failed factorisation is an answer, not a warning
      cholesky_.analyzePattern(matrix);
      analysed_ = true;
    }
    cholesky_.factorize(matrix);
    return cholesky_.info() == Eigen::Success;
  }

  /// Factors the matrix plus the smallest of a series of multiples of the identity that
  /// makes it positive definite.
  void factor_shifted(Eigen::SparseMatrix<double> matrix) {
    const double scale = matrix.diagonal().cwiseAbs().maxCoeff();
    for (double shift = 0; !factor_matrix(matrix);) {
      const double next = shift == 0 ? 1e-8 * scale : 4 * shift;
      matrix.diagonal().array() += next - shift;
      shift = next;
    }
  }

  const Scene& scene_;
  const Network& network_;
  std::vector<PrescribedNode> prescribed_;
  FreeAssembly assembly_;
  double cell_edge_;
  double stiffness_;  // norm of the tangent's diagonal at rest [N/m]
  std::vector<Vector3> forces_;
  std::vector<CellMatrix> tangents_;
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky_;
  bool analysed_ = false;
  double load_fraction_ = 0;
  int evaluations_ = 0;
};

struct Minimum {
  Positions positions;
  bool found;
  bool definite;        // the true tangent there; its factor is in the landscape
  bool met_indefinite;  // the tangent was indefinite somewhere on the way
  double residual;      // relative
};

double norm(const std::vector<Vector3>& vectors) {
  double sum = 0;
  for (const Vector3& v : vectors) sum += v.squaredNorm();
  return std::sqrt(sum);
}

double longest_move(const Eigen::VectorXd& step) {
  return std::sqrt(step.reshaped(3, step.size() / 3).colwise().squaredNorm().maxCoeff());
}

/// Moves x along the direction of negative curvature, doubling the step while the energy
/// falls. False when it falls nowhere: the curvature is zero to round-off.
bool leave_saddle(Landscape& landscape, Positions& x, double& energy,
                  const Eigen::VectorXd& downhill, std::mt19937_64& random) {
  Eigen::VectorXd direction = landscape.negative_curvature(downhill, random);
  direction *= landscape.cell_edge() / longest_move(direction);
  bool fell = false;
  for (double step = first_escape; step <= largest_move; step *= 2) {
    Positions trial = landscape.moved(x, direction, step);
    const double trial_energy = landscape.energy(trial);
    if (trial_energy >= energy) break;
    x = std::move(trial);
    energy = trial_energy;
    fell = true;
  }
  return fell;
}

/// Newton's method from x at fixed load; see find_equilibrium.
Minimum minimise(Landscape& landscape, Positions x, std::mt19937_64& random) {
  Minimum minimum{.positions = std::move(x),
                  .found = false,
                  .definite = false,
                  .met_indefinite = false,
                  .residual = INFINITY};
  Positions& now = minimum.positions;
  double energy = landscape.energy(now);
  for (int iteration = 0; iteration < newton_limit; ++iteration) {
    const std::vector<Vector3>& forces = landscape.forces(now);
    const Eigen::VectorXd downhill = landscape.on_free(forces);
    const double scale =
        std::max(norm(forces), landscape.force_round_off(now) / relative_residual);
    minimum.residual = downhill.norm() / scale;
    if (!std::isfinite(minimum.residual) || landscape.runs_away(now)) return minimum;
    minimum.definite = landscape.factor(now);
    minimum.met_indefinite |= !minimum.definite;
    spdlog::debug("  newton {}: energy {:.9e}, residual {:.2e}{}", iteration, energy,
                  minimum.residual, minimum.definite ? "" : ", indefinite");
    minimum.found = minimum.residual < relative_residual;
    if (minimum.found && minimum.definite) return minimum;

    // Near a saddle the clamped tangent hardly moves along the unstable direction.
    if (!minimum.definite && minimum.residual < near_saddle) {
      const bool left = leave_saddle(landscape, now, energy, downhill, random);
      if (left) continue;
      if (minimum.found) return minimum;
      landscape.factor(now);
    }
    if (!minimum.definite) landscape.factor_clamped();
    Eigen::VectorXd direction = landscape.solve(downhill);
    direction *=
        std::min(1., largest_move * landscape.cell_edge() / longest_move(direction));
    const double slope = downhill.dot(direction);
    // Energy differences below round-off cannot be judged; the residual then decides.
    const double round_off = landscape.energy_round_off(now, energy);
    double factor = 1;
    Positions trial = landscape.moved(now, direction, factor);
    double trial_energy = landscape.energy(trial);
    while (!(trial_energy <= energy - 1e-4 * factor * slope + round_off)) {
      factor /= 2;
      if (factor < 1e-8) return minimum;
      trial = landscape.moved(now, direction, factor);
      trial_energy = landscape.energy(trial);
    }
    now = std::move(trial);
    energy = trial_energy;
  }
  minimum.found = false;
  return minimum;
}

}  // namespace

Solution find_equilibrium(const Mesh& mesh, const Scene& scene, const Network& network,
                          unsigned seed) {
  Landscape landscape(mesh, scene, network);
  std::mt19937_64 random(seed);
  Positions x = mesh.nodes();
  double reached = 0;
  int steps = 0;
  SolveStatus status = SolveStatus::ok;
  std::string reason;

  bool definite = landscape.factor(x);
  if (!definite) landscape.factor_clamped();
  const double whole_gradient = landscape.gradient(x, landscape.predicted(x, 1));
  const double largest_step =
      whole_gradient > gradient_per_step ? gradient_per_step / whole_gradient : 1;
  double step = largest_step;
  while (reached < 1) {
    // The last step may be a little longer, not a sliver.
    const double to = reached + 1.05 * step > 1 ? 1 : reached + step;
    if (!definite) {
      landscape.factor(x);
      landscape.factor_clamped();
    }
    landscape.set_load(reached);
    Positions start = landscape.predicted(x, to);
    landscape.set_load(to);
    Minimum minimum = minimise(landscape, std::move(start), random);
    spdlog::debug("load {:.5f}: {}, residual {:.2e}", to,
                  minimum.found ? (minimum.definite ? "minimum" : "saddle") : "none",
                  minimum.residual);
    if (minimum.found) {
      x = std::move(minimum.positions);
      definite = minimum.definite;
      reached = to;
      ++steps;
      step = std::min(largest_step, 2 * step);
      continue;
    }
    step = (to - reached) / 2;
    if (step < smallest_load_step) {
      status = minimum.met_indefinite ? SolveStatus::no_equilibrium
                                      : SolveStatus::not_converged;
      reason = fmt::format(
          "{} beyond {:.2f} % of the load: the next step of {:.2g} % ends with relative "
          "residual {:.1e}{}",
          minimum.met_indefinite ? "no equilibrium found" : "not converged",
          100 * reached, 200 * step, minimum.residual,
          minimum.met_indefinite ? ", its tangent not positive definite" : "");
      break;
    }
    definite = landscape.factor(x);
  }
  if (status == SolveStatus::ok && !definite) {
    status = SolveStatus::indefinite;
    reason = "the tangent is not positive definite and no direction lowers the energy";
  }

  landscape.set_load(reached);
  const std::vector<Vector3>& forces = landscape.forces(x);
  Solution solution{.status = status,
                    .reason = reason,
                    .displacements = {},
                    .reactions = std::vector<Vector3>(x.size(), Vector3::Zero()),
                    .lever_arms = LeverArms::deformed,
                    .strain_energy = strain_energy(network, x),
                    .load_fraction = reached,
                    .steps = steps,
                    .force_evaluations = landscape.evaluations()};
  for (std::size_t n = 0; n < x.size(); ++n)
    solution.displacements.push_back(x[n] - mesh.nodes()[n]);
  for (const auto& [node, plate] : landscape.prescribed())
    solution.reactions[node] = -forces[node];
  return solution;
}

}  // namespace springcheck::mss
