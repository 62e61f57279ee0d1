#include "dynamics/quasi_static/quasi_static.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "dynamics/quasi_static/equilibrium_search.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck::dynamics {
namespace {

constexpr int most_halvings = 6;     // of a step of time
constexpr double judged_parts = 20;  // of a way's time

/// The equilibria that the body has come through.
class Path {
 public:
  Path(const Mesh& mesh, const Scene& scene, RememberingBody& body)
      : mesh_(mesh),
        body_(body),
        search_(mesh, scene, body),
        positions_(mesh.nodes()),
        forces_(mesh.nodes().size(), Vector3::Zero()) {}

  /// Goes on to a load fraction in a time dt [s]. Returns whether there was an
  /// equilibrium.
  bool advance_to(double load_fraction, double dt) {
    auto found = search_.find({.dt = dt,
                               .load_fraction = load_fraction,
                               .start = positions_,
                               .starts_definite = is_definite_});
    jumped_ = !found && (jumped_ || search_.jumped());
    if (!found) return false;
    positions_ = std::move(found->positions);
    forces_ = body_.forces_after(dt, positions_).on_nodes;
    body_.advance(dt, positions_);
    is_definite_ = search_.is_definite(judged_step_, positions_) && found->is_definite;
    if ((!is_definite_ || found->met_saddle) && !definite_up_to_)
      definite_up_to_ = load_fraction_;
    largest_shear_strain_ =
        std::max(largest_shear_strain_, body_.largest_shear_strain(positions_));
    load_fraction_ = load_fraction;
    ++steps_;
    return true;
  }

  /// Sets the step [s] of the way that comes next, by which its states are judged.
  void set_judged_step(double dt) { judged_step_ = dt; }

  /// How the searches since the last equilibrium ended.
  [[nodiscard]] bool jumped() const { return jumped_; }
  [[nodiscard]] std::string failure() const {
    return jumped_
               ? "on another branch"
               : fmt::format("with a relative residual of {:.1e}", search_.residual());
  }

  [[nodiscard]] Moment moment(double time) const {
    Moment moment{.time = time,
                  .load_fraction = load_fraction_,
                  .step = steps_,
                  .displacements = positions_,
                  .reactions = std::vector<Vector3>(positions_.size(), Vector3::Zero()),
                  .lever_arms = LeverArms::deformed,
                  .kinetic_energy = 0,
                  .strain_energy = body_.free_energy(positions_)};
    for (std::size_t n = 0; n < positions_.size(); ++n)
      moment.displacements[n] -= mesh_.nodes()[n];
    for (const auto& [node, i, plate] : search_.prescribed())
      moment.reactions[node][i] =
          -(forces_[node][i] + load_fraction_ * search_.load()[node][i]);
    return moment;
  }

  [[nodiscard]] Solution solution(double setup_wall_s) const {
    const Moment now = moment(0);
    return {.status = is_definite_ ? SolveStatus::ok : SolveStatus::indefinite,
            .reason = stability(),
            .displacements = now.displacements,
            .reactions = now.reactions,
            .lever_arms = LeverArms::deformed,
            .strain_energy = now.strain_energy,
            .load_fraction = load_fraction_,
            .steps = steps_,
            .force_evaluations = search_.evaluations(),
            .definite_up_to = definite_up_to_,
            .factorisations = search_.factorisations(),
            .setup_wall_s = setup_wall_s,
            .largest_shear_strain = largest_shear_strain_};
  }

 private:
  [[nodiscard]] std::string stability() const {
    if (!definite_up_to_) return {};
    return fmt::format(
        "the tangent is not positive definite beyond {:.2f} % of the load{}",
        100 * *definite_up_to_, is_definite_ ? ", but is again at the end" : "");
  }

  const Mesh& mesh_;
  RememberingBody& body_;
  EquilibriumSearch search_;
  std::vector<Vector3> positions_;
  std::vector<Vector3> forces_;  // of the last equilibrium, without the load
  double load_fraction_ = 0, largest_shear_strain_ = 0;
  double judged_step_ = 0;  // [s]
  bool is_definite_ = true, jumped_ = false;
  std::optional<double> definite_up_to_;
  int steps_ = 0;
};

/// A straight piece of the load, in parts of 2^-most_halvings of a step, so that times
/// are met exactly.
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

/// Returns why the path ends on a piece of the load, or nothing where it does not.
std::string follow(Path& path, const Piece& piece, const Observers& observers) {
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
          "{} beyond {:.2f} % of the load, at {:.4g} s: the next {:.2g} s end {}",
          path.jumped() ? "no equilibrium found" : "not converged",
          100 * piece.fraction(now), piece.time(now), dt, path.failure());
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
                           const Observers& observers, const Stopwatch& setup) {
  assert(!settings.load.empty() && settings.steps > 0);
  Path path(mesh, scene, body);
  const double setup_wall_s = setup.seconds();
  std::string reason;
  LoadPoint from{.time = 0, .fraction = 0};
  const LoadPath ways = turning_points(settings.load);
  auto way = ways.begin();
  double way_begin = 0;
  for (const LoadPoint& to : settings.load) {
    if (to.time > way->time) way_begin = (way++)->time;
    path.set_judged_step((way->time - way_begin) / judged_parts);
    reason = follow(path, Piece(from, to, settings.steps), observers);
    if (!reason.empty()) break;
    from = to;
  }
  Solution solution = path.solution(setup_wall_s);
  if (!reason.empty()) {
    solution.status =
        path.jumped() ? SolveStatus::no_equilibrium : SolveStatus::not_converged;
    add_reason(reason, solution.reason);
    solution.reason = reason;
  }
  return solution;
}

}  // namespace springcheck::dynamics
