#include "dynamics/marching/quasi_static.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "meshing/random_vector.hpp"
#include "meshing/stopwatch.hpp"
#include "meshing/turn.hpp"

namespace springcheck::dynamics {
namespace {

using Eigen::Index;
using Positions = std::vector<Vector3>;
using Field = Eigen::VectorXd;  // an entry per free component, ascending

constexpr double relative_residual = 1e-9;
constexpr int most_iterations = 100;          // a body that buckles takes many
constexpr double shortest_factor = 1. / 256;  // of a Newton step
constexpr int most_halvings = 6;              // of a step of time
constexpr int most_escapes = 5;               // from saddles, in a step of time
constexpr double near_saddle = 1e-3;          // relative residual
constexpr double first_escape = 0.01;         // along the softest mode, in cell edges
constexpr double longest_move = 0.5;  // of a node where it is not stable, in cell edges
// Change of the displacement gradient after the prediction, past an unstable state:
constexpr double jump = 0.5;
constexpr double judged_parts = 20;  // of a way's time
constexpr unsigned seed = 1;  // of where iterations start that end at the same place

class QuasiStatic {
 public:
  QuasiStatic(const Mesh& mesh, const Scene& scene, RememberingBody& body)
      : mesh_(mesh),
        scene_(scene),
        body_(body),
        prescribed_(prescribed_components(mesh, scene)),
        is_free_(free_components(mesh, prescribed_)),
        load_(body.load()),
        cell_edge_(mesh.mean_cell_edge()),
        positions_(mesh.nodes()),
        forces_(mesh.nodes().size(), Vector3::Zero()) {}

  /// Goes on to a load fraction in a time dt [s]; whether there was an equilibrium.
  bool advance_to(double load_fraction, double dt) {
    auto found = find(dt, load_fraction);
    if (!found) return false;
    if (!shows_imposed_turn(mesh_, scene_, found->positions, load_fraction)) {
      jumped_ = true;
      return false;
    }
    jumped_ = false;
    positions_ = std::move(found->positions);
    forces_ = body_.forces_after(dt, positions_);
    body_.advance(dt, positions_);
    body_.forces_after(judged_step_, positions_);
    is_definite_ = body_.linearise(judged_step_, positions_) && found->is_definite;
    if ((!is_definite_ || found->met_saddle) && !definite_up_to_)
      definite_up_to_ = load_fraction_;
    largest_shear_strain_ =
        std::max(largest_shear_strain_, body_.largest_shear_strain(positions_));
    load_fraction_ = load_fraction;
    ++steps_;
    return true;
  }

  /// Of the way that comes next, by which its states are judged.
  void set_judged_step(double dt) { judged_step_ = dt; }

  /// How the searches since the last equilibrium ended.
  [[nodiscard]] bool jumped() const { return jumped_; }
  [[nodiscard]] std::string failure() const {
    return jumped_ ? "on another branch"
                   : fmt::format("with a relative residual of {:.1e}", residual_);
  }

  [[nodiscard]] Moment moment(double time) const {
    Moment moment{.time = time,
                  .load_fraction = load_fraction_,
                  .step = steps_,
                  .displacements = positions_,
                  .reactions = Positions(positions_.size(), Vector3::Zero()),
                  .lever_arms = LeverArms::deformed,
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
    return {.status = is_definite_ ? SolveStatus::ok : SolveStatus::indefinite,
            .reason = stability(),
            .displacements = now.displacements,
            .reactions = now.reactions,
            .lever_arms = LeverArms::deformed,
            .strain_energy = now.strain_energy,
            .load_fraction = load_fraction_,
            .steps = steps_,
            .force_evaluations = evaluations_,
            .definite_up_to = definite_up_to_,
            .factorisations = body_.factorisations(),
            .largest_shear_strain = largest_shear_strain_};
  }

 private:
  struct Equilibrium {
    Positions positions;
    bool is_definite, met_saddle;
  };

  [[nodiscard]] std::string stability() const {
    if (!definite_up_to_) return {};
    return fmt::format(
        "the tangent is not positive definite beyond {:.2f} % of the load{}",
        100 * *definite_up_to_, is_definite_ ? ", but is again at the end" : "");
  }

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

  /// The state that the tangent predicts at the end of the step.
  Positions predicted(double dt, double load_fraction) {
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
    Positions there = moved(positions_, body_.solve(on_free(f)), 1);
    for (std::size_t n = 0; n < way.size(); ++n) there[n] += way[n];
    return there;
  }

  /// The longest way of a node where free components move by `change` [m].
  [[nodiscard]] double longest_way(const Field& change) const {
    const Positions none(positions_.size(), Vector3::Zero());
    double longest = 0;
    for (const Vector3& way : moved(none, change, 1))
      longest = std::max(longest, way.norm());
    return longest;
  }

  /// What least resists in the tangent taken last, by inverse iteration; it moves a node
  /// by a cell edge.
  [[nodiscard]] Field softest_mode() {
    std::mt19937_64 random(seed);
    const auto unknowns = static_cast<Index>(std::ranges::count(is_free_, true));
    Field mode = random_vector(unknowns, random);
    constexpr int iterations = 30;
    for (int i = 0; i < iterations; ++i) mode = body_.solve(mode).normalized();
    return mode * (cell_edge_ / longest_way(mode));
  }

  /// Leaves a saddle along the softest mode, with the forces where they point along it
  /// and are more than round-off, by steps that double while the forces push on; whether
  /// they do at all.
  bool leave_saddle(double dt, double load_fraction, Positions& there, Field& residual) {
    Field mode = softest_mode();
    if (residual_ > relative_residual && residual.dot(mode) < 0) mode = -mode;
    bool left = false;
    for (double way = first_escape; way <= longest_move; way *= 2) {
      Positions further = moved(there, mode, way);
      if (!(on_free(forces(dt, further, load_fraction)).dot(mode) > 0)) break;
      there = std::move(further);
      left = true;
    }
    residual = on_free(forces(dt, there, load_fraction));
    return left;
  }

  /// Goes on from `there` by the change, or a part of it; whether that leads nearer to an
  /// equilibrium: the residual falls. Where a body buckles it has to rise on the way, in
  /// a valley that bends; there the forces must not turn against the change. What is not
  /// a number is not nearer.
  bool step(double dt, double load_fraction, bool buckles, Field change, Positions& there,
            Field& residual) {
    const double norm = residual.norm();
    if (buckles) change *= std::min(1., longest_move * cell_edge_ / longest_way(change));
    const double work = residual.dot(change);
    const Positions here = there;
    for (double factor = 1; factor >= shortest_factor; factor /= 2) {
      there = moved(here, change, factor);
      residual = on_free(forces(dt, there, load_fraction));
      if (buckles ? residual.dot(change) > -work / 2 : residual.norm() < norm)
        return true;
    }
    return false;
  }

  /// The largest change of the distance between two nodes of a cell, as a vector, over
  /// that distance at rest: of a displacement gradient between two states.
  [[nodiscard]] double largest_gradient(const Positions& from,
                                        const Positions& to) const {
    double largest = 0;
    for (const CellNodes& cell : mesh_.cells()) {
      const NodeIndex a = cell[0];
      for (const NodeIndex b : cell)
        if (b != a)
          largest = std::max(largest, (to[b] - to[a] - (from[b] - from[a])).norm() /
                                          (mesh_.nodes()[b] - mesh_.nodes()[a]).norm());
    }
    return largest;
  }

  /// An equilibrium at the end of the step: a stable one where it is found from a saddle.
  std::optional<Equilibrium> find(double dt, double load_fraction) {
    const Positions start = predicted(dt, load_fraction);
    Positions there = start;
    Field residual = on_free(forces(dt, there, load_fraction));
    std::optional<Equilibrium> saddle;
    int escapes = 0;
    bool crossed = false;
    for (int i = 0; i < most_iterations; ++i) {
      const double norm = residual.norm(), scale = body_.force_scale();
      residual_ = norm / scale;
      if (!std::isfinite(norm)) break;
      const bool is_definite = body_.linearise(dt, there);
      spdlog::debug("load {:.5f}, iteration {}: residual {:.2e}{}", load_fraction, i,
                    residual_, is_definite ? "" : ", indefinite");
      const bool is_found = norm <= relative_residual * scale;
      crossed = crossed || !is_definite;
      if (is_found && is_definite) {
        if (crossed && largest_gradient(start, there) > jump) {
          jumped_ = true;
          return std::nullopt;
        }
        return Equilibrium{std::move(there), true, saddle.has_value()};
      }
      if (is_found && !saddle) saddle = {there, false, true};
      // Near a saddle the tangent, made definite, hardly moves along the unstable mode.
      const bool is_buckling = saddle || !is_definite_;
      if (!is_definite && (is_found || (is_buckling && residual_ < near_saddle)) &&
          escapes++ < most_escapes && leave_saddle(dt, load_fraction, there, residual))
        continue;
      if (is_found || !step(dt, load_fraction, is_buckling || !is_definite,
                            body_.solve(residual), there, residual))
        break;
    }
    return saddle;
  }

  const Mesh& mesh_;
  const Scene& scene_;
  RememberingBody& body_;
  std::vector<PrescribedComponent> prescribed_;
  std::vector<bool> is_free_;
  std::vector<Vector3> load_;  // [N] at the full load
  double cell_edge_;           // [m] mean
  Positions positions_;
  std::vector<Vector3> forces_;  // of the last equilibrium, without the load
  double residual_ = 0, load_fraction_ = 0, largest_shear_strain_ = 0;
  double judged_step_ = 0;  // [s]
  bool is_definite_ = true, jumped_ = false;
  std::optional<double> definite_up_to_;
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
                           const Observers& observers) {
  assert(!settings.load.empty() && settings.steps > 0);
  const Stopwatch stopwatch;
  QuasiStatic path(mesh, scene, body);
  const double setup_wall_s = stopwatch.seconds();
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
  Solution solution = path.solution();
  solution.setup_wall_s = setup_wall_s;
  if (!reason.empty()) {
    solution.status =
        path.jumped() ? SolveStatus::no_equilibrium : SolveStatus::not_converged;
    solution.reason = reason + (solution.reason.empty() ? "" : "; ") + solution.reason;
  }
  return solution;
}

}  // namespace springcheck::dynamics
