#include "mss/tissue/quasi_static.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "meshing/stopwatch.hpp"
#include "meshing/traction.hpp"
#include "mss/direct_solver.hpp"

namespace springcheck::mss {
namespace {

using Eigen::Index;
using Positions = std::vector<Vector3>;
using Field = Eigen::VectorXd;  // an entry per free component, ascending

constexpr double relative_residual = 1e-9;
constexpr int most_iterations = 40;
constexpr double shortest_factor = 1. / 256;  // of a Newton step
constexpr int most_halvings = 6;              // of a step of time

/// The cells as patches of a tangent, without anything that acts.
Network patches_of(const TissueBody& body) {
  Network network{.rest_positions = body.rest_positions,
                  .springs = {},
                  .cells = {},
                  .volume_modulus = 0,
                  .masses = body.masses};
  const std::vector<Vector3> no_gradients(8, Vector3::Zero());
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const double h = body.edges[c];
    network.cells.add(std::span(body.cells[c].begin(), body.cells[c].end()), no_gradients,
                      h * h * h, {});
  }
  return network;
}

class QuasiStatic {
 public:
  QuasiStatic(const Mesh& mesh, const Scene& scene, const TissueBody& body)
      : mesh_(mesh),
        scene_(scene),
        body_(body),
        prescribed_(prescribed_components(mesh, scene)),
        is_free_(free_components(mesh, prescribed_)),
        load_(traction_forces(mesh, scene)),
        solver_(patches_of(body), is_free_),
        positions_(mesh.nodes()),
        memories_(memories_at_rest(body)),
        stresses_(body.cells.size()),
        forces_(mesh.nodes().size()) {
    for (std::size_t n = 0; n < load_.size(); ++n)
      load_[n] += body.masses[n] * scene.gravity;
    tangent_.cells.resize(body.cells.size());
  }

  /// Goes on to a load fraction in a time dt [s]; whether there was an equilibrium.
  bool advance_to(double load_fraction, double dt) {
    const tissue::MemoryStep step = tissue::memory_step(body_.solid, dt);
    Positions there;
    if (!find(step, load_fraction, there)) return false;
    positions_ = std::move(there);
    advance(body_, step, memories_, positions_, stresses_);
    nodal_forces(body_, stresses_, positions_, forces_);
    load_fraction_ = load_fraction;
    ++steps_;
    return true;
  }

  [[nodiscard]] double residual() const { return residual_; }

  [[nodiscard]] dynamics::Moment moment(double time) const {
    dynamics::Moment moment{.time = time,
                            .load_fraction = load_fraction_,
                            .step = steps_,
                            .displacements = positions_,
                            .reactions = Positions(positions_.size(), Vector3::Zero()),
                            .kinetic_energy = 0,
                            .strain_energy = free_energy(body_, memories_, positions_)};
    for (std::size_t n = 0; n < positions_.size(); ++n)
      moment.displacements[n] -= mesh_.nodes()[n];
    for (const auto& [node, i, plate] : prescribed_)
      moment.reactions[node][i] = -(forces_[node][i] + load_fraction_ * load_[node][i]);
    return moment;
  }

  [[nodiscard]] Solution solution() const {
    const dynamics::Moment now = moment(0);
    return {.status = SolveStatus::ok,
            .reason = {},
            .displacements = now.displacements,
            .reactions = now.reactions,
            .lever_arms = LeverArms::deformed,
            .strain_energy = now.strain_energy,
            .load_fraction = load_fraction_,
            .steps = steps_,
            .force_evaluations = evaluations_,
            .factorisations = solver_.factorisations()};
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

  /// Forces on the nodes with the load [N]; scale_: what they are the sum of.
  std::vector<Vector3> forces(const tissue::MemoryStep& step, const Positions& x,
                              double load_fraction) {
    ++evaluations_;
    stresses_after(body_, step, memories_, x, stresses_);
    std::vector<Vector3> sum(x.size());
    nodal_forces(body_, stresses_, x, sum);
    double squares = 0;
    for (std::size_t c = 0; c < body_.cells.size(); ++c)
      squares += tissue_forces(positions_of(body_, c, x), body_.edges[c],
                               {stresses_[c].strands, 0})
                     .squaredNorm();
    scale_ = std::sqrt(squares);
    for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += load_fraction * load_[n];
    return sum;
  }

  /// The tangent at x, its symmetric part; the stresses there are known.
  void linearise(const tissue::MemoryStep& step, const Positions& x) {
    const std::size_t size = tissue::state_size(body_.solid.shear.branches.size());
    for (std::size_t c = 0; c < body_.cells.size(); ++c) {
      const HexahedronPositions at = positions_of(body_, c, x);
      const tissue::PointTangent tangent = tissue::tangent_after(
          body_.solid, step, std::span(memories_).subspan(c * size, size),
          right_cauchy_green(at, body_.edges[c]));
      const Matrix24 K = tissue_stiffness(at, body_.edges[c], stresses_[c], tangent);
      tangent_.cells[c] = (K + K.transpose()) / 2;
    }
    solver_.prepare(tangent_);
    if (!solver_.is_definite()) solver_.prepare_clamped(tangent_);
  }

  /// The tangent taken last times a displacement of the nodes.
  [[nodiscard]] std::vector<Vector3> product(const std::vector<Vector3>& way) const {
    std::vector<Vector3> result(way.size(), Vector3::Zero());
    for (std::size_t c = 0; c < body_.cells.size(); ++c) {
      const HexahedronPositions moves = positions_of(body_, c, way);
      const Eigen::Matrix<double, 24, 1> f =
          tangent_.cells[c] *
          Eigen::Map<const Eigen::Matrix<double, 24, 1>>(moves.data());
      for (std::size_t a = 0; a < 8; ++a)
        result[body_.cells[c][a]] += f.segment<3>(static_cast<Index>(3 * a));
    }
    return result;
  }

  /// An equilibrium at the end of the step, into `there`.
  bool find(const tissue::MemoryStep& step, double load_fraction, Positions& there) {
    std::vector<Vector3> way(positions_.size(), Vector3::Zero());
    for (const PrescribedComponent& component : prescribed_)
      way[component.node][component.component] =
          mesh_.nodes()[component.node][component.component] +
          prescribed_displacement(mesh_, scene_, component, load_fraction) -
          positions_[component.node][component.component];
    std::vector<Vector3> f = forces(step, positions_, load_fraction);
    linearise(step, positions_);
    const std::vector<Vector3> of_way = product(way);
    for (std::size_t n = 0; n < f.size(); ++n) f[n] -= of_way[n];
    there = moved(positions_, solver_.solve(on_free(f)).value(), 1);
    for (std::size_t n = 0; n < way.size(); ++n) there[n] += way[n];

    Field residual = on_free(forces(step, there, load_fraction));
    for (int i = 0; i < most_iterations; ++i) {
      const double norm = residual.norm();
      residual_ = norm / scale_;
      spdlog::debug("load {:.5f}, iteration {}: residual {:.2e}", load_fraction, i,
                    residual_);
      if (!std::isfinite(norm)) return false;
      if (norm <= relative_residual * scale_) return true;
      linearise(step, there);
      const Field change = solver_.solve(residual).value();
      const Positions here = there;
      // What is not a number is not nearer.
      for (double factor = 1;; factor /= 2) {
        there = moved(here, change, factor);
        residual = on_free(forces(step, there, load_fraction));
        if (residual.norm() < norm) break;
        if (factor < shortest_factor) return false;
      }
    }
    return false;
  }

  const Mesh& mesh_;
  const Scene& scene_;
  const TissueBody& body_;
  std::vector<PrescribedComponent> prescribed_;
  std::vector<bool> is_free_;
  std::vector<Vector3> load_;  // [N] at the full load
  DirectSolver solver_;
  Tangent tangent_;
  Positions positions_;
  std::vector<double> memories_;
  std::vector<tissue::PointStress> stresses_;
  std::vector<Vector3> forces_;  // of the last equilibrium, without the load
  double scale_ = 0, residual_ = 0, load_fraction_ = 0;
  int steps_ = 0, evaluations_ = 0;
};

}  // namespace

Solution find_quasi_static(const Mesh& mesh, const Scene& scene, const TissueBody& body,
                           const QuasiStaticSettings& settings,
                           const dynamics::Observers& observers) {
  assert(settings.duration > 0 && settings.steps > 0);
  const Stopwatch stopwatch;
  QuasiStatic path(mesh, scene, body);
  const double setup_wall_s = stopwatch.seconds();
  const auto parts_done = [&](double fraction) {
    return std::floor(fraction * observers.samples + 1e-9);
  };
  // In parts of a step, 2^-most_halvings of it, so that times are met to the bit.
  constexpr int parts = 1 << most_halvings;
  const std::int64_t end = std::int64_t{settings.steps} * parts;
  const auto fraction_at = [&](std::int64_t part) {
    return static_cast<double>(part) / static_cast<double>(end);
  };
  std::int64_t now = 0, length = parts;
  std::string reason;
  while (now < end) {
    const std::int64_t next = std::min(now + length, (now / parts + 1) * parts);
    const double from = fraction_at(now), to = fraction_at(next);
    if (!path.advance_to(to, (to - from) * settings.duration)) {
      length = (next - now) / 2;
      if (length > 0) continue;
      reason = fmt::format(
          "not converged beyond {:.2f} % of the load: the next {:.2g} s end with a "
          "relative residual of {:.1e}",
          100 * from, (to - from) * settings.duration, path.residual());
      break;
    }
    now = next;
    length = std::min<std::int64_t>(2 * length, parts);
    if (observers.sample && (now == end || parts_done(to) > parts_done(from)))
      observers.sample(path.moment(to * settings.duration));
  }
  Solution solution = path.solution();
  solution.setup_wall_s = setup_wall_s;
  if (!reason.empty()) {
    solution.status = SolveStatus::not_converged;
    solution.reason = reason;
  }
  return solution;
}

}  // namespace springcheck::mss
