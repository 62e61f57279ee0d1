#include "dynamics/quasi_static/equilibrium_search.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "meshing/basics/random_vector.hpp"
#include "meshing/loads/turn.hpp"

namespace springcheck::dynamics {
namespace {

using Eigen::Index;

constexpr double relative_residual = 1e-9;
constexpr int most_iterations = 100;          // a body that buckles takes many
constexpr double shortest_factor = 1. / 256;  // of a Newton step
constexpr int most_escapes = 5;               // from saddles, in a step of time
constexpr double near_saddle = 1e-3;          // relative residual
constexpr double first_escape = 0.01;         // along the softest mode, in cell edges
constexpr double longest_move = 0.5;  // of a node where it is not stable, in cell edges
// Change of the displacement gradient after the prediction, past an unstable state:
constexpr double jump = 0.5;
constexpr unsigned seed = 1;  // of where iterations start that end at the same place

}  // namespace

EquilibriumSearch::EquilibriumSearch(const Mesh& mesh, const Scene& scene,
                                     RememberingBody& body)
    : mesh_(mesh),
      scene_(scene),
      body_(body),
      prescribed_(prescribed_components(mesh, scene)),
      is_free_(free_components(mesh, prescribed_)),
      load_(body.load()),
      cell_edge_(mesh.mean_cell_edge()),
      system_(mesh.nodes(), body.patches(), is_free_, statics::LinearSolver::direct) {}

EquilibriumSearch::Field EquilibriumSearch::on_free(
    const std::vector<Vector3>& all) const {
  Field field(static_cast<Index>(std::ranges::count(is_free_, true)));
  Index unknown = 0;
  for (std::size_t i = 0; i < is_free_.size(); ++i)
    if (is_free_[i]) field[unknown++] = all[i / 3][static_cast<Index>(i % 3)];
  return field;
}

EquilibriumSearch::Positions EquilibriumSearch::moved(Positions x, const Field& by,
                                                      double factor) const {
  Index unknown = 0;
  for (std::size_t i = 0; i < is_free_.size(); ++i)
    if (is_free_[i]) x[i / 3][static_cast<Index>(i % 3)] += factor * by[unknown++];
  return x;
}

/// Forces on the nodes with the load [N].
std::vector<Vector3> EquilibriumSearch::forces(double dt, const Positions& x,
                                               double load_fraction) {
  ++evaluations_;
  auto [sum, scale] = body_.forces_after(dt, x);
  force_scale_ = scale;
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += load_fraction * load_[n];
  return sum;
}

/// Takes the tangent, shifted until it is positive definite. Returns whether it was
/// before.
bool EquilibriumSearch::linearise(double dt, std::span<const Vector3> positions) {
  body_.assemble_tangent(dt, positions, system_.matrix());
  return prepare_shifted(system_);
}

bool EquilibriumSearch::is_definite(double dt, std::span<const Vector3> positions) {
  (void)body_.forces_after(dt, positions);
  return linearise(dt, positions);
}

EquilibriumSearch::Field EquilibriumSearch::solve(const Field& forces) {
  return system_.solve(forces, 0).value();
}

/// The state that the tangent predicts at the end of the step.
EquilibriumSearch::Positions EquilibriumSearch::predicted(
    const SoughtEquilibrium& sought) {
  const Positions start(sought.start.begin(), sought.start.end());
  std::vector<Vector3> way(start.size(), Vector3::Zero());
  for (const PrescribedComponent& component : prescribed_)
    way[component.node][component.component] =
        mesh_.nodes()[component.node][component.component] +
        prescribed_displacement(mesh_, scene_, component, sought.load_fraction) -
        start[component.node][component.component];
  std::vector<Vector3> f = forces(sought.dt, start, sought.load_fraction);
  linearise(sought.dt, start);
  const std::vector<Vector3> of_way = product(system_.matrix(), way);
  for (std::size_t n = 0; n < f.size(); ++n) f[n] -= of_way[n];
  Positions there = moved(start, solve(on_free(f)), 1);
  for (std::size_t n = 0; n < way.size(); ++n) there[n] += way[n];
  return there;
}

/// The longest way of a node where free components move by `change` [m].
double EquilibriumSearch::longest_way(const Field& change) const {
  const Positions none(mesh_.nodes().size(), Vector3::Zero());
  double longest = 0;
  for (const Vector3& way : moved(none, change, 1))
    longest = std::max(longest, way.norm());
  return longest;
}

/// The mode that least resists in the tangent taken last, by inverse iteration; it moves
/// a node by a cell edge.
EquilibriumSearch::Field EquilibriumSearch::softest_mode() {
  std::mt19937_64 random(seed);
  const auto unknowns = static_cast<Index>(std::ranges::count(is_free_, true));
  Field mode = random_vector(unknowns, random);
  constexpr int iterations = 30;
  for (int i = 0; i < iterations; ++i) mode = solve(mode).normalized();
  return mode * (cell_edge_ / longest_way(mode));
}

/// Leaves a saddle along the softest mode, with the forces where they point along it and
/// are more than round-off, by steps that double while the forces push on. Returns
/// whether they do at all.
bool EquilibriumSearch::leave_saddle(const SoughtEquilibrium& sought, Positions& there,
                                     Field& residual) {
  Field mode = softest_mode();
  if (residual_ > relative_residual && residual.dot(mode) < 0) mode = -mode;
  bool left = false;
  for (double way = first_escape; way <= longest_move; way *= 2) {
    Positions further = moved(there, mode, way);
    if (!(on_free(forces(sought.dt, further, sought.load_fraction)).dot(mode) > 0)) break;
    there = std::move(further);
    left = true;
  }
  residual = on_free(forces(sought.dt, there, sought.load_fraction));
  return left;
}

/// Goes on from `there` by the change, or a part of it. Returns whether that leads nearer
/// to an equilibrium, that is, whether the residual falls. Where a body buckles the
/// residual has to rise on the way, in a valley that bends; there the forces must not
/// turn against the change. A residual that is not a number is not nearer.
bool EquilibriumSearch::step(const SoughtEquilibrium& sought, bool buckles, Field change,
                             Positions& there, Field& residual) {
  const double norm = residual.norm();
  if (buckles) change *= std::min(1., longest_move * cell_edge_ / longest_way(change));
  const double work = residual.dot(change);
  const Positions here = there;
  for (double factor = 1; factor >= shortest_factor; factor /= 2) {
    there = moved(here, change, factor);
    residual = on_free(forces(sought.dt, there, sought.load_fraction));
    if (buckles ? residual.dot(change) > -work / 2 : residual.norm() < norm) return true;
  }
  return false;
}

/// The largest change of the distance between two nodes of a cell, as a vector, over that
/// distance at rest: a measure of the displacement gradient between two states.
double EquilibriumSearch::largest_gradient(const Positions& from,
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

std::optional<FoundEquilibrium> EquilibriumSearch::find(const SoughtEquilibrium& sought) {
  jumped_ = false;
  const Positions start = predicted(sought);
  Positions there = start;
  Field residual = on_free(forces(sought.dt, there, sought.load_fraction));
  std::optional<FoundEquilibrium> saddle;
  int escapes = 0;
  bool crossed = false;
  for (int i = 0; i < most_iterations; ++i) {
    const double norm = residual.norm();
    residual_ = norm / force_scale_;
    if (!std::isfinite(norm)) break;
    const bool is_found = norm <= relative_residual * force_scale_;
    const bool is_definite = linearise(sought.dt, there);
    spdlog::debug("load {:.5f}, iteration {}: residual {:.2e}{}", sought.load_fraction, i,
                  residual_, is_definite ? "" : ", indefinite");
    crossed = crossed || !is_definite;
    if (is_found && is_definite) {
      jumped_ = (crossed && largest_gradient(start, there) > jump) ||
                !shows_imposed_turn(mesh_, scene_, there, sought.load_fraction);
      if (jumped_) return std::nullopt;
      return FoundEquilibrium{std::move(there), true, saddle.has_value()};
    }
    if (is_found && !saddle) saddle = {there, false, true};
    // Near a saddle the tangent, made definite, hardly moves along the unstable mode.
    const bool is_buckling = saddle || !sought.starts_definite;
    if (!is_definite && (is_found || (is_buckling && residual_ < near_saddle)) &&
        escapes++ < most_escapes && leave_saddle(sought, there, residual))
      continue;
    if (is_found ||
        !step(sought, is_buckling || !is_definite, solve(residual), there, residual))
      break;
  }
  if (!saddle) return std::nullopt;
  jumped_ = !shows_imposed_turn(mesh_, scene_, saddle->positions, sought.load_fraction);
  if (jumped_) return std::nullopt;
  return saddle;
}

}  // namespace springcheck::dynamics
