#include "dynamics/marching/quasi_static.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <string>

#include "meshing/stopwatch.hpp"

namespace springcheck::dynamics {
namespace {

using Eigen::Index;
using Positions = std::vector<Vector3>;
using Field = Eigen::VectorXd;  // an entry per free component, ascending

constexpr double relative_residual = 1e-9;
constexpr int most_iterations = 40;
constexpr double shortest_factor = 1. / 256;  // of a Newton step
constexpr int most_halvings = 6;              // of a step of time

class QuasiStatic {
 public:
  QuasiStatic(const Mesh& mesh, const Scene& scene, RememberingBody& body)
      : mesh_(mesh),
        scene_(scene),
        body_(body),
        prescribed_(prescribed_components(mesh, scene)),
        is_free_(free_components(mesh, prescribed_)),
        load_(body.load()),
        positions_(mesh.nodes()),
        forces_(mesh.nodes().size(), Vector3::Zero()) {}

  /// Goes on to a load fraction in a time dt [s]; whether there was an equilibrium.
  bool advance_to(double load_fraction, double dt) {
    Positions there;
    if (!find(dt, load_fraction, there)) return false;
    positions_ = std::move(there);
    forces_ = body_.forces_after(dt, positions_);
    body_.advance(dt, positions_);
    largest_shear_strain_ =
        std::max(largest_shear_strain_, body_.largest_shear_strain(positions_));
    load_fraction_ = load_fraction;
    ++steps_;
    return true;
  }

  [[nodiscard]] double residual() const { return residual_; }

  [[nodiscard]] Moment moment(double time) const {
    Moment moment{.time = time,
                  .load_fraction = load_fraction_,
                  .step = steps_,
                  .displacements = positions_,
                  .reactions = Positions(positions_.size(), Vector3::Zero()),
                  .kinetic_energy = 0,
                  .strain_energy = body_.free_energy(positions_)};
    for (std::size_t n = 0; n < positions_.size(); ++n)
      moment.displacements[n] -= mesh_.nodes()[n];
    for (const auto& [node, i, plate] : prescribed_)
      moment.reactions[node][i] = -(forces_[node][i] + load_fraction_ * load_[node][i]);
    return moment;
  }

  [[nodiscard]] Solution solution() const {
    const Moment now = moment(0);
    return {.status = SolveStatus::ok,
            .displacements = now.displacements,
            .reactions = now.reactions,
            .lever_arms = LeverArms::deformed,
            .strain_energy = now.strain_energy,
            .load_fraction = load_fraction_,
            .steps = steps_,
            .force_evaluations = evaluations_,
            .factorisations = body_.factorisations(),
            .largest_shear_strain = largest_shear_strain_};
  }

 private:
  [[nodiscard]] Field on_free(const std::vector<Vector3>& all) const {
    Field field(static_cast<Index>(std::ranges::count(is_free_, true)));
    Index unknown = 0;
    for (std::size_t i = 0; i < is_free_.size(); ++i)
      if (is_free_[i]) field[unknown++] = all[i / 3][static_cast<Index>(i % 3)];
    return field;
  }

  [[nodiscard]] Positions moved(Positions x, const Field& by, double factor) const {
    Index unknown = 0;
    for (std::size_t i = 0; i < is_free_.size(); ++i)
      if (is_free_[i]) x[i / 3][static_cast<Index>(i % 3)] += factor * by[unknown++];
    return x;
  }

  /// Forces on the nodes with the load [N].
  std::vector<Vector3> forces(double dt, const Positions& x, double load_fraction) {
    ++evaluations_;
    std::vector<Vector3> sum = body_.forces_after(dt, x);
    for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += load_fraction * load_[n];
    return sum;
  }

  /// An equilibrium at the end of the step, into `there`.
  bool find(double dt, double load_fraction, Positions& there) {
    std::vector<Vector3> way(positions_.size(), Vector3::Zero());
    for (const PrescribedComponent& component : prescribed_)
      way[component.node][component.component] =
          mesh_.nodes()[component.node][component.component] +
          prescribed_displacement(mesh_, scene_, component, load_fraction) -
          positions_[component.node][component.component];
    std::vector<Vector3> f = forces(dt, positions_, load_fraction);
    body_.linearise(dt, positions_);
    const std::vector<Vector3> of_way = body_.stiffness_times(way);
    for (std::size_t n = 0; n < f.size(); ++n) f[n] -= of_way[n];
    there = moved(positions_, body_.solve(on_free(f)), 1);
    for (std::size_t n = 0; n < way.size(); ++n) there[n] += way[n];

    Field residual = on_free(forces(dt, there, load_fraction));
    for (int i = 0; i < most_iterations; ++i) {
      const double norm = residual.norm(), scale = body_.force_scale();
      residual_ = norm / scale;
      spdlog::debug("load {:.5f}, iteration {}: residual {:.2e}", load_fraction, i,
                    residual_);
      if (!std::isfinite(norm)) return false;
      if (norm <= relative_residual * scale) return true;
      body_.linearise(dt, there);
      const Field change = body_.solve(residual);
      const Positions here = there;
      // What is not a number is not nearer.
      for (double factor = 1;; factor /= 2) {
        there = moved(here, change, factor);
        residual = on_free(forces(dt, there, load_fraction));
        if (residual.norm() < norm) break;
        if (factor < shortest_factor) return false;
      }
    }
    return false;
  }

  const Mesh& mesh_;
  const Scene& scene_;
  RememberingBody& body_;
  std::vector<PrescribedComponent> prescribed_;
  std::vector<bool> is_free_;
  std::vector<Vector3> load_;  // [N] at the full load
  Positions positions_;
  std::vector<Vector3> forces_;  // of the last equilibrium, without the load
  double residual_ = 0, load_fraction_ = 0, largest_shear_strain_ = 0;
  int steps_ = 0, evaluations_ = 0;
};

/// A straight piece of the load, in parts of a step, 2^-most_halvings of it, so that
/// times are met to the bit.
class Piece {
 public:
  Piece(const LoadPoint& from, const LoadPoint& to, int steps)
      : from_(from), to_(to), end_(std::int64_t{steps} * parts) {}

  static constexpr int parts = 1 << most_halvings;

  [[nodiscard]] std::int64_t end() const { return end_; }
  [[nodiscard]] double passed(std::int64_t part) const {
    return static_cast<double>(part) / static_cast<double>(end_);
  }
  [[nodiscard]] double time(std::int64_t part) const {
    return std::lerp(from_.time, to_.time, passed(part));
  }
  [[nodiscard]] double fraction(std::int64_t part) const {
    return std::lerp(from_.fraction, to_.fraction, passed(part));
  }

 private:
  LoadPoint from_, to_;
  std::int64_t end_;
};

/// Why the path ends on a piece of the load; nothing where it does not.
std::string follow(QuasiStatic& path, const Piece& piece, const Observers& observers) {
  const auto samples_passed = [&](std::int64_t part) {
    return std::floor(piece.passed(part) * observers.samples + 1e-9);
  };
  std::int64_t now = 0, length = Piece::parts;
  while (now < piece.end()) {
    const std::int64_t next =
        std::min(now + length, (now / Piece::parts + 1) * Piece::parts);
    const double dt = piece.time(next) - piece.time(now);
    if (!path.advance_to(piece.fraction(next), dt)) {
      length = (next - now) / 2;
      if (length > 0) continue;
      return fmt::format(
          "not converged beyond {:.2f} % of the load, at {:.4g} s: the next {:.2g} s end "
          "with a relative residual of {:.1e}",
          100 * piece.fraction(now), piece.time(now), dt, path.residual());
    }
    if (observers.sample &&
        (next == piece.end() || samples_passed(next) > samples_passed(now)))
      observers.sample(path.moment(piece.time(next)));
    now = next;
    length = std::min<std::int64_t>(2 * length, Piece::parts);
  }
  return {};
}

}  // namespace

Solution find_quasi_static(const Mesh& mesh, const Scene& scene, RememberingBody& body,
                           const QuasiStaticSettings& settings,
                           const Observers& observers) {
  assert(!settings.load.empty() && settings.steps > 0);
  const Stopwatch stopwatch;
  QuasiStatic path(mesh, scene, body);
  const double setup_wall_s = stopwatch.seconds();
  std::string reason;
  LoadPoint from{.time = 0, .fraction = 0};
  for (const LoadPoint& to : settings.load) {
    reason = follow(path, Piece(from, to, settings.steps), observers);
    if (!reason.empty()) break;
    from = to;
  }
  Solution solution = path.solution();
  solution.setup_wall_s = setup_wall_s;
  if (!reason.empty()) {
    solution.status = SolveStatus::not_converged;
    solution.reason = reason;
  }
  return solution;
}

}  // namespace springcheck::dynamics
